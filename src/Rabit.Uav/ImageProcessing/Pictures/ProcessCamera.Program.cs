using System;
using System.IO;
using System.Threading;
using Rabit.Core;

namespace Rabit.Uav.ImageProcessing;

// How the program is started, watched, ended, and started again.
public sealed partial class ProcessCamera
{
    private void Start()
    {
        _stream.Clear();
        _journal.Begin();
        (_isStalled, _hasBytes, _end) = (false, false, null);
        Volatile.Write(ref _process, new ChildProcess(
            _options.Program,
            _times?.Open() ?? _options.Arguments,
            line => _lines.Add($"{_options.Program}: {line}", _context!.Now)));
        _stall = _context!.Clock.CreateTimer(
            _ => OnStall(), null, _options.StallTimeout, Timeout.InfiniteTimeSpan);

        // Unblock may have looked before there was a process.
        if (_isStopping)
            _process!.Kill();
    }

    private void RestartStallTimer()
    {
        _hasBytes = false;
        _stall!.Change(_options.StallTimeout, Timeout.InfiniteTimeSpan);
    }

    private void OnStall()
    {
        _isStalled = true;
        Volatile.Read(ref _process)?.Kill();
    }

    // Without a program.
    private bool IsToWait(out ReaderStep wait)
    {
        wait = ReaderStep.WaitUntil(TimeSpan.MaxValue);
        if (_context!.IsStopRequested)
            return true;
        if (_end is { } end && _context.Now >= _endIsFaultAt)
            Fail(end, "it is started again");
        wait = ReaderStep.WaitUntil(_end is null ? _delay.Due : _endIsFaultAt);
        return _end is not null || !TryRestart();
    }

    private bool TryRestart()
    {
        if (_context!.Now < _delay.Due)
            return false;
        _journal.Restart();
        return TryStart();
    }

    private bool TryStart()
    {
        try
        {
            Start();
            return true;
        }
        catch (IOException e)
        {
            Fail(e.Message, "it is tried again");
            return false;
        }
    }

    private void Fail(string reason, string next)
    {
        End();
        _end = null;
        string fault = _journal.Fail(reason);
        TimeSpan delay = _delay.Begin(_context!.Now);
        Log(FormattableString.Invariant($"{fault}; {next} in {delay.ExactSeconds} s"));
    }

    private void Log(string line)
    {
        _options.Log?.Invoke(line);
        _journal.WriteLine(line);
    }

    private void End()
    {
        _stall?.Dispose();
        _stall = null;
        _process?.Dispose();
        Volatile.Write(ref _process, null);
        _times?.Dispose();
    }
}
