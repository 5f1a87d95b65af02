using System;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Turns the camera in pitch and yaw at a limited rate: against the body. One that holds the horizon is derived from
/// it.
/// </summary>
internal class Gimbal
{
    private const double MaxRate = 60 * NedMath.RadiansPerDegree;
    private const double MinPitch = -Math.PI / 2;
    private const double MaxPitch = 30 * NedMath.RadiansPerDegree;

    private double _wantedPitch;
    private double _wantedYaw;

    /// <param name="pitch">Where it looks until it is pointed elsewhere, radians, up positive.</param>
    /// <param name="yaw">The same, right positive, against what it holds.</param>
    public Gimbal(double pitch = MinPitch, double yaw = 0)
        => (Pitch, Yaw, _wantedPitch, _wantedYaw) = (pitch, yaw, pitch, yaw);

    /// <summary>How the camera is really turned.</summary>
    public virtual GimbalAngles Angles => new(GimbalFrame.Body, Yaw, roll: 0, Pitch);

    /// <summary>How it says that the camera is turned.</summary>
    public virtual GimbalAngles Reported => Angles;

    /// <summary>Where the motors are to hold it, radians, up positive.</summary>
    protected double Pitch { get; private set; }

    /// <summary>The same, right positive.</summary>
    protected double Yaw { get; private set; }

    /// <summary>Whether the flags of a command say that its yaw is against north, not the vehicle.</summary>
    /// <param name="flags">GIMBAL_MANAGER_FLAGS, as a parameter of a command carries them.</param>
    public static bool IsYawFromNorth(float flags)
    {
        const GimbalManagerFlags Said = GimbalManagerFlags.YawInVehicleFrame | GimbalManagerFlags.YawInEarthFrame;
        if (!(flags >= 0 && flags <= ushort.MaxValue))
            return false;
        var said = (GimbalManagerFlags)(uint)flags;
        return (said & Said) == 0
            ? (said & GimbalManagerFlags.YawLock) != 0
            : (said & GimbalManagerFlags.YawInEarthFrame) != 0;
    }

    /// <param name="pitch">Radians, up positive.</param>
    /// <param name="yaw">Radians, right positive.</param>
    /// <param name="isYawFromNorth">Whether the yaw is against north, not the vehicle.</param>
    public void Point(double pitch, double yaw, bool isYawFromNorth)
    {
        _wantedPitch = NedMath.Limited(pitch, MinPitch, MaxPitch);
        _wantedYaw = NedMath.Wrapped(YawOf(yaw, isYawFromNorth));
    }

    /// <summary>One step.</summary>
    /// <param name="vehicle">Its true attitude.</param>
    /// <param name="rates">Its true rates.</param>
    /// <param name="yawError">How much too far right the autopilot takes north for, which a gimbal has it from.</param>
    /// <param name="seconds">How long the step is.</param>
    public virtual void Step(EulerAngles vehicle, BodyRates rates, Angle yawError, double seconds)
    {
        double reach = MaxRate * seconds;
        Pitch += NedMath.Limited(_wantedPitch - Pitch, -reach, reach);
        Yaw += NedMath.Limited(NedMath.Wrapped(_wantedYaw - Yaw), -reach, reach);
    }

    /// <summary>A yaw that was commanded, against what this one holds.</summary>
    protected virtual double YawOf(double yaw, bool isFromNorth) => yaw;
}
