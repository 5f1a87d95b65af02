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
        (NoMission or Done or Failed, _) => phase,

        // The operator's commands; only they lead back to the search.
        (TakingOff or InTransit or Searching or Revisiting or Holding or Returning or Landing or HandedOver,
            OperatorHold) => Holding,
        (TakingOff or InTransit or Searching or Revisiting or Holding or HandedOver, OperatorReturn) => Returning,
        (Holding or HandedOver, OperatorContinue) => InTransit,
        (TakingOff or InTransit or Searching or Revisiting or Holding or Returning, OperatorLand) => Landing,
        (InTransit or Searching, OperatorSkip) => InTransit,
        (InTransit or Searching or Holding, OperatorRevisit) => Revisiting,
        (HandedOver, _) => phase,
        (_, TakenOver) => HandedOver,
        (_, Impossible) => Failed,
        (WaitingForVehicle, AlreadyFlying) => HandedOver,

        // As planned.
        (WaitingForVehicle, Ready) => Arming,
        (Arming, Armed) => TakingOff,
        (WaitingForVehicle, GivenOver) => InTransit,
        (Returning, OverHome) => HandedOver,
        (TakingOff, AtHeight) => InTransit,
        (InTransit, AtArea) => Searching,
        (InTransit or Searching, TargetFound) => Revisiting,
        (Revisiting, Revisited) => Searching,
        (Searching, Searched) => Returning,
        (Returning, Descending) => Landing,
        (Returning or Landing, Landed) => Done,

        // Otherwise.
        (TakingOff, Disarmed) => Arming,
        (TakingOff or InTransit or Searching or Revisiting, MissionEvent.Hold or HealthHold) => Holding,
        (Holding, HealthHoldOver) => InTransit,
        (TakingOff or InTransit or Searching or Revisiting or Holding, ReturnToLaunch) => Returning,
        (TakingOff or InTransit or Searching or Revisiting or Holding or Returning, LandNow) => Landing,
        _ => phase,
    };
}
