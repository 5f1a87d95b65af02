using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>How the phases of a mission are named and coloured.</summary>
internal static class PhaseStyle
{
    public static string Name(MissionPhase phase) => phase switch
    {
        MissionPhase.NoMission => "no mission",
        MissionPhase.WaitingForVehicle => "waiting",
        MissionPhase.Arming => "arming",
        MissionPhase.TakingOff => "take-off",
        MissionPhase.InTransit => "transit",
        MissionPhase.Searching => "searching",
        MissionPhase.Revisiting => "second look",
        MissionPhase.Returning => "returning",
        MissionPhase.Landing => "landing",
        MissionPhase.Done => "done",
        MissionPhase.HandedOver => "handed over",
        MissionPhase.Failed => "failed",
        _ => phase.ToString(),
    };

    /// <summary>Whether the vehicle is in the air, as far as Mission Control knows.</summary>
    public static bool IsFlown(MissionPhase phase) => phase is not (MissionPhase.WaitingForVehicle or MissionPhase.Arming or MissionPhase.Done);

    /// <summary>The class of the style sheet that has its colour.</summary>
    public static string Class(MissionPhase phase) => phase switch
    {
        MissionPhase.TakingOff => "p-takeoff",
        MissionPhase.InTransit => "p-transit",
        MissionPhase.Searching => "p-search",
        MissionPhase.Revisiting => "p-look",
        MissionPhase.Returning => "p-return",
        MissionPhase.Landing => "p-land",
        MissionPhase.HandedOver => "p-handed",
        MissionPhase.Failed => "p-failed",
        _ => "p-idle",
    };
}
