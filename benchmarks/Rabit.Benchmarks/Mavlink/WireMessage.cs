using System;
using Rabit.Mavlink;

namespace Rabit.Benchmarks.Mavlink;

/// <summary>A message and its MAVLink 2 frame as bytes.</summary>
internal sealed class WireMessage<T>
    where T : struct, IMavlinkMessage
{
    private readonly MavlinkFrameReader _reader = new(MavlinkDialect.All);
    private readonly byte[] _wire;
    private readonly byte[] _buffer = new byte[MavlinkFrame.MaxWireLength];
    private readonly T _message;
    private byte _sequence;

    public WireMessage(in T message)
    {
        _message = message;
        MavlinkFrame frame = MavlinkFrame.Create(message, systemId: 1, componentId: 1, sequence: 0);
        _wire = new byte[frame.WireLength];
        frame.WriteTo(_wire);
        if (!Decode(out _))
            throw new InvalidOperationException("The frame that was made cannot be read.");
    }

    /// <summary>Bytes to frame, checksum checked, to message.</summary>
    public bool Decode(out T message)
    {
        ReadOnlySpan<byte> bytes = _wire;
        message = default;
        return _reader.TryRead(ref bytes, out MavlinkFrame frame, out _) && frame.TryDecode(out message);
    }

    /// <summary>Message to frame, checksum made, to bytes.</summary>
    public int Encode()
    {
        MavlinkFrame frame = MavlinkFrame.Create(_message, systemId: 1, componentId: 1, _sequence++);
        return frame.WriteTo(_buffer);
    }
}
