namespace Rabit.Uav.MissionControl;

/// <summary>What happened that may change what is being done; <see cref="MissionTransitions"/> says to what.</summary>
internal enum MissionEvent
{
    /// <summary>Nothing.</summary>
    None,

    /// <summary>The vehicle is heard, healthy, on the ground and knows where it is.</summary>
    Ready,

    /// <summary>The motors may turn, and we command.</summary>
    Armed,

    /// <summary>The autopilot stopped the motors before it ever left the ground.</summary>
    Disarmed,

    /// <summary>The height of the search is reached.</summary>
    AtHeight,

    /// <summary>The first lane begins here.</summary>
    AtArea,

    /// <summary>There is a new target to look at.</summary>
    TargetFound,

    /// <summary>It has been looked at.</summary>
    Looked,

    /// <summary>All lanes are flown, and what they missed.</summary>
    Searched,

    /// <summary>Over home and going down.</summary>
    Descending,

    /// <summary>On the ground, motors off.</summary>
    Landed,

    /// <summary>Give up the search and come home.</summary>
    ReturnToLaunch,

    /// <summary>Land here and now.</summary>
    LandNow,

    /// <summary>Somebody else commands.</summary>
    TakenOver,

    /// <summary>The mission cannot go on.</summary>
    Impossible,
}
