using System;
using System.Buffers.Binary;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>
/// Target reports between vehicles: 60 bytes and the name of the class (1 to 16 bytes), little-endian, no padding.
/// Stateless; any thread.
/// </summary>
/// <remarks>
/// Version (1 byte, 3), length of the class name (1), index (1), score (1, of 255), picture (4, modulo 2^32), age (4,
/// ms), latitude and longitude (4 + 4, 1e-7 degrees), altitude (4, mm above mean sea level), random covariance (3
/// floats, m2: north-north, north-east, east-east), systematic covariance (the same), size (2, mm), centre (2 floats,
/// pixels), id of the marker (2, 65535 for none), class name (ASCII). A class that is not declared here keeps its name.
/// Version 1, which had one of five colours instead of a class name, and 2, which had no marker, are refused.
/// The clocks of two vehicles have nothing in common, so that the time travels as the age at the moment of sending. The
/// time on the other side is late by the transmission: some ten milliseconds on a net, up to half a second on a slow
/// radio.
/// </remarks>
public sealed class TargetReportCodec : IVehicleMessageCodec<TargetReport>
{
    /// <summary>How many bytes a report has at least, with a class name of one character.</summary>
    public const int MinLength = NameOffset + 1;

    /// <summary>How many bytes a report has at most.</summary>
    public const int MaxLength = NameOffset + TargetClassName.MaxLength;

    private const int NameOffset = 60;
    private const byte FormVersion = 3;
    private const ushort NoMarker = ushort.MaxValue;
    private const double DegE7PerRadian = 1e7 / Angle.RadiansPerDegree;
    private const double MaxLatitudeDegE7 = 90e7;
    private const double MaxLongitudeDegE7 = 180e7;
    private const double MaxAltitudeMetres = 20_000;
    private const double MaxVariance = 1e8;
    private const double MaxPixel = 100_000;
    private const double MaxAgeMs = 600_000;

    /// <summary>1: the first of Rabit's own.</summary>
    public int MessageType => 1;

    /// <inheritdoc/>
    public int Version => FormVersion;

    /// <inheritdoc/>
    public bool TryEncode(in TargetReport content, TimeSpan now, Span<byte> destination, out int length)
    {
        length = 0;
        double ageMs = Math.Round((now - content.Time).ExactMilliseconds);
        int nameLength = content.Class.Length;
        bool fits = destination.Length >= NameOffset + nameLength
            && IsValid(content)
            && content.Index is >= 0 and <= byte.MaxValue
            && content.PictureNumber >= 0
            && content.Score is >= 0 and <= 1
            && content.SizeMetres * 1000 is >= 0 and <= ushort.MaxValue
            && ageMs <= MaxAgeMs;
        if (!fits)
            return false;

        destination[0] = FormVersion;
        destination[1] = (byte)nameLength;
        destination[2] = (byte)content.Index;
        destination[3] = (byte)Math.Round(content.Score * byte.MaxValue);
        BinaryPrimitives.WriteUInt32LittleEndian(destination.Slice(4), unchecked((uint)content.PictureNumber));
        BinaryPrimitives.WriteUInt32LittleEndian(destination.Slice(8), (uint)Math.Max(0, ageMs));
        PlaceBytes.Write(destination.Slice(12), content.Position);
        BinaryPrimitives.WriteInt32LittleEndian(
            destination.Slice(20), (int)Math.Round(content.Position.AltitudeAmslMetres * 1000));
        Write(destination.Slice(24), content.Covariance);
        Write(destination.Slice(36), content.SystematicCovariance);
        BinaryPrimitives.WriteUInt16LittleEndian(destination.Slice(48), (ushort)Math.Round(content.SizeMetres * 1000));
        WriteSingle(destination.Slice(50), content.CentreX);
        WriteSingle(destination.Slice(54), content.CentreY);
        BinaryPrimitives.WriteUInt16LittleEndian(destination.Slice(58), (ushort)(content.MarkerId ?? NoMarker));
        content.Class.CopyTo(destination.Slice(NameOffset));
        length = NameOffset + nameLength;
        return true;
    }

