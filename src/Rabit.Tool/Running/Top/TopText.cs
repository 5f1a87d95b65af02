using System;
using System.Globalization;

namespace Rabit.Tool.Running.Top;

/// <summary>Figures as text, so many digits as say something.</summary>
internal static class TopText
{
    private const string None = "-";

    public static string Count(long count) => count.ToString(CultureInfo.InvariantCulture);

    public static string Rate(double? perSecond) => Figure(perSecond);

    public static string Percent(double? part) => Fixed(part * 100, 1);

    public static string Milliseconds(double? seconds) => Fixed(seconds * 1000, 3);

    public static string Seconds(double? seconds) => Figure(seconds);

    /// <summary>Hours, minutes and seconds.</summary>
    public static string Clock(double seconds)
    {
        TimeSpan time = TimeSpan.FromSeconds(Math.Clamp(seconds, 0, TimeSpan.MaxValue.TotalSeconds / 2));
        return string.Create(CultureInfo.InvariantCulture, $"{(long)time.TotalHours:00}:{time:mm\\:ss}");
    }

    private static string Figure(double? figure) => Fixed(figure, Math.Abs(figure ?? 0) switch
    {
        < 10 => 2,
        < 1000 => 1,
        _ => 0,
    });

    private static string Fixed(double? figure, int digits)
        => figure?.ToString("F" + digits.ToString(CultureInfo.InvariantCulture), CultureInfo.InvariantCulture) ?? None;
}
