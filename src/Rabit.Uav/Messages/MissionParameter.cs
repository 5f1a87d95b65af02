namespace Rabit.Uav.Messages;

/// <summary>
/// A value of the mission that the operator can change. Each holds from the next leg on; what it may be is what it may
/// be in the mission file (docs/mission-file.md).
/// </summary>
public enum MissionParameter
{
    /// <summary>Height of the search above home, metres.</summary>
    Height,

    /// <summary>Ground speed, metres per second.</summary>
    Speed,

    /// <summary>Maximum distance between lanes, metres: what is left is planned again.</summary>
    LaneSpacing,

    /// <summary>Whether confirmed targets are revisited: 1, or 0.</summary>
    Revisits,

    /// <summary>Height of revisits above home, metres; 0 for that of the search.</summary>
    RevisitHeight,

    /// <summary>Distance from the target at which the pass over it begins and turns back, metres.</summary>
    RevisitRadius,

    /// <summary>
    /// Fraction of the battery that must remain at the start. Until the take-off, and no lower than in the mission
    /// file, which the pre-flight checklist judges by.
    /// </summary>
    BatteryAtStart,

    /// <summary>Fraction of the true charge of the battery that is to be left after the landing.</summary>
    EnergyReserve,

    /// <summary>Fraction of the area that must have been seen for the mission to be accomplished.</summary>
    RequiredCoverage,
}
