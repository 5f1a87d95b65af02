namespace Rabit.Core;

/// <summary>What a log entry is about.</summary>
public enum RabitLogKind
{
    /// <summary>A manager or the system started or stopped.</summary>
    Lifecycle,

    /// <summary>A unit of work begins; only with <see cref="ReactorOptions.LogRuns"/>.</summary>
    Run,

    /// <summary>An exception left user code.</summary>
    Fault,

    /// <summary>Something worth a look that is no fault.</summary>
    Note,

    /// <summary>A manager's own words, by <see cref="RabitManager.Log"/>.</summary>
    Manager,

    /// <summary>A manager was found to hang, or has returned.</summary>
    Hang,
}
