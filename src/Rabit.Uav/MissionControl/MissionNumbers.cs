using System;
using System.Globalization;
using Rabit.Geodesy;

namespace Rabit.Uav.MissionControl;

/// <summary>Numbers in the texts of the mission: the same on every machine and runtime.</summary>
internal static class MissionNumbers
{
    /// <summary>With one decimal; a zero has no sign, which runtimes disagree about.</summary>
    public static string Of(double value) => (Math.Round(value, 1) + 0.0).ToString("0.0", CultureInfo.InvariantCulture);

    public static string Of(int value) => value.ToString(CultureInfo.InvariantCulture);

    public static string Percent(double fraction) => Of(100 * fraction) + " %";

    public static string Of(PlanePoint p) => "N " + Of(p.North) + " E " + Of(p.East);

    /// <summary>Latitude and longitude in degrees, to a centimetre.</summary>
    public static string Of(GeodeticPosition p)
        => p.Latitude.Degrees.ToString("0.0000000", CultureInfo.InvariantCulture) + ", "
            + p.Longitude.Degrees.ToString("0.0000000", CultureInfo.InvariantCulture);

    public static string Seconds(TimeSpan time) => Of(time.ExactSeconds) + " s";
}
