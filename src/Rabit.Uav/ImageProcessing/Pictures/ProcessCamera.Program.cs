using System;
using System.IO;
using System.Threading;

namespace Rabit.Uav.ImageProcessing;

// How the program is started, watched, ended, and started again.
public sealed partial class ProcessCamera
{
    private void Start()
    {
        _stream.Clear();
        _isStalled = false;
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

    private void OnStall()
    {
        _isStalled = true;
        Volatile.Read(ref _process)?.Kill();
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
        string fault = _journal.Fail(reason);
        TimeSpan delay = _delay.Begin(_context!.Now);
        Log(FormattableString.Invariant($"{fault}; {next} in {delay.TotalSeconds} s"));
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
