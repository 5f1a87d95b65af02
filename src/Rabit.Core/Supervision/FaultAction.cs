namespace Rabit.Core;

/// <summary>What follows an exception that left a manager's code; see <see cref="FaultPolicy"/>.</summary>
public enum FaultAction
{
    /// <summary>All managers are stopped in order.</summary>
    StopSystem,

    /// <summary>This manager is shut down; the others continue.</summary>
    StopManager,

    /// <summary>This manager is shut down and, after a delay, started up again.</summary>
    Restart,

    /// <summary>This manager continues after a delay, as if nothing had happened.</summary>
    CarryOn,
}
