using System;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Turns the camera against the body, pitch and yaw, at a limited rate. It follows angles against the body; it does
/// not hold the horizon.
/// </summary>
internal sealed class Gimbal
{
    private const double MaxRate = 60 * NedMath.RadiansPerDegree;
    private const double MinPitch = -Math.PI / 2;
    private const double MaxPitch = 30 * NedMath.RadiansPerDegree;

    private double _wantedPitch = MinPitch;
    private double _wantedYaw;

    /// <summary>Radians, up positive; it starts looking straight down.</summary>
    public double Pitch { get; private set; } = MinPitch;

    /// <summary>Radians, right positive.</summary>
    public double Yaw { get; private set; }

    public void Point(double pitch, double yaw)
    {
        _wantedPitch = NedMath.Limited(pitch, MinPitch, MaxPitch);
        _wantedYaw = NedMath.Wrapped(yaw);
    }

    public void Step(double seconds)
    {
        double reach = MaxRate * seconds;
        Pitch += NedMath.Limited(_wantedPitch - Pitch, -reach, reach);
        Yaw += NedMath.Limited(NedMath.Wrapped(_wantedYaw - Yaw), -reach, reach);
    }
}
