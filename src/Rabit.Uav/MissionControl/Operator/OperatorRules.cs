using Rabit.Uav.Messages;
using static Rabit.Uav.Messages.MissionPhase;
using static Rabit.Uav.Messages.OperatorCommand;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The table of the operator's commands: which phase refuses which of them, and why. What it does not refuse may still
/// be refused for what holds at the moment: <see cref="OperatorFaults"/>, the failsafes.
/// </summary>
internal static class OperatorRules
{
    /// <summary>Why a phase refuses a command; null where it does not.</summary>
    public static string? FindRefusal(MissionPhase phase, OperatorCommand command) => (phase, command) switch
    {
        (NoMission, _) => "there is no mission",
        (_, Confirm or Reject) => null,
        (Done or Failed, _) => "the mission is over",
        (_, ChangeParameter or OfferArea) => null,
        (HandedOver, OperatorCommand.Hold or Return or Continue) => null,
        (HandedOver, _) => "the command is not ours: hold, return or continue takes it",

        (WaitingForVehicle or Arming, OperatorCommand.Hold or Return or Land or ChangeSpeed) => null,
        (WaitingForVehicle or Arming or TakingOff, Continue) => "nothing was interrupted",
        (WaitingForVehicle or Arming, _) => "it has not taken off",
        (TakingOff, Revisit or RevisitPlace) => "it takes off",

        (Returning or Landing, OperatorCommand.Hold) => null,
        (Returning, Land) => null,
        (Returning, Return) => "it returns already",
        (Landing, Land) => "it lands already",
        (Returning, _) => "it returns: a hold comes first",
        (Landing, _) => "it lands: a hold comes first",

        (InTransit or Searching or Revisiting, Continue) => "nothing was interrupted",
        (Revisiting, Revisit or RevisitPlace) => "a revisit is under way",
        _ => null,
    };

    /// <summary>
    /// Whether a continue takes over an area that was offered, in a phase in which there is nothing else to continue.
    /// </summary>
    public static bool OnlyTakesArea(MissionPhase phase)
        => phase is WaitingForVehicle or Arming or TakingOff or InTransit or Searching or Revisiting;

    /// <summary>Whether a command, once it is allowed, leads to another phase or begins the same one again.</summary>
    public static bool ChangesPhase(MissionPhase phase, OperatorCommand command) => command switch
    {
        Confirm or Reject or ChangeSpeed or ChangeParameter or OfferArea => false,
        SkipLane => phase is InTransit or Searching,
        _ => true,
    };

    /// <summary>The event that a command is.</summary>
    public static MissionStep ToStep(OperatorRequest request) => new(
        request.Command switch
        {
            OperatorCommand.Hold => MissionEvent.OperatorHold,
            Return => MissionEvent.OperatorReturn,
            Land => MissionEvent.OperatorLand,
            SkipLane => MissionEvent.OperatorSkip,
            Revisit or RevisitPlace => MissionEvent.OperatorRevisit,
            _ => MissionEvent.OperatorContinue,
        },
        request.Reason);

    /// <summary>Whether an event is a command of the operator.</summary>
    public static bool IsCommand(MissionEvent what)
        => what is MissionEvent.OperatorHold or MissionEvent.OperatorReturn or MissionEvent.OperatorContinue
            or MissionEvent.OperatorLand or MissionEvent.OperatorSkip or MissionEvent.OperatorRevisit;
}
