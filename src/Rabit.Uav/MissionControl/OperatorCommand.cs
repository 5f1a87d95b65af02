namespace Rabit.Uav.MissionControl;

/// <summary>What the operator can command in flight.</summary>
public enum OperatorCommand
{
    /// <summary>Hold the position until the next command.</summary>
    Hold,

    /// <summary>Return to launch (RTL) and land there: the mission is given up.</summary>
    Return,

    /// <summary>
    /// Continue the mission where it was interrupted by a hold, a return at the operator's command followed by a hold,
    /// or a takeover.
    /// </summary>
    Resume,
}
