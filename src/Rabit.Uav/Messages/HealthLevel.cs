namespace Rabit.Uav.Messages;

/// <summary>Health of the aircraft and its computer, in order of severity.</summary>
public enum HealthLevel
{
    /// <summary>Nothing is known yet.</summary>
    Unknown,

    /// <summary>Nothing is wrong.</summary>
    Good,

    /// <summary>Something is wrong that the operator should know.</summary>
    Warning,

    /// <summary>Something does not work that the mission needs.</summary>
    Critical,
}
