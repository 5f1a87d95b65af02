namespace Rabit.Core;

/// <summary>How a manager ended.</summary>
public enum ManagerOutcome
{
    /// <summary>It never began, because the run was stopped before.</summary>
    NotStarted,

    /// <summary>It shut down, and threw nothing all the time.</summary>
    Ended,

    /// <summary>It shut down, and threw at least once.</summary>
    Faulted,

    /// <summary>It threw, and its fault policy stopped it alone, before the run was stopped.</summary>
    StoppedAlone,

    /// <summary>It did not stop in time; its thread may still run.</summary>
    DidNotStop,
}
