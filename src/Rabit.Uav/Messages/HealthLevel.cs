namespace Rabit.Uav.Messages;

/// <summary>How well the aircraft and its computer are, from best to worst.</summary>
public enum HealthLevel
{
    /// <summary>Nothing is known yet.</summary>
    Unknown,

    /// <summary>Nothing to tell.</summary>
    Good,

    /// <summary>Worth a look.</summary>
    Warning,

    /// <summary>Something does not work that the mission needs.</summary>
    Critical,
}
