using System;
using System.Buffers.Binary;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>
/// States of tracks between vehicles: 71 bytes and the name of the class (1 to 16 bytes), little-endian, no padding.
/// Stateless; any thread.
/// </summary>
/// <remarks>
/// Length of the class name (1 byte), track (4), picture (4, modulo 2^32), age (4, ms), latitude and longitude (4 + 4,
/// 1e-7 degrees), altitude (4, mm above mean sea level), velocity north and east (2 + 2, cm/s), covariances as floats:
/// of the position (north-north, north-east, east-east, m2), of the velocity (the same, m2/s2), of position and
/// velocity (north with north rate, north with east rate, east with north rate, east with east rate, m2/s); id of the
/// marker (2, 65535 for none), class name (ASCII). The age is that at the moment of sending.
/// </remarks>
public sealed class TrackEstimateCodec : IVehicleMessageCodec<TrackEstimate>
{
    private const int CovarianceOffset = 29;
    private const int MarkerOffset = 69;
    private const int NameOffset = 71;
    private const ushort NoMarker = ushort.MaxValue;
    private const double MaxSpeed = 300;
    private const double MaxAltitudeMetres = 20_000;
    private const double MaxVariance = 1e8;
    private const double MaxAgeMs = 600_000;

    /// <summary>12.</summary>
    public int MessageType => 12;

    /// <inheritdoc/>
    public int Version => 1;

    /// <inheritdoc/>
    public bool TryEncode(in TrackEstimate content, TimeSpan now, Span<byte> destination, out int length)
    {
        length = 0;
        double ageMs = Math.Max(0, Math.Round((now - content.Time).ExactMilliseconds));
        int needed = NameOffset + content.Class.Length;
        if (destination.Length < needed || !IsValid(content) || !(ageMs <= MaxAgeMs))
            return false;
        destination[0] = (byte)content.Class.Length;
        BinaryPrimitives.WriteInt32LittleEndian(destination.Slice(1), content.TrackId);
        BinaryPrimitives.WriteUInt32LittleEndian(destination.Slice(5), unchecked((uint)content.PictureNumber));
        BinaryPrimitives.WriteUInt32LittleEndian(destination.Slice(9), (uint)ageMs);
        PlaceBytes.Write(destination.Slice(13), content.Position);
        BinaryPrimitives.WriteInt32LittleEndian(
            destination.Slice(21), (int)Math.Round(content.Position.AltitudeAmslMetres * 1000));
        BinaryPrimitives.WriteInt16LittleEndian(
            destination.Slice(25), (short)Math.Round(content.VelocityNed.North * 100));
        BinaryPrimitives.WriteInt16LittleEndian(
            destination.Slice(27), (short)Math.Round(content.VelocityNed.East * 100));
        WriteCovariance(destination.Slice(CovarianceOffset), content);
        BinaryPrimitives.WriteUInt16LittleEndian(
            destination.Slice(MarkerOffset), (ushort)(content.MarkerId ?? NoMarker));
        content.Class.CopyTo(destination.Slice(NameOffset));
        length = needed;
        return true;
    }

