using Rabit.Uav.Messages;
using static Rabit.Uav.Messages.MissionPhase;
using static Rabit.Uav.MissionControl.MissionEvent;

namespace Rabit.Uav.MissionControl;

/// <summary>The mission at a glance: in which phase what leads where. What is not here changes nothing.</summary>
internal static class MissionTransitions
{
    public static MissionPhase After(MissionPhase phase, MissionEvent what) => (phase, what) switch
    {
        (NoMission or Done or HandedOver or Failed, _) => phase,
        (_, TakenOver) => HandedOver,
        (_, Impossible) => Failed,

        // As planned.
        (WaitingForVehicle, Ready) => Arming,
        (Arming, Armed) => TakingOff,
        (TakingOff, AtHeight) => InTransit,
        (InTransit, AtArea) => Searching,
        (Searching, TargetFound) => Looking,
        (Looking, Looked) => Searching,
        (Searching, Searched) => Returning,
        (Returning, Descending) => Landing,
        (Returning or Landing, Landed) => Done,

        // Otherwise.
        (TakingOff, Disarmed) => Arming,
        (TakingOff or InTransit or Searching or Looking, ReturnToLaunch) => Returning,
        (TakingOff or InTransit or Searching or Looking or Returning, LandNow) => Landing,
        _ => phase,
    };
}
