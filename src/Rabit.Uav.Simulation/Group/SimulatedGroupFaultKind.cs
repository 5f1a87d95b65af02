namespace Rabit.Uav.Simulation;

/// <summary>What goes wrong with a whole vehicle of a simulated group.</summary>
public enum SimulatedGroupFaultKind
{
    /// <summary>Vehicle and companion computer are gone: nothing of it runs any more.</summary>
    Lost,

    /// <summary>Its radio to the others has failed; it flies on.</summary>
    RadioDead,

    /// <summary>It is switched on only then.</summary>
    SwitchedOn,

    /// <summary>
    /// It has the system id of the vehicle before it, the first one that of the second: from the start, whatever its
    /// time is.
    /// </summary>
    SameSystemId,
}
