using System;
using System.Buffers.Binary;

namespace Rabit.Mavlink.Signing;

/// <summary>
/// The 13 bytes behind the checksum of a signed frame (MAVLink guide, "Message signing"): link id, time stamp of 48
/// bits, and the first 48 bits of SHA-256 over key, header, payload, checksum, link id and time stamp. Little endian.
/// </summary>
internal static class SignatureFormat
{
    public const int LinkIdLength = 1;
    public const int TimestampLength = 6;
    public const int HashLength = 6;

    /// <summary>The largest time stamp: in the year 2104.</summary>
    public const long MaxTimestamp = (1L << (8 * TimestampLength)) - 1;

    private const int HashOffset = LinkIdLength + TimestampLength;

    public static long ReadTimestamp(ReadOnlySpan<byte> signature) =>
        BinaryPrimitives.ReadUInt32LittleEndian(signature.Slice(LinkIdLength))
            | ((long)BinaryPrimitives.ReadUInt16LittleEndian(signature.Slice(LinkIdLength + 4)) << 32);

    public static void WriteLinkAndTimestamp(Span<byte> signature, byte linkId, long timestamp)
    {
        signature[0] = linkId;
        BinaryPrimitives.WriteUInt32LittleEndian(signature.Slice(LinkIdLength), (uint)timestamp);
        BinaryPrimitives.WriteUInt16LittleEndian(signature.Slice(LinkIdLength + 4), (ushort)(timestamp >> 32));
    }

    /// <summary>
    /// The truncated hash as one number, so that two are compared in one step, which takes the same time wherever they
    /// differ.
    /// </summary>
    public static ulong ReadHash(ReadOnlySpan<byte> signature) =>
        BinaryPrimitives.ReadUInt32LittleEndian(signature.Slice(HashOffset))
            | ((ulong)BinaryPrimitives.ReadUInt16LittleEndian(signature.Slice(HashOffset + 4)) << 32);

    public static void WriteHash(Span<byte> signature, ulong hash)
    {
        BinaryPrimitives.WriteUInt32LittleEndian(signature.Slice(HashOffset), (uint)hash);
        BinaryPrimitives.WriteUInt16LittleEndian(signature.Slice(HashOffset + 4), (ushort)(hash >> 32));
    }
}
