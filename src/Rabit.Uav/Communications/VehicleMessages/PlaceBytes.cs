using System;
using System.Buffers.Binary;
using Rabit.Geodesy;

namespace Rabit.Uav.Communications;

/// <summary>
/// Latitude and longitude as messages between vehicles hold them: 4 + 4 bytes, 1e-7 degrees, little-endian.
/// </summary>
internal static class PlaceBytes
{
    public const int Length = 8;

    private const double DegE7PerRadian = 1e7 / Angle.RadiansPerDegree;

    public static void Write(Span<byte> destination, in GeodeticPosition place)
    {
        BinaryPrimitives.WriteInt32LittleEndian(
            destination, (int)Math.Round(place.Latitude.Radians * DegE7PerRadian));
        BinaryPrimitives.WriteInt32LittleEndian(
            destination.Slice(4), (int)Math.Round(place.Longitude.Radians * DegE7PerRadian));
    }

    /// <param name="source">At least <see cref="Length"/> bytes.</param>
    /// <param name="altitudeAmslMetres">Where the message has one.</param>
    public static GeodeticPosition Read(ReadOnlySpan<byte> source, double altitudeAmslMetres = 0)
        => GeodeticPosition.FromRadians(
            BinaryPrimitives.ReadInt32LittleEndian(source) / DegE7PerRadian,
            BinaryPrimitives.ReadInt32LittleEndian(source.Slice(4)) / DegE7PerRadian, altitudeAmslMetres);

    /// <summary>Whether both are in range; not where they are no numbers.</summary>
    public static bool IsInRange(in GeodeticPosition place)
        => Math.Abs(place.Latitude.Radians) <= Math.PI / 2
            && Math.Abs(place.Longitude.Radians) <= Math.PI + 1e-9;
}
