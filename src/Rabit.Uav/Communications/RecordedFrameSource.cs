using System;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Uav.Links;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>
/// Plays a recorded log: each record comes when its stamp is due, counted from the start of the earliest log that is played, so that
/// several logs merge by their stamps. It never blocks: real time waits for the due time, virtual time jumps to it.
/// </summary>
internal sealed class RecordedFrameSource(RecordedFile file, int number, long originUtcMicroseconds, FrameTally tally) : IReaderSource<LinkFrame>
{
    private const long TicksPerMicrosecond = TimeSpan.TicksPerMillisecond / 1000;

    private ReaderContext? _context;
    private TimeSpan _start;
    private LinkFrame _next;
    private bool _isChecked;
    private bool _holdsNext;

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
        tally.Count(value.Frame, _isChecked);
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
            Time = _start + new TimeSpan((record.TimeMicroseconds - originUtcMicroseconds) * TicksPerMicrosecond),
            UtcMicroseconds = record.TimeMicroseconds,
        };
        _isChecked = record.IsChecked;
        _holdsNext = true;
        return true;
    }
}
