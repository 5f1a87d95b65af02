using System;
using System.Globalization;

namespace Rabit.Geodesy;

/// <summary>Positions as people write them. Any thread.</summary>
/// <example>
/// <code>
/// if (PositionText.TryParse("47°23'51.6\"N 8°32'44.4\"E", out GeographicPoint point))
///     Console.WriteLine(PositionText.Format(point, PositionStyle.Mgrs));
/// </code>
/// </example>
public static class PositionText
{
    private const int MillisecondsPerDegree = 3_600_000;

    /// <summary>Writes a position; the longitude from -180 to 180 degrees.</summary>
    /// <param name="point">
    /// The position. What may be none is better written by <see cref="GeographicPoint.ToString"/>, which never throws.
    /// </param>
    /// <param name="style">How.</param>
    /// <exception cref="ArgumentOutOfRangeException">
    /// The position is none: not a number, or beyond a pole (<see cref="GeographicPoint.IsValid"/>); MGRS is asked for
    /// near a pole; or there is no such style.
    /// </exception>
    public static string Format(GeographicPoint point, PositionStyle style)
    {
        if (!point.IsValid)
            throw new ArgumentOutOfRangeException(nameof(point), $"{point} cannot be written as a position.");
        Angle longitude = point.Longitude.Wrapped();
        return style switch
        {
            PositionStyle.DecimalDegrees => string.Format(
                CultureInfo.InvariantCulture, "{0:0.0000000}, {1:0.0000000}", point.Latitude.Degrees,
                longitude.Degrees),
            PositionStyle.DegreesMinutesSeconds =>
                Sexagesimal(point.Latitude, 'N', 'S') + " " + Sexagesimal(longitude, 'E', 'W'),
            PositionStyle.Mgrs => MgrsPosition.From(point).ToString(),
            _ => throw new ArgumentOutOfRangeException(nameof(style), style, "There is no such style."),
        };
    }

    /// <summary>
    /// Reads a position in any of the styles: decimal degrees with a sign or a letter, degrees with minutes, or with
    /// minutes and seconds; MGRS, of which it is the middle of the square. Latitude first, unless letters say
    /// otherwise.
    /// </summary>
    /// <param name="text">As 47.5, -8.25 or 47°30'N 8°15'0.5"W or 32TMT6500050000.</param>
    /// <param name="point">What it says; nothing if the answer is false.</param>
    public static bool TryParse(string? text, out GeographicPoint point)
    {
        point = default;
        if (string.IsNullOrWhiteSpace(text))
            return false;
        if (MgrsPosition.TryParse(text, out MgrsPosition mgrs))
        {
            point = mgrs.Centre;
            return true;
        }

        var reader = new SexagesimalReader(text!);
        if (!reader.TryRead(out double first, out char firstLetter)
            || !reader.TryRead(out double second, out char secondLetter) || !reader.IsAtEnd)
            return false;
        bool isSwapped = firstLetter is 'E' or 'W';
        if (isSwapped || secondLetter is 'N' or 'S')
        {
            if (!(isSwapped && secondLetter is 'N' or 'S'))
                return false;
            (first, second) = (second, first);
        }

        if (!(Math.Abs(first) <= 90 && Math.Abs(second) <= 180))
            return false;
        point = new GeographicPoint(Angle.FromDegrees(first), Angle.FromDegrees(second));
        return true;
    }

    private static string Sexagesimal(Angle angle, char positive, char negative)
    {
        // Rounded first, so that there are never 60 seconds.
        long units = (long)Math.Round(Math.Abs(angle.Degrees) * MillisecondsPerDegree);
        return string.Format(
            CultureInfo.InvariantCulture,
            "{0}°{1:00}'{2:00.000}\"{3}",
            units / MillisecondsPerDegree,
            units / 60_000 % 60,
            units % 60_000 / 1000.0,
            angle.Radians < 0 ? negative : positive);
    }
}
