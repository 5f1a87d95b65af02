using System;
using System.Buffers.Binary;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>Answers to targets to be followed: 10 bytes, little-endian, no padding. Stateless; any thread.</summary>
/// <remarks>
/// Finder (1 byte), whether it is offered (1), session (2), number (2), decision (2), seconds (2; 65535 for that and
/// more).
/// </remarks>
public sealed class FollowBidCodec : IVehicleMessageCodec<FollowBid>
{
    private const int Length = 10;

    /// <summary>11.</summary>
    public int MessageType => 11;

    /// <inheritdoc/>
    public int Version => 1;

    /// <inheritdoc/>
    public bool TryEncode(in FollowBid content, TimeSpan now, Span<byte> destination, out int length)
    {
        length = 0;
        if (destination.Length < Length || !IsValid(content))
            return false;
        destination[0] = content.Finder;
        destination[1] = content.IsOffered ? (byte)1 : (byte)0;
        BinaryPrimitives.WriteUInt16LittleEndian(destination.Slice(2), content.Session);
        BinaryPrimitives.WriteUInt16LittleEndian(destination.Slice(4), content.Number);
        BinaryPrimitives.WriteUInt16LittleEndian(destination.Slice(6), content.Decision);
        BinaryPrimitives.WriteUInt16LittleEndian(
            destination.Slice(8), (ushort)Math.Min(ushort.MaxValue, Math.Round(content.Seconds)));
        length = Length;
        return true;
    }

    /// <inheritdoc/>
    public bool TryDecode(
        ReadOnlySpan<byte> bytes, int version, TimeSpan sentTime, byte sourceSystemId, out FollowBid content)
    {
        content = default;
        if (version != Version || bytes.Length != Length || bytes[1] > 1)
            return false;
        var bid = new FollowBid
        {
            Finder = bytes[0],
            IsOffered = bytes[1] == 1,
            Session = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(2)),
            Number = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(4)),
            Decision = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(6)),
            Seconds = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(8)),
        };
        if (!IsValid(bid))
            return false;
        content = bid;
        return true;
    }

    private static bool IsValid(in FollowBid bid) => bid.Finder != 0 && bid.Decision != 0 && bid.Seconds >= 0;
}
