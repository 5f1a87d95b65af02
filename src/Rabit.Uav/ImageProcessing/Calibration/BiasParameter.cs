namespace Rabit.Uav.ImageProcessing.Calibration;

/// <summary>What may be wrong in the same way in all observations of a flight.</summary>
public enum BiasParameter
{
    /// <summary>Misalignment of the mount about forward, radians.</summary>
    MountRoll,

    /// <summary>Misalignment of the mount about right, radians.</summary>
    MountPitch,

    /// <summary>Misalignment of the mount about down, radians.</summary>
    MountYaw,

    /// <summary>Roll of the autopilot less the true one, radians.</summary>
    AttitudeRoll,

    /// <summary>Pitch of the autopilot less the true one, radians.</summary>
    AttitudePitch,

    /// <summary>Yaw of the autopilot less the true one, radians.</summary>
    AttitudeYaw,

    /// <summary>Time stamps of the pictures, by the poses' clock, less the true ones, seconds.</summary>
    Time,

    /// <summary>
    /// North of the autopilot less the true one, metres: no observation of unknown points can ever determine it.
    /// </summary>
    North,

    /// <summary>
    /// East of the autopilot less the true one, metres: no observation of unknown points can ever determine it.
    /// </summary>
    East,

    /// <summary>Down of the autopilot less the true one, against the ground's, metres.</summary>
    Down,
}
