using Rabit.Uav.Messages;
using static Rabit.Uav.Messages.MissionPhase;
using static Rabit.Uav.MissionControl.MissionEvent;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The transition table of the mission: phase and event to next phase. What is not in it changes nothing.
/// </summary>
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
        (Searching, TargetFound) => Revisiting,
        (Revisiting, Revisited) => Searching,
        (Searching, Searched) => Returning,
        (Returning, Descending) => Landing,
        (Returning or Landing, Landed) => Done,

        // Otherwise.
        (TakingOff, Disarmed) => Arming,
        (TakingOff or InTransit or Searching or Revisiting, ReturnToLaunch) => Returning,
        (TakingOff or InTransit or Searching or Revisiting or Returning, LandNow) => Landing,
        _ => phase,
    };
}
