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

    /// <summary>Hold the present position.</summary>
    Hold,

    /// <summary>Return to launch (RTL) and land there, by the autopilot's own mode.</summary>
    Return,

    /// <summary>Land at the present position.</summary>
    Land,

    /// <summary>Point the camera's gimbal.</summary>
    PointCamera,
}
