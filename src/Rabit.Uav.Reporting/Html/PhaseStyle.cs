using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting.Html;

/// <summary>How the phases of a mission are coloured.</summary>
internal static class PhaseStyle
{
    /// <summary>Whether the vehicle is in the air, as far as Mission Control knows.</summary>
    public static bool IsFlown(MissionPhase phase)
        => phase is not (MissionPhase.WaitingForVehicle or MissionPhase.Arming or MissionPhase.Done);

    /// <summary>The class of the style sheet that has its colour.</summary>
    public static string Class(MissionPhase phase) => phase switch
    {
        MissionPhase.TakingOff => "p-takeoff",
        MissionPhase.InTransit => "p-transit",
        MissionPhase.Searching => "p-search",
        MissionPhase.Revisiting => "p-revisit",
        MissionPhase.Holding => "p-handed",
        MissionPhase.Returning => "p-return",
        MissionPhase.Landing => "p-land",
        MissionPhase.HandedOver => "p-handed",
        MissionPhase.Failed => "p-failed",
        _ => "p-idle",
    };
}
