namespace Rabit.Core;

/// <summary>Where a manager is in its life.</summary>
public enum ManagerState
{
    /// <summary>Wired, not yet started.</summary>
    Created,

    /// <summary>Started up, or about to be; waits for the other managers.</summary>
    Starting,

    /// <summary>Runs units of work.</summary>
    Running,

    /// <summary>A fault ended its units of work, or put them off; see the fault policy.</summary>
    Faulted,

    /// <summary>Shut down.</summary>
    Stopped,

    /// <summary>Shut down after a fault, and waits for its next start-up; see the fault policy.</summary>
    Restarting,

    /// <summary>Does not return from its code; posted by the watchdog in its place.</summary>
    Hanging,
}
