using System;
using System.Collections.Generic;

namespace Rabit.Tool.Geolocation;

/// <summary>
/// A number of a request or of a table of poses, and what it may be: what is far beyond any flight is a mistake, and
/// its place would be none.
/// </summary>
internal readonly record struct PoseField(string Name, double Min, double Max, bool IsOptional = false)
{
    private const double MaxAltitude = 100_000;
    private const double MaxSpeed = 10_000;

    /// <summary>The ground that the camera sees.</summary>
    public static PoseField GroundAltitude { get; } = new("groundAltitudeAmslMetres", -1000, 10_000);

    public static PoseField Roll { get; } = new("rollDegrees", -180, 180);

    public static PoseField Pitch { get; } = new("pitchDegrees", -180, 180);

    public static PoseField Yaw { get; } = new("yawDegrees", -360, 360);

    /// <summary>What a pose has, in a request and as the columns of a table.</summary>
    public static IReadOnlyList<PoseField> All { get; } =
    [
        new("latitudeDegrees", -90, 90), new("longitudeDegrees", -180, 180),
        new("altitudeAmslMetres", -1000, MaxAltitude),
        new("velocityNorthMetresPerSecond", -MaxSpeed, MaxSpeed, IsOptional: true),
        new("velocityEastMetresPerSecond", -MaxSpeed, MaxSpeed, IsOptional: true),
        new("velocityDownMetresPerSecond", -MaxSpeed, MaxSpeed, IsOptional: true),
        Roll, Pitch, Yaw,
    ];

    /// <summary>What it may be, for people.</summary>
    public string Range => FormattableString.Invariant($"{Min} to {Max}");

    /// <summary>Whether it may be that.</summary>
    public bool Holds(double number) => number >= Min && number <= Max;
}
