namespace Rabit.Uav.Messages;

/// <summary>Who commands the vehicle.</summary>
public enum CommandAuthorityState
{
    /// <summary>We only observe, and refuse every command.</summary>
    Observing,

    /// <summary>We may command, and have not yet.</summary>
    Free,

    /// <summary>We command.</summary>
    Ours,

    /// <summary>
    /// The pilot, another commander or the autopilot took the command away: nothing is sent until the operator gives it
    /// back (<see cref="VehicleCommandKind.TakeControl"/>).
    /// </summary>
    TakenAway,
}
