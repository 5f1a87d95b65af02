using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Mavlink.Tests.Framing;

/// <summary>Frames as bytes, also such as no correct sender would send.</summary>
internal static class Wire
{
    /// <summary>An id that no dialect knows.</summary>
    public const int UnknownId = 0x00ABCDEF;

    public static byte[] Bytes(in MavlinkFrame frame)
    {
        var bytes = new byte[frame.WireLength];
        frame.WriteTo(bytes);
        return bytes;
    }

    public static byte[] Of<T>(T message, byte sequence = 0, MavlinkVersion version = MavlinkVersion.V2)
        where T : struct, IMavlinkMessage => Bytes(MavlinkFrame.Create(message, 1, 1, sequence, version));

    /// <summary>A MAVLink 2 frame of any id, flags and payload. A signed flag gets 13 bytes of 0x5A.</summary>
    public static byte[] V2(
        int messageId, byte[] payload, byte crcExtra = 0, byte incompatibilityFlags = 0, byte sequence = 0)
    {
        var bytes = new List<byte>
        {
            0xFD, (byte)payload.Length, incompatibilityFlags, 0, sequence, 1, 1, (byte)messageId,
            (byte)(messageId >> 8), (byte)(messageId >> 16),
        };
        bytes.AddRange(payload);
        ushort crc = MavlinkCrc.Add(MavlinkCrc.Add(MavlinkCrc.Initial, bytes.Skip(1).ToArray()), crcExtra);
        bytes.Add((byte)crc);
        bytes.Add((byte)(crc >> 8));
        if ((incompatibilityFlags & 1) != 0)
            bytes.AddRange(Enumerable.Repeat((byte)0x5A, MavlinkFrame.SignatureLength));
        return bytes.ToArray();
    }

    public static byte[] Join(params byte[][] parts) => parts.SelectMany(part => part).ToArray();

    /// <summary>What the dialect says of a message.</summary>
    public static MavlinkMessageInfo Info<T>()
        where T : struct, IMavlinkMessage =>
        MavlinkDialect.All.TryGetMessage(default(T).MessageId, out MavlinkMessageInfo info)
            ? info
            : throw new InvalidOperationException(typeof(T).Name);

    /// <summary>Reads the one frame that the bytes are.</summary>
    public static MavlinkFrame Single(byte[] bytes, out MavlinkFrameInfo info)
    {
        var reader = new MavlinkFrameReader(MavlinkDialect.All);
        List<FoundFrame> found = FrameCollector.Read(bytes, bytes.Length, reader);
        if (found.Count != 1)
            throw new InvalidOperationException($"{found.Count} frames instead of one");
        info = found[0].Info;
        return found[0].Frame;
    }
}
