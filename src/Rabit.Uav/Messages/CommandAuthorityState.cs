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

    /// <summary>The pilot or the autopilot changed the mode: we command no more in this run.</summary>
    TakenAway,
}
