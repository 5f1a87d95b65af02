using System;
using System.Buffers.Binary;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>Answers to targets to be validated: 10 bytes, little-endian, no padding. Stateless; any thread.</summary>
/// <remarks>
/// Session (2 bytes), number (2), award (2), state (1), result (1), seconds (2; 65535 for that and more).
/// </remarks>
public sealed class ValidationBidCodec : IVehicleMessageCodec<ValidationBid>
{
    private const int Length = 10;

    /// <summary>4.</summary>
    public int MessageType => 4;

    /// <inheritdoc/>
    public int Version => 1;

    /// <inheritdoc/>
    public bool TryEncode(in ValidationBid content, TimeSpan now, Span<byte> destination, out int length)
    {
        length = 0;
        if (destination.Length < Length || !IsValid(content))
            return false;
        BinaryPrimitives.WriteUInt16LittleEndian(destination, content.Session);
        BinaryPrimitives.WriteUInt16LittleEndian(destination.Slice(2), content.Number);
        BinaryPrimitives.WriteUInt16LittleEndian(destination.Slice(4), content.Award);
        destination[6] = (byte)content.State;
        destination[7] = (byte)content.Result;
        BinaryPrimitives.WriteUInt16LittleEndian(
            destination.Slice(8), (ushort)Math.Min(ushort.MaxValue, Math.Round(content.Seconds)));
        length = Length;
        return true;
    }

    /// <inheritdoc/>
    public bool TryDecode(
        ReadOnlySpan<byte> bytes, int version, TimeSpan sentTime, byte sourceSystemId, out ValidationBid content)
    {
        content = default;
        if (version != Version || bytes.Length != Length)
            return false;
        var bid = new ValidationBid
        {
            Session = BinaryPrimitives.ReadUInt16LittleEndian(bytes),
            Number = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(2)),
            Award = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(4)),
            State = (ValidationBidState)bytes[6],
            Result = (ValidationResult)bytes[7],
            Seconds = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(8)),
        };
        if (!IsValid(bid))
            return false;
        content = bid;
        return true;
    }

    private static bool IsValid(in ValidationBid bid)
        => bid.State is >= ValidationBidState.Offered and <= ValidationBidState.Finished
            && bid.Result is >= ValidationResult.Unknown and <= ValidationResult.Rejected
            && bid.Seconds >= 0;
}
