using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.Simulation;

/// <summary>
/// How a camera is turned on its gimbal: yaw about down, then roll about forward, then pitch about right, as most
/// gimbals are built. So a camera that looks straight down can lean to all sides. Radians. A plain value.
/// </summary>
internal readonly struct GimbalAngles(GimbalFrame frame, double yaw, double roll, double pitch)
{
    /// <summary>What they are against.</summary>
    public GimbalFrame Frame { get; } = frame;

    /// <summary>Right positive.</summary>
    public double Yaw { get; } = yaw;

    /// <summary>Right side down positive.</summary>
    public double Roll { get; } = roll;

    /// <summary>Up positive.</summary>
    public double Pitch { get; } = pitch;

    /// <summary>The turn from looking straight ahead, w first, about the axes of the frame.</summary>
    public FloatArray4 ToQuaternion()
    {
        (double sinPitch, double cosPitch) = (Trig.Sin(Pitch / 2), Trig.Cos(Pitch / 2));
        (double sinRoll, double cosRoll) = (Trig.Sin(Roll / 2), Trig.Cos(Roll / 2));
        (double sinYaw, double cosYaw) = (Trig.Sin(Yaw / 2), Trig.Cos(Yaw / 2));
        var q = default(FloatArray4);
        q[0] = (float)((cosYaw * cosRoll * cosPitch) - (sinYaw * sinRoll * sinPitch));
        q[1] = (float)((cosYaw * sinRoll * cosPitch) - (sinYaw * cosRoll * sinPitch));
        q[2] = (float)((cosYaw * cosRoll * sinPitch) + (sinYaw * sinRoll * cosPitch));
        q[3] = (float)((sinYaw * cosRoll * cosPitch) + (cosYaw * sinRoll * sinPitch));
        return q;
    }

    /// <summary>As gimbals say it: roll and pitch are locked where they are against the horizon.</summary>
    public GimbalDeviceFlags Flags => Frame switch
    {
        GimbalFrame.Heading => GimbalDeviceFlags.RollLock | GimbalDeviceFlags.PitchLock
            | GimbalDeviceFlags.YawInVehicleFrame,
        GimbalFrame.North => GimbalDeviceFlags.RollLock | GimbalDeviceFlags.PitchLock | GimbalDeviceFlags.YawLock
            | GimbalDeviceFlags.YawInEarthFrame,
        _ => GimbalDeviceFlags.YawInVehicleFrame,
    };

    /// <summary>GIMBAL_DEVICE_ATTITUDE_STATUS.</summary>
    public GimbalDeviceAttitudeStatus ToMessage(uint bootMilliseconds) => new()
    {
        TimeBootMs = bootMilliseconds,
        Flags = Flags,
        Q = ToQuaternion(),
        GimbalDeviceId = 1,
    };
}
