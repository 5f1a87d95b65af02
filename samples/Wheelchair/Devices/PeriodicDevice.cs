using System;
using Rabit.Core;

namespace Wheelchair.Devices;

/// <summary>
/// A simulated device that has something to read every 50 ms. It never blocks and says when to ask again instead, so
/// that it runs in virtual time as well as in real time.
/// </summary>
internal abstract class PeriodicDevice<T> : IReaderSource<T>
{
    private static readonly TimeSpan Interval = TimeSpan.FromMilliseconds(50);
    private ReaderContext? _context;
    private TimeSpan _due;

    public bool Blocks => false;

    public void Open(ReaderContext context) => _context = context;

    public ReaderStep Read(out T value)
    {
        TimeSpan now = _context!.Now;
        value = default!;
        if (now < _due)
            return ReaderStep.WaitUntil(_due);
        _due += Interval;
        return Measure(now, out value);
    }

    public void Unblock()
    {
    }

    public void Close()
    {
    }

    protected abstract ReaderStep Measure(TimeSpan now, out T value);
}
