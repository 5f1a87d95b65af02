using System;
using System.Threading;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation.Tests.Camera;

/// <summary>
/// Around the companion's end of the link: what the gimbal reports comes without the flags that say against what its
/// angles are, so that they seem to be against the body.
/// </summary>
internal sealed class GimbalFlagFilter(IByteLink link) : WrappedLink(link)
{
    private readonly MavlinkFrameReader _reader = new(MavlinkDialect.All);

    /// <summary>How many reports came.</summary>
    public int Reports { get; private set; }

    public override LinkRead Read(byte[] buffer, int timeoutMilliseconds = Timeout.Infinite)
    {
        LinkRead read = Inner.Read(buffer, timeoutMilliseconds);
        if (read.Kind is LinkReadKind.NothingYet or LinkReadKind.Ended)
            return read;
        var bytes = new ReadOnlySpan<byte>(buffer, 0, read.Count);
        byte[] changed = new byte[MavlinkFrame.MaxWireLength];
        while (bytes.Length > 0)
        {
            int start = read.Count - bytes.Length;
            if (!_reader.TryRead(ref bytes, out MavlinkFrame frame, out _))
                break;
            if (!frame.TryDecode(out GimbalDeviceAttitudeStatus status))
                continue;
            Reports++;
            status.Flags = GimbalDeviceFlags.YawInVehicleFrame;
            int length = MavlinkFrame.Create(status, frame.SystemId, frame.ComponentId, frame.Sequence)
                .WriteTo(changed);
            Assert(length == read.Count - bytes.Length - start);
            Buffer.BlockCopy(changed, 0, buffer, start, length);
        }

        return read;
    }

    // A frame has its length whatever its flags are, as long as it arrives in one piece.
    private static void Assert(bool isSame)
    {
        if (!isSame)
            throw new InvalidOperationException("A report of the gimbal was cut.");
    }
}
