namespace Rabit.Core.Reactors;

/// <summary>What a request to stop led to.</summary>
internal enum StopStep
{
    /// <summary>Nothing: the stop was requested before.</summary>
    None,

    /// <summary>The stop waits for managers that delay it: the caller wakes all managers.</summary>
    Delayed,

    /// <summary>The run stops: the caller lets the engine know.</summary>
    Stops,
}
