using System;
using System.Globalization;
using Rabit.Geodesy;

namespace UavConsole;

/// <summary>Numbers for the report, the same in every culture.</summary>
internal static class Figures
{

    /// <summary>A dash where it is not known.</summary>
    public static string Of(double value, string format = "0.##")
        => double.IsNaN(value) || double.IsInfinity(value) ? "–" : value.ToString(format, CultureInfo.InvariantCulture);

    public static string Of(long value) => value.ToString(CultureInfo.InvariantCulture);

    /// <summary>Minutes and seconds.</summary>
    public static string Clock(TimeSpan time) => string.Format(CultureInfo.InvariantCulture, "{0}:{1:00}", (long)Math.Floor(time.TotalMinutes), time.Seconds);

    /// <summary>Degrees with seven decimals: a centimetre.</summary>
    public static string Degrees(Angle angle) => Of(angle.Degrees, "0.0000000");
}
