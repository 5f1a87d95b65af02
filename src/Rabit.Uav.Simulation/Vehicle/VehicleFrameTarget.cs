using System.Threading;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Links;

namespace Rabit.Uav.Simulation;

/// <summary>Writes the vehicle's frames to its link. Runs on the writer's thread.</summary>
internal sealed class VehicleFrameTarget(IByteLink link) : IWriterTarget<MavlinkFrame>
{
    private readonly byte[] _buffer = new byte[MavlinkFrame.MaxWireLength];
    private long _lost;

    public bool Blocks => link.Blocks;

    /// <summary>Frames that the link could not take. Any thread.</summary>
    public long Lost => Interlocked.Read(ref _lost);

    public void Open()
    {
    }

    public void Write(in MavlinkFrame value)
    {
        long dropped = link.Counters.WritesDropped;
        try
        {
            link.Write(_buffer, 0, value.WriteTo(_buffer));
        }
        catch (LinkException e) when (!e.LinkEnded)
        {
            // A ground station that is not up yet, or a way out that is full: the next one may get through.
            Interlocked.Increment(ref _lost);
            return;
        }

        if (link.Counters.WritesDropped != dropped)
            Interlocked.Increment(ref _lost);
    }

    public void Unblock() => link.Unblock();

    public void Close()
    {
    }
}
