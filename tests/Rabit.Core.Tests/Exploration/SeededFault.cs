namespace Rabit.Core.Tests.Exploration;

/// <summary>A fault that is put into <see cref="FaultyWakeUp"/>, for the explorer to find.</summary>
public enum SeededFault
{
    /// <summary>None: what is left is right.</summary>
    None,

    /// <summary>The causes are read before the turn, and cleared after it.</summary>
    FlagClearedAfterTheWork,

    /// <summary>
    /// They are cleared by a plain write, which may come to light when the turn has read already: rabitcpp does it so.
    /// </summary>
    FlagClearedByAPlainWrite,

    /// <summary>The sleeper is signalled first and finds the cause too late.</summary>
    FlagSetAfterTheSignal,

    /// <summary>The sleeper marks itself asleep and waits, without another check of the causes.</summary>
    WaitWithoutRecheck,

    /// <summary>A wake before the start-up barrier opens is forgotten.</summary>
    WakeDroppedDuringStartup,

    /// <summary>A waker that reads that its cause is set already returns, without a fence.</summary>
    UnfencedAlreadySetRead,

    /// <summary>A stop waits for the timer.</summary>
    StopWithoutASignal,

    /// <summary>Each wake is a unit of work of its own.</summary>
    WakesThatStack,
}
