namespace Rabit.Core.Tests.Exploration;

/// <summary>What a thread does at a synchronisation point.</summary>
internal enum SyncKind
{
    Read,
    Write,
    VolatileRead,
    VolatileWrite,
    Exchange,
    CompareExchange,
    InterlockedRead,
    InterlockedWrite,
    Fence,
    FenceAllThreads,
    StoreBarrier,
    LoadBarrier,
    Set,
    Wait,
    FutexWake,
    FutexWait,
    ReadClock,

    /// <summary>
    /// A remark of the model, no operation of the code: taken at once, together with the operation before it.
    /// </summary>
    Note,

    /// <summary>The same, together with the operation after it.</summary>
    NoteOfNext,

    /// <summary>
    /// A question of the model: the oldest value that a read here might be shown. Taken as a note is.
    /// </summary>
    ReadOldest,

    /// <summary>The thread has ended.</summary>
    End,
}
