using System;

namespace Rabit.Mavlink;

public unsafe partial struct MavlinkFrame
{
    /// <summary>
    /// The payload as it is on the wire, without the zeros that the sender truncated: <see cref="PayloadLength"/>
    /// bytes. On .NET it refers into the frame, and the compiler does not let it outlive the frame; on .NET Framework
    /// and Mono, whose spans cannot do that, it is a new copy. <see cref="CopyPayloadTo"/> allocates on neither.
    /// </summary>
    public readonly ReadOnlySpan<byte> Payload
    {
        get
        {
            var copy = new byte[PayloadLength];
            CopyPayloadTo(copy);
            return copy;
        }
    }
}
