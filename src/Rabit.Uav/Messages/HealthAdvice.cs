namespace Rabit.Uav.Messages;

/// <summary>
/// What Health Monitoring advises Mission Control to do, in order of severity, the most severe last; of several at once
/// the more severe is given. To return and to land are not withdrawn in flight; to hold ends with its reason.
/// </summary>
public enum HealthAdvice
{
    /// <summary>Carry on.</summary>
    None,

    /// <summary>Hold the position until the reason ends, and continue then.</summary>
    Hold,

    /// <summary>Abort the mission and return to launch (RTL).</summary>
    ReturnToLaunch,

    /// <summary>Land at the present position.</summary>
    Land,
}
