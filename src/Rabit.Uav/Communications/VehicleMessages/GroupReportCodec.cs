using System;
using System.Buffers.Binary;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>
/// Reports of the vehicles of a group: 44 bytes, little-endian, no padding. Stateless; any thread.
/// </summary>
/// <remarks>
/// Key of the lanes (4 bytes), state (1), author of the division (1), its number (2), latitude and longitude (4 + 4,
/// 1e-7 degrees), altitude (4, cm above mean sea level), the same three of the landing place (12), altitude of the
/// search (4, cm), speed (2, cm/s), search time (2, s), metres left (2; 65535 for that and more), how much of
/// the area was seen (2, 1/65535, rounded down).
/// </remarks>
public sealed class GroupReportCodec : IVehicleMessageCodec<GroupReport>
{
    /// <summary>How many bytes a report has.</summary>
    public const int Length = 44;

    private const double MaxAltitudeMetres = 20_000;

    /// <summary>2.</summary>
    public int MessageType => 2;

    /// <inheritdoc/>
    public int Version => 2;

    /// <inheritdoc/>
    public bool TryEncode(in GroupReport content, TimeSpan now, Span<byte> destination, out int length)
    {
        length = 0;
        if (destination.Length < Length || !IsValid(content))
            return false;
        BinaryPrimitives.WriteUInt32LittleEndian(destination, content.LanesKey);
        destination[4] = (byte)content.State;
        destination[5] = content.DivisionAuthor;
        BinaryPrimitives.WriteUInt16LittleEndian(destination.Slice(6), content.DivisionNumber);
        Write(destination.Slice(8), content.Position);
        Write(destination.Slice(20), content.LandingPlace);
        BinaryPrimitives.WriteInt32LittleEndian(
            destination.Slice(32), (int)Math.Round(content.SearchAltitudeAmslMetres * 100));
        BinaryPrimitives.WriteUInt16LittleEndian(destination.Slice(36), Limited(content.SpeedMetresPerSecond * 100));
        BinaryPrimitives.WriteUInt16LittleEndian(destination.Slice(38), Limited(content.SearchTime.ExactSeconds));
        BinaryPrimitives.WriteUInt16LittleEndian(destination.Slice(40), Limited(content.MetresLeft));
        BinaryPrimitives.WriteUInt16LittleEndian(
            destination.Slice(42), (ushort)Math.Floor(content.SeenFraction * ushort.MaxValue));
        length = Length;
        return true;
    }

    /// <inheritdoc/>
    public bool TryDecode(
        ReadOnlySpan<byte> bytes, int version, TimeSpan sentTime, byte sourceSystemId, out GroupReport content)
    {
        content = default;
        if (bytes.Length != Length || version != Version)
            return false;
        var report = new GroupReport
        {
            LanesKey = BinaryPrimitives.ReadUInt32LittleEndian(bytes),
            State = (GroupMemberState)bytes[4],
            DivisionAuthor = bytes[5],
            DivisionNumber = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(6)),
            Position = Read(bytes.Slice(8)),
            LandingPlace = Read(bytes.Slice(20)),
            SearchAltitudeAmslMetres = BinaryPrimitives.ReadInt32LittleEndian(bytes.Slice(32)) / 100.0,
            SpeedMetresPerSecond = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(36)) / 100.0,
            SearchTime = TimeSpan.OfSeconds(BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(38))),
            MetresLeft = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(40)),
            SeenFraction = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(42)) / (double)ushort.MaxValue,
        };
        if (!IsValid(report))
            return false;
        content = report;
        return true;
    }

    // Comparisons with NaN are false.
    private static bool IsValid(in GroupReport report)
        => report.State is >= GroupMemberState.Waiting and <= GroupMemberState.Following
            && IsPlace(report.Position)
            && IsPlace(report.LandingPlace)
            && Math.Abs(report.SearchAltitudeAmslMetres) <= MaxAltitudeMetres
            && report.SpeedMetresPerSecond is > 0 and <= 100
            && report.SearchTime >= TimeSpan.Zero
            && report.MetresLeft >= 0
            && report.SeenFraction is >= 0 and <= 1;

    private static bool IsPlace(GeodeticPosition place)
        => PlaceBytes.IsInRange(place)
            && Math.Abs(place.AltitudeAmslMetres) <= MaxAltitudeMetres
            && !(Math.Abs(place.Latitude.Radians) < 1e-8 && Math.Abs(place.Longitude.Radians) < 1e-8);

    private static ushort Limited(double value) => (ushort)Math.Min(ushort.MaxValue, Math.Round(value));

    private static void Write(Span<byte> destination, GeodeticPosition place)
    {
        PlaceBytes.Write(destination, place);
        BinaryPrimitives.WriteInt32LittleEndian(
            destination.Slice(PlaceBytes.Length), (int)Math.Round(place.AltitudeAmslMetres * 100));
    }

    private static GeodeticPosition Read(ReadOnlySpan<byte> source)
        => PlaceBytes.Read(source, BinaryPrimitives.ReadInt32LittleEndian(source.Slice(PlaceBytes.Length)) / 100.0);
}
