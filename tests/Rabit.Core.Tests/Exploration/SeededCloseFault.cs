namespace Rabit.Core.Tests.Exploration;

/// <summary>Faults that the exploration of the close of a queue with one sender must find.</summary>
public enum SeededCloseFault
{
    None,

    /// <summary>What is left is counted before the queue is closed.</summary>
    CountersBeforeTheClose,

    /// <summary>The close leaves the tail to the sender: each goes by the tail that it sees itself.</summary>
    TailNotSettled,

    /// <summary>Who settles the tail makes no fence on all threads before it reads it.</summary>
    NoFenceOnAllThreads,

    /// <summary>The counters go by the tail alone, which the sender moves after the close too.</summary>
    CountersByTheTail,

    /// <summary>A push that has moved the tail does not look whether the queue was closed meanwhile.</summary>
    NoLookOfThePush,

    /// <summary>A push that finds the queue closed counts, whatever was settled.</summary>
    AlwaysInTime,

    /// <summary>The sender shows a value before it has moved the tail.</summary>
    SequenceBeforeTheTail,

    /// <summary>The receiver takes what it finds, of a closed queue too.</summary>
    ReceiverBySequenceAlone,

    /// <summary>The receiver looks whether the tail is settled, instead of whether the queue is closed.</summary>
    ReceiverLooksForTheSettledTail,

    /// <summary>The tail is moved for each value of a batch, and looked at for all of them.</summary>
    BatchMovesTheTailOneByOne,

    /// <summary>A batch that is taken out of a closed queue goes by its first value.</summary>
    BatchByItsFirstValue,

    /// <summary>A batch is taken out by a look at the close that comes before the one at the values.</summary>
    BatchLooksForTheCloseFirst,
}
