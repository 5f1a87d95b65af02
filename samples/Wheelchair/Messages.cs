using System;

namespace Wheelchair;

/// <summary>What the driver wants.</summary>
internal struct Joystick
{
    /// <summary>From -1, back at full speed, to 1, ahead.</summary>
    public double Forward;
}

/// <summary>What is in front of the chair. The stamp of the message says when it was measured.</summary>
internal struct Obstacle
{
    public double DistanceMetres;
}

/// <summary>What the drive controller does, and why.</summary>
internal struct Drive
{
    public double SpeedMetresPerSecond;

    /// <summary>Set by the safety stop; reset when the driver lets go of the joystick.</summary>
    public bool IsSafetyStop;
}

/// <summary>One reading of the range sensor.</summary>
internal readonly struct RangeReading(double distanceMetres, TimeSpan at)
{
    public double DistanceMetres { get; } = distanceMetres;

    public TimeSpan At { get; } = at;
}

/// <summary>The command to the motors.</summary>
internal readonly struct MotorCommand(double speedMetresPerSecond, TimeSpan at)
{
    public double SpeedMetresPerSecond { get; } = speedMetresPerSecond;

    public TimeSpan At { get; } = at;
}
