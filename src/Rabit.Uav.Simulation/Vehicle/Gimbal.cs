using System;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Turns the camera against the body, pitch and yaw, at a limited rate. It follows angles against the body; it does not hold the horizon.
/// </summary>
internal sealed class Gimbal
{
    private const double MaximumRate = 60 * NedMath.RadiansPerDegree;
    private const double LowestPitch = -Math.PI / 2;
    private const double HighestPitch = 30 * NedMath.RadiansPerDegree;

    private double _wantedPitch = LowestPitch;
    private double _wantedYaw;

    /// <summary>Radians, up positive; it starts looking straight down.</summary>
    public double Pitch { get; private set; } = LowestPitch;

    /// <summary>Radians, right positive.</summary>
    public double Yaw { get; private set; }

    public void Point(double pitch, double yaw)
    {
        _wantedPitch = NedMath.Limited(pitch, LowestPitch, HighestPitch);
        _wantedYaw = NedMath.Wrapped(yaw);
    }

    public void Step(double seconds)
    {
        double reach = MaximumRate * seconds;
        Pitch += NedMath.Limited(_wantedPitch - Pitch, -reach, reach);
        Yaw += NedMath.Limited(NedMath.Wrapped(_wantedYaw - Yaw), -reach, reach);
    }
}
