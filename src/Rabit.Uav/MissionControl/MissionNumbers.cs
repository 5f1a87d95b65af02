using System;
using System.Globalization;

namespace Rabit.Uav.MissionControl;

/// <summary>Numbers in the texts of the mission: the same on every machine and runtime.</summary>
internal static class MissionNumbers
{
    /// <summary>With one decimal; a zero has no sign, which runtimes disagree about.</summary>
    public static string Of(double value) => (Math.Round(value, 1) + 0.0).ToString("0.0", CultureInfo.InvariantCulture);

    public static string Of(int value) => value.ToString(CultureInfo.InvariantCulture);

    public static string Percent(double fraction) => Of(100 * fraction) + " %";

    public static string Of(PlanePoint p) => "N " + Of(p.North) + " E " + Of(p.East);

    public static string Seconds(TimeSpan time) => Of(time.TotalSeconds) + " s";
}
