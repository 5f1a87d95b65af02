namespace Rabit.Uav.Messages;

/// <summary>Which part of a pose a <see cref="PoseSample"/> holds.</summary>
public enum PoseSampleKind
{
    /// <summary>Position, height and velocity.</summary>
    Position,

    /// <summary>Attitude and angular velocity.</summary>
    Attitude,

    /// <summary>The attitude that the camera's gimbal reported.</summary>
    Gimbal,
}
