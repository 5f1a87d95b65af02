using Rabit.Core;
using Rabit.Links;
using Rabit.Mavlink;

namespace Rabit.Uav.Communications;

/// <summary>
/// Sends frames one by one over a link, in their order: on the manager's thread where the link takes them without a
/// wait, which saves the wake-up of another thread for each, else by the link's writer. Allocates nothing for a frame.
/// The manager's thread.
/// </summary>
internal sealed class LinkOutput(BlockingWriter<FrameToWrite> writer, LinkFrameTarget target, IByteLink link)
{
    private readonly INonBlockingWriter? _direct = link as INonBlockingWriter;
    private readonly byte[] _buffer = new byte[MavlinkFrame.MaxWireLength];
    private long _pushed;

    /// <returns>Whether it is on its way.</returns>
    public bool Send(in MavlinkFrame frame)
    {
        if (_direct is not null && IsWriterIdle && _direct.TryWrite(_buffer, 0, frame.WriteTo(_buffer)))
            return true;
        if (writer.Push(new FrameToWrite { Frame = frame }) == PushResult.Rejected)
            return false;
        _pushed++;
        return true;
    }

    // A frame that the writer still has must go out first.
    private bool IsWriterIdle => _pushed == target.Done || _pushed == target.Done + writer.Counters.Dropped;
}
