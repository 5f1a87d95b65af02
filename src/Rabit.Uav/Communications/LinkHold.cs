using System;
using Rabit.Core;
using Rabit.Mavlink;

namespace Rabit.Uav.Communications;

/// <summary>
/// Frames that wait a moment for others, to go out with them in one write. Allocates nothing after it was made. One
/// thread.
/// </summary>
internal sealed class LinkHold(BlockingWriter<FrameToWrite> writer, TimeSpan time)
{
    // As many of the shortest useful ones as fit.
    private readonly MavlinkFrame[] _frames = new MavlinkFrame[LinkFrameTarget.MaxWriteBytes / 20];
    private int _count;
    private int _bytes;

    /// <summary>When what waits is to go out; the longest time where nothing does.</summary>
    public TimeSpan Due { get; private set; } = TimeSpan.MaxValue;

    public void Add(in MavlinkFrame frame, TimeSpan now)
    {
        if (_count == _frames.Length || _bytes + frame.WireLength > LinkFrameTarget.MaxWriteBytes)
            Flush();
        if (_count == 0)
            Due = now + time;
        _frames[_count++] = frame;
        _bytes += frame.WireLength;
        if (SendClasses.Of(frame) is SendClass.Urgent or SendClass.Commands)
            Flush();
    }

    /// <summary>Lets go what waits; the writer counts what it has no room for.</summary>
    public void Flush()
    {
        for (int i = 0; i < _count; i++)
            _ = writer.Push(new FrameToWrite { Frame = _frames[i], HasMore = i < _count - 1 });
        (_count, _bytes, Due) = (0, 0, TimeSpan.MaxValue);
    }
}
