using System;
using System.Threading;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// What became of the pictures of a camera that is opened again after faults, and what is wrong with it. Written by the
/// thread of the camera, read by any.
/// </summary>
internal sealed class CameraJournal(string camera)
{
    // All written by the thread of the camera, but the log.
    private long _delivered;
    private long _refused;
    private long _skipped;
    private long _withoutBuffer;
    private long _withoutTime;
    private long _restarts;
    private string? _fault;
    private string? _lastFault;
    private string? _timeSource;
    private TimeSpan? _refusedSince;   // null after a picture that was good; of the thread of the camera alone
    private Action<string>? _log;      // set by any thread

    public CameraStatistics Statistics => new()
    {
        Delivered = Interlocked.Read(ref _delivered),
        Refused = Interlocked.Read(ref _refused),
        Skipped = Interlocked.Read(ref _skipped),
        WithoutBuffer = Interlocked.Read(ref _withoutBuffer),
        WithoutTime = Interlocked.Read(ref _withoutTime),
        TimeSource = Volatile.Read(ref _timeSource),
        Restarts = Interlocked.Read(ref _restarts),
        Fault = Volatile.Read(ref _fault),
        LastFault = Volatile.Read(ref _lastFault),
    };

    public void LogTo(Action<string>? log) => Volatile.Write(ref _log, log);

    /// <summary>Writes a line, with the name of the camera in front.</summary>
    public void Log(string text) => WriteLine($"{camera}: {text}");

    /// <summary>Writes a line as it is.</summary>
    public void WriteLine(string line) => Volatile.Read(ref _log)?.Invoke(line);

    /// <summary>The camera was opened, or opened again: what was wrong with earlier pictures is over.</summary>
    public void Begin() => _refusedSince = null;

    /// <summary>A picture was delivered: nothing keeps the camera from giving pictures.</summary>
    /// <param name="timeSource">Where its time comes from, with its error.</param>
    public void Deliver(string timeSource)
    {
        Volatile.Write(ref _timeSource, timeSource);
        _refusedSince = null;
        Interlocked.Increment(ref _delivered);
        Volatile.Write(ref _fault, null);
    }

    public void Skip() => Interlocked.Increment(ref _skipped);

    public void MissBuffer() => Interlocked.Increment(ref _withoutBuffer);

    /// <summary>A picture's time is not known but by its arrival.</summary>
    public void MissTime() => Interlocked.Increment(ref _withoutTime);

    public void Restart() => Interlocked.Increment(ref _restarts);

    /// <summary>A picture cannot be used.</summary>
    /// <returns>The line for the log; null where it is the same as for the last fault.</returns>
    public string? Refuse(string reason)
    {
        Interlocked.Increment(ref _refused);
        string? last = Volatile.Read(ref _lastFault);
        string fault = Fail(reason);
        return string.Equals(fault, last, StringComparison.Ordinal) ? null : fault;
    }

    /// <summary>
    /// A picture that arrived cannot be used: a camera that hangs may go on to give pictures, none of them good. Those
    /// that are left out are not looked at, and do not count.
    /// </summary>
    /// <param name="reason">What is wrong with this one.</param>
    /// <param name="now">When it arrived.</param>
    /// <param name="timeout">For how long it may go on.</param>
    /// <returns>The fault that this is; null while it has not lasted for longer than that.</returns>
    public string? FindOnlyRefused(string reason, TimeSpan now, TimeSpan timeout)
    {
        _refusedSince ??= now;
        return now - _refusedSince <= timeout
            ? null
            : FormattableString.Invariant(
                $"it gave only pictures that cannot be used for {timeout.ExactSeconds} s ({reason})");
    }

    /// <summary>Something keeps the camera from giving pictures.</summary>
    /// <returns>The line for the log.</returns>
    public string Fail(string reason)
    {
        string fault = $"{camera}: {reason}";
        Volatile.Write(ref _fault, fault);
        Volatile.Write(ref _lastFault, fault);
        return fault;
    }
}
