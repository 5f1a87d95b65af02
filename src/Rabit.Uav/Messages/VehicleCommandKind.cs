namespace Rabit.Uav.Messages;

/// <summary>What a vehicle can be told to do.</summary>
public enum VehicleCommandKind
{
    /// <summary>Nothing; never sent.</summary>
    None,

    /// <summary>Take the flight mode that lets us command (GUIDED of ArduPilot), and arm.</summary>
    Arm,

    /// <summary>Stop the motors; on the ground only.</summary>
    Disarm,

    /// <summary>Take a flight mode by name.</summary>
    SetMode,

    /// <summary>Climb straight up to a height above home.</summary>
    TakeOff,

    /// <summary>Fly to a place and stay there.</summary>
    GoTo,

    /// <summary>Fly with a velocity.</summary>
    Velocity,

    /// <summary>Stay where you are.</summary>
    Hold,

    /// <summary>Return to home and land there, by the autopilot's own means.</summary>
    Return,

    /// <summary>Land where you are.</summary>
    Land,

    /// <summary>Turn the camera's gimbal.</summary>
    PointCamera,
}
