using System;
using System.Buffers.Binary;
using System.Collections.Immutable;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>
/// What was seen of the lanes of a group: 6 bytes and 2 for each lane, little-endian, no padding. Stateless; any
/// thread.
/// </summary>
/// <remarks>Key of the lanes (4 bytes), first lane (2), then for each lane, 1 to 64 of them, its parts (2).</remarks>
public sealed class LaneCoverageCodec : IVehicleMessageCodec<LaneCoverage>
{
    private const int HeaderLength = 6;

    /// <summary>6.</summary>
    public int MessageType => 6;

    /// <inheritdoc/>
    public int Version => 1;

    /// <inheritdoc/>
    public bool TryEncode(in LaneCoverage content, TimeSpan now, Span<byte> destination, out int length)
    {
        length = 0;
        ImmutableArray<ushort> parts = content.Parts;
        int needed = HeaderLength + (sizeof(ushort) * parts.Length);
        if (destination.Length < needed || parts.Length is 0 or > LaneCoverage.MaxLanes
            || content.FirstLane is < 0 or > ushort.MaxValue)
            return false;
        BinaryPrimitives.WriteUInt32LittleEndian(destination, content.LanesKey);
        BinaryPrimitives.WriteUInt16LittleEndian(destination.Slice(4), (ushort)content.FirstLane);
        for (int i = 0; i < parts.Length; i++)
        {
            BinaryPrimitives.WriteUInt16LittleEndian(
                destination.Slice(HeaderLength + (i * sizeof(ushort))), parts[i]);
        }

        length = needed;
        return true;
    }

    /// <inheritdoc/>
    public bool TryDecode(
        ReadOnlySpan<byte> bytes, int version, TimeSpan sentTime, byte sourceSystemId, out LaneCoverage content)
    {
        content = default;
        int lanes = (bytes.Length - HeaderLength) / sizeof(ushort);
        if (version != Version || lanes is < 1 or > LaneCoverage.MaxLanes
            || bytes.Length != HeaderLength + (sizeof(ushort) * lanes))
            return false;
        ImmutableArray<ushort>.Builder parts = ImmutableArray.CreateBuilder<ushort>(lanes);
        for (int i = 0; i < lanes; i++)
            parts.Add(BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(HeaderLength + (i * sizeof(ushort)))));
        content = new LaneCoverage
        {
            LanesKey = BinaryPrimitives.ReadUInt32LittleEndian(bytes),
            FirstLane = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(4)),
            Parts = parts.MoveToImmutable(),
        };
        return true;
    }
}
