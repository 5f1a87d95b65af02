namespace Rabit.Core.Tests.Exploration;

/// <summary>Faults that the exploration of stage marks must find.</summary>
public enum SeededStageFault
{
    None,

    /// <summary>The watchdog marks what it looked at before, though the manager may have moved on.</summary>
    MarkWithoutASwap,

    /// <summary>The manager leaves with a look and a write.</summary>
    LeaveWithoutAnExchange,

    /// <summary>The time is written after the stage that it belongs to.</summary>
    TimeAfterTheStage,

    /// <summary>The watchdog does not look again after it has read the time.</summary>
    OneLook,

    /// <summary>Two stages of the same kind look alike.</summary>
    NoNumber,
}
