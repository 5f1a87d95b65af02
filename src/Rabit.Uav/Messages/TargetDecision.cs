namespace Rabit.Uav.Messages;

/// <summary>What the operator said about a track.</summary>
public enum TargetDecision
{
    /// <summary>Nothing.</summary>
    None,

    /// <summary>It is a target.</summary>
    Confirmed,

    /// <summary>It is none.</summary>
    Rejected,
}
