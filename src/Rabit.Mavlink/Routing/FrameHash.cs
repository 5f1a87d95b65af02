using System;
using System.Buffers.Binary;

namespace Rabit.Mavlink.Routing;

/// <summary>
/// A hash of 64 bits of a frame's header, payload and checksum. The mixing step is that of MurmurHash3's 64-bit
/// finalizer (Appleby, public domain).
/// </summary>
internal static class FrameHash
{
    public static ulong Of(in MavlinkFrame frame)
    {
        Span<byte> payload = stackalloc byte[MavlinkFrame.MaxPayloadLength + sizeof(ulong)];
        int length = frame.CopyPayloadTo(payload);
        payload.Slice(length, sizeof(ulong)).Clear();

        ulong header = (ulong)(byte)frame.Version
            | ((ulong)frame.Sequence << 8)
            | ((ulong)frame.SystemId << 16)
            | ((ulong)frame.ComponentId << 24)
            | ((ulong)(uint)frame.MessageId << 32)
            | ((ulong)(byte)length << 56);
        ulong hash = Mix(header);
        hash = Mix(hash ^ frame.Checksum);
        for (int at = 0; at < length; at += sizeof(ulong))
            hash = Mix(hash ^ BinaryPrimitives.ReadUInt64LittleEndian(payload.Slice(at)));
        return hash;
    }

    private static ulong Mix(ulong value)
    {
        unchecked
        {
            value += 0x9E3779B97F4A7C15;
            value = (value ^ (value >> 33)) * 0xFF51AFD7ED558CCD;
            value = (value ^ (value >> 33)) * 0xC4CEB9FE1A85EC53;
            return value ^ (value >> 33);
        }
    }
}
