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
    Fence,
    Set,
    Wait,
    FutexWake,
    FutexWait,
    ReadClock,

    /// <summary>A remark of the model, no operation of the code: taken at once, together with the operation before it.</summary>
    Note,

    /// <summary>The thread has ended.</summary>
    End,
}
