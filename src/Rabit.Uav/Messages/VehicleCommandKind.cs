namespace Rabit.Uav.Messages;

/// <summary>What a vehicle can be commanded to do.</summary>
public enum VehicleCommandKind
{
    /// <summary>Nothing; never sent.</summary>
    None,

    /// <summary>Enter the flight mode for offboard commands (GUIDED of ArduPilot), and arm.</summary>
    Arm,

    /// <summary>Stop the motors; on the ground only.</summary>
    Disarm,

    /// <summary>Enter a flight mode by name.</summary>
    SetMode,

    /// <summary>Climb straight up to a height above home.</summary>
    TakeOff,

    /// <summary>Fly to a position and hold it.</summary>
    GoTo,

    /// <summary>Fly with a velocity.</summary>
    Velocity,

    /// <summary>
    /// Hold where braking ends: ArduPilot in GUIDED at the stopping point (BRAKE where the position is not known), PX4
    /// in AUTO.LOITER.
    /// </summary>
    Hold,

    /// <summary>Return to launch (RTL) and land there, by the autopilot's own mode.</summary>
    Return,

    /// <summary>Land at the present position.</summary>
    Land,

    /// <summary>Point the camera's gimbal.</summary>
    PointCamera,

    /// <summary>
    /// The operator gives the command of the vehicle to us: the mode reported next counts as ours. Mission Control
    /// sends it on the operator's word and never by itself.
    /// </summary>
    TakeControl,
}
