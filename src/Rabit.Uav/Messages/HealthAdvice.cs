namespace Rabit.Uav.Messages;

/// <summary>What Health Monitoring asks of Mission Control, the gravest last. It does not take back what it once asked.</summary>
public enum HealthAdvice
{
    /// <summary>Carry on.</summary>
    None,

    /// <summary>Give the search up and come home.</summary>
    ReturnToLaunch,

    /// <summary>Land where you are.</summary>
    Land,
}
