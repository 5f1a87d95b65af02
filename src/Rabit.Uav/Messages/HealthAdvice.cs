namespace Rabit.Uav.Messages;

/// <summary>
/// What Health Monitoring advises Mission Control to do, in order of severity, the most severe last. Advice given in
/// flight is not withdrawn.
/// </summary>
public enum HealthAdvice
{
    /// <summary>Carry on.</summary>
    None,

    /// <summary>Abort the mission and return to launch (RTL).</summary>
    ReturnToLaunch,

    /// <summary>Land at the present position.</summary>
    Land,
}
