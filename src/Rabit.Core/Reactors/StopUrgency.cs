namespace Rabit.Core.Reactors;

/// <summary>What a request to stop does to managers that delay it.</summary>
internal enum StopUrgency
{
    /// <summary>It waits for them, and ends no delay: a fault, a hang, a manager's request.</summary>
    Waits,

    /// <summary>It waits for them; when it comes during a delay it ends it: a signal, a call from outside.</summary>
    EndsDelay,

    /// <summary>It never waits: the run itself has failed.</summary>
    AtOnce,
}
