using System;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>
/// Plays a recorded log: each record comes when its stamp is due, counted from the start of the earliest log that is
/// played, so that several logs merge by their stamps. Where the stamps step, because the recorder's clock was set, it
/// goes on from there at their pace: else all that follows would come at once, or after the years since 1970. It never
/// blocks: real time waits for the due time, virtual time jumps to it.
/// </summary>
internal sealed class RecordedFrameSource(
    RecordedFile file, int number, long originUtcMicroseconds, FrameStatistics tally)
    : IReaderSource<LinkFrame>
{
    private const long TicksPerMicrosecond = TimeSpan.TicksPerMillisecond / 1000;

    // Records of several senders may lie a little out of order; a clock that was set has moved by more.
    private const long StepBackMicroseconds = 1_000_000;

    // A recorder may pause; one that was silent for longer had its clock set, as a computer without one does at its
    // first fix.
    private const long StepForwardMicroseconds = 3_600_000_000;

    private ReaderContext? _context;
    private TimeSpan _start;
    private LinkFrame _next;
    private long _lastMicroseconds;
    private long _shiftMicroseconds;
    private bool _holdsNext;
    private bool _hasBegun;

    public bool Blocks => false;

    public void Open(ReaderContext context)
    {
        _context = context;
        _start = context.Now;
    }

    public ReaderStep Read(out LinkFrame value)
    {
        value = default;
        if (!_holdsNext && !TryTakeRecord())
            return ReaderStep.Ended;
        if (_next.Time > _context!.Now)
            return ReaderStep.WaitUntil(_next.Time);

        value = _next;
        _holdsNext = false;
        tally.Count(value.Frame, value.IsChecked);
        return ReaderStep.Value;
    }

    public void Unblock()
    {
    }

    public void Close()
    {
    }

    private bool TryTakeRecord()
    {
        if (!file.TryRead(out MavlinkFrame frame, out TlogRecord record))
            return false;
        _next = new LinkFrame
        {
            Frame = frame,
            Link = number,
            Index = record.Index,
            Time = _start + new TimeSpan(SinceStart(record.TimeMicroseconds) * TicksPerMicrosecond),
            UtcMicroseconds = record.TimeMicroseconds,
        };
        _next.SetAddress(record.IsChecked, record.Message);
        _holdsNext = true;
        return true;
    }

    private long SinceStart(long utcMicroseconds)
    {
        long since = utcMicroseconds - originUtcMicroseconds + _shiftMicroseconds;
        bool isStep = _hasBegun
            && (since < _lastMicroseconds - StepBackMicroseconds
                || since > _lastMicroseconds + StepForwardMicroseconds);
        if (isStep)
        {
            _shiftMicroseconds += _lastMicroseconds - since;
            since = _lastMicroseconds;
        }

        _hasBegun = true;
        _lastMicroseconds = Math.Max(_lastMicroseconds, since);
        return since;
    }
}
