namespace Rabit.Core.Tests.Exploration;

/// <summary>Faults that the exploration of queues must find.</summary>
public enum SeededRingFault
{
    None,

    /// <summary>One value more than the capacity gets in.</summary>
    CapacityOffByOne,

    /// <summary>The receiver is shown a place before its value is written.</summary>
    SequenceBeforeTheValue,

    /// <summary>
    /// Of several values that are pushed at once the last is shown before those in front of it: the receiver, which
    /// looks at the first and at the last, takes one that is not there.
    /// </summary>
    LastBeforeTheOthers,

    /// <summary>The value is written plainly after a sequence that is no release.</summary>
    PlainSequence,

    /// <summary>The receiver takes a value without a look whether it is there.</summary>
    SequenceNotChecked,

    /// <summary>The receiver reads the value before the sequence that says it is there.</summary>
    ValueReadFirst,

    /// <summary>The receiver gives the place back before it has read the value.</summary>
    HeadBeforeTheRead,

    /// <summary>Two senders may take the same place.</summary>
    NoSwap,

    /// <summary>A sender looks for a pending wake before its value is there for all.</summary>
    UnfencedCheckOfThePush,

    /// <summary>The receiver looks for a pending wake of the sender before its pop is there for all.</summary>
    UnfencedCheckOfThePop,

    /// <summary>A sender wakes the receiver only where the queue was empty.</summary>
    WakesOnlyWhenEmpty,
}
