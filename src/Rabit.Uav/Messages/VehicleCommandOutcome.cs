namespace Rabit.Uav.Messages;

/// <summary>What became of a command.</summary>
public enum VehicleCommandOutcome
{
    /// <summary>
    /// The autopilot took it, and does it now. That the vehicle has arrived is to be seen in its state.
    /// </summary>
    Accepted,

    /// <summary>The autopilot refused it, or we did: it is not possible here.</summary>
    Refused,

    /// <summary>The autopilot did not answer, however often it was asked.</summary>
    TimedOut,

    /// <summary>A newer command came before it was done.</summary>
    Replaced,

    /// <summary>The pilot or the autopilot has taken over, or we only observe: nothing was sent.</summary>
    NotInCommand,
}