    /// <inheritdoc/>
    public bool TryDecode(
        ReadOnlySpan<byte> bytes, int version, TimeSpan sentTime, byte sourceSystemId, out TrackEstimate content)
    {
        content = default;
        if (version != Version || bytes.Length <= NameOffset || bytes.Length != NameOffset + bytes[0]
            || !TargetClassName.TryRead(bytes.Slice(NameOffset), out TargetClassName name))
            return false;
        uint ageMs = BinaryPrimitives.ReadUInt32LittleEndian(bytes.Slice(9));
        if (ageMs > MaxAgeMs)
            return false;
        ushort marker = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(MarkerOffset));
        var estimate = new TrackEstimate
        {
            SourceSystemId = sourceSystemId,
            TrackId = BinaryPrimitives.ReadInt32LittleEndian(bytes.Slice(1)),
            PictureNumber = BinaryPrimitives.ReadUInt32LittleEndian(bytes.Slice(5)),
            Time = sentTime - TimeSpan.FromTicks(ageMs * TimeSpan.TicksPerMillisecond),
            Position = PlaceBytes.Read(
                bytes.Slice(13), BinaryPrimitives.ReadInt32LittleEndian(bytes.Slice(21)) / 1000.0),
            VelocityNed = new NedVector(
                BinaryPrimitives.ReadInt16LittleEndian(bytes.Slice(25)) / 100.0,
                BinaryPrimitives.ReadInt16LittleEndian(bytes.Slice(27)) / 100.0, 0),
            MarkerId = marker == NoMarker ? null : marker,
            Class = name,
        };
        ReadCovariance(bytes.Slice(CovarianceOffset), ref estimate);
        if (!IsValid(estimate))
            return false;
        content = estimate;
        return true;
    }

    private static void WriteCovariance(Span<byte> destination, in TrackEstimate estimate)
    {
        Write(destination, 0, estimate.Covariance);
        Write(destination, 3, estimate.VelocityCovariance);
        WriteSingle(destination, 6, estimate.NorthWithNorthRate);
        WriteSingle(destination, 7, estimate.NorthWithEastRate);
        WriteSingle(destination, 8, estimate.EastWithNorthRate);
        WriteSingle(destination, 9, estimate.EastWithEastRate);
    }

    private static void ReadCovariance(ReadOnlySpan<byte> source, ref TrackEstimate estimate)
    {
        estimate.Covariance = new HorizontalCovariance(
            ReadSingle(source, 0), ReadSingle(source, 1), ReadSingle(source, 2));
        estimate.VelocityCovariance = new HorizontalCovariance(
            ReadSingle(source, 3), ReadSingle(source, 4), ReadSingle(source, 5));
        estimate.NorthWithNorthRate = ReadSingle(source, 6);
        estimate.NorthWithEastRate = ReadSingle(source, 7);
        estimate.EastWithNorthRate = ReadSingle(source, 8);
        estimate.EastWithEastRate = ReadSingle(source, 9);
    }

    // Comparisons with NaN are false. Whether the covariance as a whole is one is judged by who uses it.
    private static bool IsValid(in TrackEstimate estimate)
        => estimate.TrackId > 0 && estimate.PictureNumber >= 0
            && PlaceBytes.IsInRange(estimate.Position)
            && Math.Abs(estimate.Position.AltitudeAmslMetres) <= MaxAltitudeMetres
            && Math.Abs(estimate.VelocityNed.North) <= MaxSpeed && Math.Abs(estimate.VelocityNed.East) <= MaxSpeed
            && IsSized(estimate.Covariance) && IsSized(estimate.VelocityCovariance)
            && Math.Abs(estimate.NorthWithNorthRate) <= MaxVariance
            && Math.Abs(estimate.NorthWithEastRate) <= MaxVariance
            && Math.Abs(estimate.EastWithNorthRate) <= MaxVariance
            && Math.Abs(estimate.EastWithEastRate) <= MaxVariance
            && estimate.MarkerId is null or (>= 0 and < NoMarker)
            && !estimate.Class.IsNone;

    private static bool IsSized(HorizontalCovariance c)
        => c.NorthNorth is > 0 and <= MaxVariance && c.EastEast is > 0 and <= MaxVariance
            && c.NorthNorth * c.EastEast > c.NorthEast * c.NorthEast;

    private static void Write(Span<byte> destination, int at, HorizontalCovariance covariance)
    {
        WriteSingle(destination, at, covariance.NorthNorth);
        WriteSingle(destination, at + 1, covariance.NorthEast);
        WriteSingle(destination, at + 2, covariance.EastEast);
    }

    private static unsafe void WriteSingle(Span<byte> destination, int at, double value)
    {
        float single = (float)value;
        BinaryPrimitives.WriteInt32LittleEndian(destination.Slice(4 * at), *(int*)&single);
    }

    private static unsafe double ReadSingle(ReadOnlySpan<byte> source, int at)
    {
        int bits = BinaryPrimitives.ReadInt32LittleEndian(source.Slice(4 * at));
        return *(float*)&bits;
    }
}
