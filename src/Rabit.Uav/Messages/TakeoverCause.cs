namespace Rabit.Uav.Messages;

/// <summary>What took the command of the vehicle away from us.</summary>
public enum TakeoverCause
{
    /// <summary>Nothing did.</summary>
    None,

    /// <summary>The pilot or a ground station changed the flight mode.</summary>
    Mode,

    /// <summary>The autopilot's own failsafe changed the flight mode.</summary>
    Failsafe,

    /// <summary>Another commander sent the vehicle elsewhere in the mode that is ours.</summary>
    OtherCommander,

    /// <summary>The autopilot rebooted in flight.</summary>
    Reboot,
}
