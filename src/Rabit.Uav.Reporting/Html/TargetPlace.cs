using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Reporting.Html;

/// <summary>Where something is, in the forms in which people pass places on.</summary>
internal static class TargetPlace
{
    private const double MgrsSouthDegrees = -80;
    private const double MgrsNorthDegrees = 84;

    /// <summary>Latitude and longitude in degrees, seven places.</summary>
    public static string Decimal(GeodeticPosition position)
        => $"{FlightText.Degrees(position.Latitude.Radians)}, {FlightText.Degrees(position.Longitude.Radians)}";

    /// <summary>The square of a metre; null about the poles, where MGRS has another grid.</summary>
    public static string? Mgrs(GeodeticPosition position)
        => position.IsValid && position.Latitude.Degrees is >= MgrsSouthDegrees and <= MgrsNorthDegrees
            ? MgrsPosition.From(position.Point).ToString()
            : null;

    /// <summary>Distance and bearing, for example <c>142 m at 057°</c>, clockwise from true north.</summary>
    public static string From(GeodeticPosition home, GeodeticPosition position)
    {
        NedPosition ned = LocalNedFrame.IgnoringGeoid(home).ToNed(position);
        double degrees = Angle.FromRadians(Math.Atan2(ned.East, ned.North)).Degrees;
        double bearing = Math.Round(degrees < 0 ? degrees + 360 : degrees) % 360;
        double metres = Math.Sqrt((ned.North * ned.North) + (ned.East * ned.East));
        return $"{FlightText.Number(metres, "0")} m at {FlightText.Number(bearing, "000")}°";
    }
}
