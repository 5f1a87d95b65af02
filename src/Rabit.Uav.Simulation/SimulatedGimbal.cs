namespace Rabit.Uav.Simulation;

/// <summary>
/// What holds the simulated camera. Each kind can be pointed, at most 60 degrees a second, and reports its attitude as
/// GIMBAL_DEVICE_ATTITUDE_STATUS where that is asked for, with the flags of its frame.
/// </summary>
public enum SimulatedGimbal
{
    /// <summary>The angles are against the body: the camera rolls and pitches with the vehicle.</summary>
    AgainstBody,

    /// <summary>Roll and pitch are held against the horizon; the yaw follows the vehicle's heading.</summary>
    FollowsHeading,

    /// <summary>
    /// Roll and pitch are held against the horizon, the yaw against north, whichever way the vehicle turns.
    /// </summary>
    HoldsNorth,
}
