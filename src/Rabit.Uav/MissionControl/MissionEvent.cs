namespace Rabit.Uav.MissionControl;

/// <summary>What can end a phase; <see cref="MissionTransitions"/> maps it to the next one.</summary>
internal enum MissionEvent
{
    /// <summary>Nothing.</summary>
    None,

    /// <summary>The vehicle is connected, healthy, on the ground and has a position.</summary>
    Ready,

    /// <summary>The pilot of a fixed wing has given it over, in the air.</summary>
    GivenOver,

    /// <summary>A fixed wing is back over home, where its pilot lands it.</summary>
    OverHome,

    /// <summary>The vehicle is armed, and we command.</summary>
    Armed,

    /// <summary>The autopilot disarmed before it left the ground.</summary>
    Disarmed,

    /// <summary>The height of the search is reached.</summary>
    AtHeight,

    /// <summary>The start of the first lane is reached.</summary>
    AtArea,

    /// <summary>There is a confirmed target to revisit.</summary>
    TargetFound,

    /// <summary>The target was revisited.</summary>
    Revisited,

    /// <summary>All lanes are flown, and the gaps that they left.</summary>
    Searched,

    /// <summary>Over home and going down.</summary>
    Descending,

    /// <summary>On the ground, motors off.</summary>
    Landed,

    /// <summary>Abort the search and return to launch (RTL).</summary>
    ReturnToLaunch,

    /// <summary>Hold the position: no progress, or the program stops.</summary>
    Hold,

    /// <summary>Hold the position until the reason of Health Monitoring ends.</summary>
    HealthHold,

    /// <summary>The reason of Health Monitoring to hold has ended.</summary>
    HealthHoldOver,

    /// <summary>The operator commanded to hold.</summary>
    OperatorHold,

    /// <summary>The operator commanded to return.</summary>
    OperatorReturn,

    /// <summary>The operator commanded to continue the mission.</summary>
    OperatorContinue,

    /// <summary>The operator commanded to land at the present position.</summary>
    OperatorLand,

    /// <summary>The operator commanded to leave out a lane.</summary>
    OperatorSkip,

    /// <summary>The operator commanded to revisit a target or a place.</summary>
    OperatorRevisit,

    /// <summary>The vehicle flies already before we commanded it.</summary>
    AlreadyFlying,

    /// <summary>Land at the present position.</summary>
    LandNow,

    /// <summary>The pilot, the autopilot or another commander took over.</summary>
    TakenOver,

    /// <summary>The mission cannot go on.</summary>
    Impossible,
}
