namespace Rabit.Uav.Simulation;

/// <summary>What the motors do.</summary>
internal enum MotorState
{
    /// <summary>They stand still.</summary>
    Off,

    /// <summary>They turn without lifting.</summary>
    Idle,

    /// <summary>They carry the vehicle.</summary>
    Flying,
}
