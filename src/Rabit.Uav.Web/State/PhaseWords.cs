using System.Globalization;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Web.State;

/// <summary>A mission in a few words: its phase, and what follows when nothing comes between.</summary>
internal static class PhaseWords
{
    public static string Name(MissionPhase phase) => phase switch
    {
        MissionPhase.NoMission => "observing",
        MissionPhase.WaitingForVehicle => "waiting",
        MissionPhase.Arming => "arming",
        MissionPhase.TakingOff => "take-off",
        MissionPhase.InTransit => "transit",
        MissionPhase.Searching => "searching",
        MissionPhase.Revisiting => "revisit",
        MissionPhase.Holding => "holding",
        MissionPhase.Returning => "returning",
        MissionPhase.Landing => "landing",
        MissionPhase.Done => "done",
        MissionPhase.HandedOver => "handed over",
        MissionPhase.Failed => "failed",
        _ => phase.ToString(),
    };

    /// <returns>Null where nothing follows.</returns>
    public static string? Next(in MissionStatus mission)
    {
        int lanes = (mission.Plan?.Lanes.Length ?? 0) / 2;
        return mission.Phase switch
        {
            MissionPhase.WaitingForVehicle => "arming",
            MissionPhase.Arming => "take-off",
            MissionPhase.TakingOff or MissionPhase.InTransit or MissionPhase.Revisiting
                => Lane(mission.LanesFlown + 1, lanes),
            MissionPhase.Searching => Lane(mission.LanesFlown + 2, lanes),
            MissionPhase.Holding => "the operator's command",
            MissionPhase.Returning => "landing at home",
            MissionPhase.Landing => "motors off",
            _ => null,
        };
    }

    private static string Lane(int lane, int lanes)
        => lane <= lanes ? string.Create(CultureInfo.InvariantCulture, $"lane {lane} of {lanes}") : "the way home";
}
