using System;
using System.Buffers.Binary;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>
/// What was seen of the lanes of a group, and what is left out: 7 bytes, 2 for each lane, and 3 for each of which parts
/// are left out; little-endian, no padding. Stateless; any thread.
/// </summary>
/// <remarks>
/// Key of the lanes (4 bytes), first lane (2), number of lanes (1), for each lane, 1 to 64 of them, its parts (2), then
/// for each lane of which parts are left out, in their order, its number from the first one on (1) and the parts (2).
/// </remarks>
public sealed class LaneCoverageCodec : IVehicleMessageCodec<LaneCoverage>
{
    private const int HeaderLength = 7;
    private const int SkippedLength = 3;

    /// <summary>6.</summary>
    public int MessageType => 6;

    /// <inheritdoc/>
    public int Version => 2;

    /// <inheritdoc/>
    public bool TryEncode(in LaneCoverage content, TimeSpan now, Span<byte> destination, out int length)
    {
        length = 0;
        ImmutableArray<ushort> parts = content.Parts;
        ImmutableArray<ushort> skipped = content.Skipped;
        int needed = HeaderLength + (sizeof(ushort) * parts.Length) + (SkippedLength * skipped.Count(s => s != 0));
        if (destination.Length < needed || parts.Length is 0 or > LaneCoverage.MaxLanes
            || (skipped.Length != 0 && skipped.Length != parts.Length)
            || content.FirstLane is < 0 or > ushort.MaxValue)
            return false;
        BinaryPrimitives.WriteUInt32LittleEndian(destination, content.LanesKey);
        BinaryPrimitives.WriteUInt16LittleEndian(destination.Slice(4), (ushort)content.FirstLane);
        destination[6] = (byte)parts.Length;
        Span<byte> rest = destination.Slice(HeaderLength);
        foreach (ushort seen in parts)
            rest = Write(rest, seen);
        for (int lane = 0; lane < skipped.Length; lane++)
        {
            if (skipped[lane] == 0)
                continue;
            rest[0] = (byte)lane;
            rest = Write(rest.Slice(1), skipped[lane]);
        }

        length = needed;
        return true;
    }

    /// <inheritdoc/>
    public bool TryDecode(
        ReadOnlySpan<byte> bytes, int version, TimeSpan sentTime, byte sourceSystemId, out LaneCoverage content)
    {
        content = default;
        if (version != Version || bytes.Length < HeaderLength)
            return false;
        int lanes = bytes[6];
        int left = bytes.Length - HeaderLength - (sizeof(ushort) * lanes);
        if (lanes is < 1 or > LaneCoverage.MaxLanes || left < 0 || left % SkippedLength != 0)
            return false;
        var parts = new ushort[lanes];
        for (int i = 0; i < lanes; i++)
            parts[i] = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(HeaderLength + (i * sizeof(ushort))));
        if (!TryReadSkipped(bytes.Slice(bytes.Length - left), lanes, out ImmutableArray<ushort> skipped))
            return false;
        content = new LaneCoverage
        {
            LanesKey = BinaryPrimitives.ReadUInt32LittleEndian(bytes),
            FirstLane = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(4)),
            Parts = [.. parts],
            Skipped = skipped,
        };
        return true;
    }

    private static Span<byte> Write(Span<byte> destination, ushort value)
    {
        BinaryPrimitives.WriteUInt16LittleEndian(destination, value);
        return destination.Slice(sizeof(ushort));
    }

    private static bool TryReadSkipped(ReadOnlySpan<byte> bytes, int lanes, out ImmutableArray<ushort> skipped)
    {
        skipped = [];
        if (bytes.Length == 0)
            return true;
        var all = new ushort[lanes];
        int next = 0;
        for (; bytes.Length > 0; bytes = bytes.Slice(SkippedLength))
        {
            int lane = bytes[0];
            ushort parts = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(1));
            if (lane < next || lane >= lanes || parts == 0)
                return false;
            (all[lane], next) = (parts, lane + 1);
        }

        skipped = [.. all];
        return true;
    }
}
