namespace Rabit.Uav.ImageProcessing.Geolocation;

/// <summary>What a position on the ground is computed from, each of which may be wrong.</summary>
internal enum ViewingParameter
{
    /// <summary>The vehicle's position, metres.</summary>
    North,

    /// <summary>The vehicle's position, metres.</summary>
    East,

    /// <summary>The vehicle's position, metres; the ground stays.</summary>
    Down,

    /// <summary>The vehicle's roll, radians.</summary>
    Roll,

    /// <summary>The vehicle's pitch, radians.</summary>
    Pitch,

    /// <summary>The vehicle's yaw, radians.</summary>
    Yaw,

    /// <summary>The misalignment of the mount, radians.</summary>
    MountRoll,

    /// <summary>The misalignment of the mount, radians.</summary>
    MountPitch,

    /// <summary>The misalignment of the mount, radians.</summary>
    MountYaw,

    /// <summary>The gimbal's yaw, radians.</summary>
    GimbalYaw,

    /// <summary>The gimbal's pitch, radians.</summary>
    GimbalPitch,

    /// <summary>The place in the picture, pixels.</summary>
    Column,

    /// <summary>The place in the picture, pixels.</summary>
    Row,

    /// <summary>The height of the ground, metres, up positive.</summary>
    GroundHeight,

    /// <summary>The time of the picture, seconds, later positive.</summary>
    Time,

    /// <summary>The focal length, as a part of it.</summary>
    FocalLength,
}
