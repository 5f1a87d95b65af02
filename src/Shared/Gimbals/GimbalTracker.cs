using System;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// The attitude of the camera's gimbal by GIMBAL_DEVICE_ATTITUDE_STATUS or MOUNT_ORIENTATION: of the first gimbal of
/// the vehicle that reports one, until it is silent. For one thread.
/// </summary>
/// <remarks>Compiled by Rabit.Uav, and by the tool for recorded logs.</remarks>
internal sealed class GimbalTracker
{
    // What a gimbal with such an error says of its attitude is not trusted; a limit or a motor is no such error.
    private const GimbalDeviceErrorFlags Unusable = GimbalDeviceErrorFlags.EncoderError
        | GimbalDeviceErrorFlags.SoftwareError | GimbalDeviceErrorFlags.CommsError
        | GimbalDeviceErrorFlags.CalibrationRunning;

    private const double MaxNormError = 0.01;

    private static readonly TimeSpan SilentAfter = TimeSpan.FromSeconds(5);

    private Source? _source;
    private TimeSpan _lastTime;

    /// <summary>The last attitude.</summary>
    public GimbalAttitude Attitude { get; private set; }

    /// <summary>When it was true, by the clock of its sender; 0 where that does not say it.</summary>
    public uint BootTimeMs { get; private set; }

    /// <param name="frame">A frame of our vehicle.</param>
    /// <param name="status">Its message.</param>
    public GimbalUpdate Take(in LinkFrame frame, in GimbalDeviceAttitudeStatus status)
    {
        FloatArray4 q = status.Q;
        double norm = Math.Sqrt((q[0] * q[0]) + (q[1] * q[1]) + (q[2] * q[2]) + (q[3] * q[3]));
        if (!(Math.Abs(norm - 1) < MaxNormError) || (status.FailureFlags & Unusable) != 0)
            return GimbalUpdate.Refused;
        if (!IsOurs(new Source(frame.Frame.ComponentId, status.GimbalDeviceId, IsDevice: true), frame.Time))
            return GimbalUpdate.OfOther;
        BootTimeMs = status.TimeBootMs;
        Attitude = new GimbalAttitude(
            Rotation.FromQuaternion(q[0], q[1], q[2], q[3]).ToEuler(), FrameOf(status.Flags));
        return GimbalUpdate.Taken;
    }

    /// <summary>As the other. Its roll and pitch are against the horizon.</summary>
    /// <param name="frame">A frame of our vehicle.</param>
    /// <param name="mount">Its message.</param>
    public GimbalUpdate Take(in LinkFrame frame, in MountOrientation mount)
    {
        // Zero is also what a sender that does not know the field sends; against the heading it is the same direction.
        bool isAbsolute = !float.IsNaN(mount.YawAbsolute) && mount.YawAbsolute != 0;
        var angles = EulerAngles.FromDegrees(mount.Roll, mount.Pitch, isAbsolute ? mount.YawAbsolute : mount.Yaw);
        if (!angles.IsFinite)
            return GimbalUpdate.Refused;
        if (!IsOurs(new Source(frame.Frame.ComponentId, Device: 0, IsDevice: false), frame.Time))
            return GimbalUpdate.OfOther;
        BootTimeMs = mount.TimeBootMs;
        Attitude = new GimbalAttitude(angles, isAbsolute ? GimbalFrame.North : GimbalFrame.Heading);
        return GimbalUpdate.Taken;
    }

    // The common message set says it of yaw. Of roll and pitch it says that they are against the horizon where they are
    // locked to it, and else against the vehicle.
    private static GimbalFrame FrameOf(GimbalDeviceFlags flags)
    {
        const GimbalDeviceFlags Said = GimbalDeviceFlags.YawInVehicleFrame | GimbalDeviceFlags.YawInEarthFrame;
        bool isNorth = (flags & Said) == 0
            ? (flags & GimbalDeviceFlags.YawLock) != 0
            : (flags & GimbalDeviceFlags.YawInEarthFrame) != 0;
        if (isNorth)
            return GimbalFrame.North;
        return (flags & (GimbalDeviceFlags.RollLock | GimbalDeviceFlags.PitchLock)) != 0
            ? GimbalFrame.Heading
            : GimbalFrame.Body;
    }

    // One gimbal may send both messages, of which the newer kind says more; a vehicle may have several gimbals.
    private bool IsOurs(Source source, TimeSpan time)
    {
        if (_source is { } known && known != source && time - _lastTime < SilentAfter
            && (known.IsDevice || !source.IsDevice))
            return false;
        (_source, _lastTime) = (source, time);
        return true;
    }

    private readonly record struct Source(byte Component, byte Device, bool IsDevice);
}
