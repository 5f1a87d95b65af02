using System;
using System.Buffers.Binary;
using System.Collections.Immutable;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>
/// Divisions of the lanes of a group: 7 bytes and 5 for each share, little-endian, no padding. Stateless; any thread.
/// </summary>
/// <remarks>
/// Key of the lanes (4 bytes), number (2), count of the shares (1, 1 to 16); of each share system id (1), first lane
/// (2) and count (2). No system id twice.
/// </remarks>
public sealed class LaneDivisionCodec : IVehicleMessageCodec<LaneDivision>
{
    private const int HeaderLength = 7;
    private const int ShareLength = 5;

    /// <summary>5.</summary>
    public int MessageType => 5;

    /// <inheritdoc/>
    public int Version => 1;

    /// <inheritdoc/>
    public bool TryEncode(in LaneDivision content, TimeSpan now, Span<byte> destination, out int length)
    {
        length = 0;
        ImmutableArray<LaneShare> shares = content.Shares;
        int needed = HeaderLength + (ShareLength * shares.Length);
        if (destination.Length < needed || !AreValid(shares))
            return false;
        BinaryPrimitives.WriteUInt32LittleEndian(destination, content.LanesKey);
        BinaryPrimitives.WriteUInt16LittleEndian(destination.Slice(4), content.Number);
        destination[6] = (byte)shares.Length;
        for (int i = 0; i < shares.Length; i++)
        {
            Span<byte> share = destination.Slice(HeaderLength + (i * ShareLength));
            share[0] = shares[i].SystemId;
            BinaryPrimitives.WriteUInt16LittleEndian(share.Slice(1), (ushort)shares[i].First);
            BinaryPrimitives.WriteUInt16LittleEndian(share.Slice(3), (ushort)shares[i].Count);
        }

        length = needed;
        return true;
    }

    /// <inheritdoc/>
    public bool TryDecode(
        ReadOnlySpan<byte> bytes, int version, TimeSpan sentTime, byte sourceSystemId, out LaneDivision content)
    {
        content = default;
        if (bytes.Length < HeaderLength || version != Version
            || bytes.Length != HeaderLength + (ShareLength * bytes[6]))
            return false;
        ImmutableArray<LaneShare>.Builder shares = ImmutableArray.CreateBuilder<LaneShare>(bytes[6]);
        for (int at = HeaderLength; at < bytes.Length; at += ShareLength)
        {
            ReadOnlySpan<byte> share = bytes.Slice(at);
            shares.Add(new LaneShare(
                share[0], BinaryPrimitives.ReadUInt16LittleEndian(share.Slice(1)),
                BinaryPrimitives.ReadUInt16LittleEndian(share.Slice(3))));
        }

        ImmutableArray<LaneShare> all = shares.MoveToImmutable();
        if (!AreValid(all))
            return false;
        content = new LaneDivision
        {
            LanesKey = BinaryPrimitives.ReadUInt32LittleEndian(bytes),
            Number = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(4)),
            Shares = all,
        };
        return true;
    }

    private static bool AreValid(ImmutableArray<LaneShare> shares)
    {
        if (shares.Length is 0 or > LaneDivision.MaxShares)
            return false;
        for (int i = 0; i < shares.Length; i++)
        {
            LaneShare share = shares[i];
            if (share.SystemId == 0 || share.First is < 0 or > ushort.MaxValue
                || share.Count is < 0 or > ushort.MaxValue)
                return false;
            for (int other = 0; other < i; other++)
            {
                if (shares[other].SystemId == share.SystemId)
                    return false;
            }
        }

        return true;
    }
}