    /// <inheritdoc/>
    public bool TryDecode(
        ReadOnlySpan<byte> bytes, int version, TimeSpan sentTime, byte sourceSystemId, out TargetReport content)
    {
        content = default;
        if (bytes.Length < MinLength || bytes[0] != FormVersion || bytes.Length != NameOffset + bytes[1]
            || !TargetClassName.TryRead(bytes.Slice(NameOffset), out TargetClassName targetClass))
            return false;
        uint ageMs = BinaryPrimitives.ReadUInt32LittleEndian(bytes.Slice(8));
        ushort marker = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(58));
        if (ageMs > MaxAgeMs)
            return false;

        var report = new TargetReport
        {
            SourceSystemId = sourceSystemId,
            PictureNumber = BinaryPrimitives.ReadUInt32LittleEndian(bytes.Slice(4)),
            Index = bytes[2],
            Time = sentTime - TimeSpan.OfMilliseconds(ageMs),
            Position = PlaceBytes.Read(
                bytes.Slice(12), BinaryPrimitives.ReadInt32LittleEndian(bytes.Slice(20)) / 1000.0),
            Covariance = ReadCovariance(bytes.Slice(24)),
            SystematicCovariance = ReadCovariance(bytes.Slice(36)),
            Class = targetClass,
            Score = bytes[3] / (double)byte.MaxValue,
            SizeMetres = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(48)) / 1000.0,
            CentreX = ReadSingle(bytes.Slice(50)),
            CentreY = ReadSingle(bytes.Slice(54)),
            MarkerId = marker == NoMarker ? null : marker,
        };
        if (!IsValid(report))
            return false;
        content = report;
        return true;
    }

    private static bool IsValid(in TargetReport report)
    {
        double latitude = report.Position.Latitude.Radians * DegE7PerRadian;
        double longitude = report.Position.Longitude.Radians * DegE7PerRadian;
        return Math.Abs(latitude) <= MaxLatitudeDegE7 + 0.5
            && Math.Abs(longitude) <= MaxLongitudeDegE7 + 0.5
            && !(Math.Abs(latitude) < 1 && Math.Abs(longitude) < 1)
            && Math.Abs(report.Position.AltitudeAmslMetres) <= MaxAltitudeMetres
            && !report.Class.IsNone
            && report.MarkerId is null or (>= 0 and < NoMarker)
            && IsCovariance(report.Covariance, canBeNone: false)
            && IsCovariance(report.SystematicCovariance, canBeNone: true)
            && Math.Abs(report.CentreX) <= MaxPixel
            && Math.Abs(report.CentreY) <= MaxPixel;
    }

    // Comparisons with NaN are false.
    private static bool IsCovariance(in HorizontalCovariance covariance, bool canBeNone)
    {
        double nn = covariance.NorthNorth;
        double ne = covariance.NorthEast;
        double ee = covariance.EastEast;
        double determinant = (nn * ee) - (ne * ne);
        bool isSized = nn is >= 0 and <= MaxVariance && ee is >= 0 and <= MaxVariance;

        // Floats of a systematic part that is a line may come out a little below.
        return isSized && (canBeNone ? determinant >= -1e-6 * Math.Max(nn * ee, 1e-12) : nn > 0 && determinant > 0);
    }

    private static void Write(Span<byte> destination, in HorizontalCovariance covariance)
    {
        WriteSingle(destination, covariance.NorthNorth);
        WriteSingle(destination.Slice(4), covariance.NorthEast);
        WriteSingle(destination.Slice(8), covariance.EastEast);
    }

    private static HorizontalCovariance ReadCovariance(ReadOnlySpan<byte> source)
        => new(ReadSingle(source), ReadSingle(source.Slice(4)), ReadSingle(source.Slice(8)));

    private static unsafe void WriteSingle(Span<byte> destination, double value)
    {
        float single = (float)value;
        BinaryPrimitives.WriteInt32LittleEndian(destination, *(int*)&single);
    }

    private static unsafe double ReadSingle(ReadOnlySpan<byte> source)
    {
        int bits = BinaryPrimitives.ReadInt32LittleEndian(source);
        return *(float*)&bits;
    }
}
