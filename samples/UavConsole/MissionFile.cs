using System;
using System.Globalization;
using System.Linq;
using System.Security.Cryptography;
using System.Text;
using Rabit.Geodesy;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Reporting;

namespace UavConsole;

/// <summary>A mission and the file that it was read from. Immutable.</summary>
/// <param name="name">Of the file, without its folder.</param>
/// <param name="text">What is in it.</param>
/// <param name="plan">What that means.</param>
internal sealed class MissionFile(string name, string text, MissionPlan plan)
{
    // Farther from the vehicle no area is searched, and the vehicle takes off near home.
    private const double MaxHomeMetres = 5_000;

    public string Name { get; } = name;

    public MissionPlan Plan { get; } = plan;

    /// <summary>
    /// SHA-256 of the text in UTF-8, hexadecimal: what <c>sha256sum</c> says of a file without a byte order mark.
    /// </summary>
    public string Sha256 { get; } = HashOf(text);

    /// <summary>
    /// Why the file makes no sense whatever the vehicle says: a typing error in home shows here and not in the field.
    /// </summary>
    public string? FindFaultOfHome()
    {
        if (Plan.Home is not { } home)
            return null;
        var frame = LocalNedFrame.IgnoringGeoid(
            GeodeticPosition.FromRadians(home.Latitude.Radians, home.Longitude.Radians, 0));
        double metres = Plan.Area.Select(c => frame.ToNed(c))
            .Min(n => Math.Sqrt((n.North * n.North) + (n.East * n.East)));
        return metres <= MaxHomeMetres
            ? null
            : $"home is {FlightText.Number(metres / 1000, "0.#")} km from the area; the limit is "
                + $"{FlightText.Number(MaxHomeMetres / 1000)} km. Are latitude and longitude in order?";
    }

    private static string HashOf(string text)
    {
        using var sha = SHA256.Create();
#pragma warning disable CA1850   // Mono has no HashData.
        byte[] hash = sha.ComputeHash(new UTF8Encoding(encoderShouldEmitUTF8Identifier: false).GetBytes(text));
#pragma warning restore CA1850
        return string.Concat(hash.Select(b => b.ToString("x2", CultureInfo.InvariantCulture)));
    }
}
