using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;

namespace UavConsole;

/// <summary>The words of the views of a group.</summary>
internal static class GroupText
{
    /// <summary>The names of what <see cref="Row"/> shows.</summary>
    public static string Head { get; }
        = Line("vehicle", "phase", "lanes", "m left", "seen", "height", "battery", "what it does");

    /// <summary>One vehicle in a line.</summary>
    public static string Row(GroupVehicle vehicle)
    {
        string name = FlightText.Number(vehicle.Simulated.SystemId);
        if (!vehicle.HasStarted)
            return Line(name, "-", "-", "-", "-", "-", "-", "not switched on yet");
        MissionStatus mission = vehicle.Mission;
        VehicleState state = vehicle.Monitor.Vehicle;
        return Line(
            name,
            FlightText.Phase(mission.Phase),
            Lanes(vehicle.Group.OwnShare),
            FlightText.Number(vehicle.Group.OwnMetresLeft, "0"),
            FlightText.Number(mission.Coverage * 100, "0' %'"),
            state.PositionTime is null ? "-" : FlightText.Number(state.HeightAboveHomeMetres, "0' m'"),
            state.BatteryTime is null ? "-" : FlightText.Number(state.BatteryRemaining * 100, "0' %'"),
            FlightText.Printable(mission.Text ?? string.Empty));
    }

    /// <summary>The lines of all logs that are new, in the order of their times.</summary>
    public static IEnumerable<string> TakeLog(GroupFlight flight)
        => flight.Vehicles.Select(v => v.Log).Append(flight.Station.Log).SelectMany(l => l.TakeAll())
            .Select((line, i) => (line, i))
            .OrderBy(l => TimeOf(l.line), StringComparer.Ordinal).ThenBy(l => l.i).Select(l => l.line);

    private static string Line(
        string vehicle, string phase, string lanes, string left, string seen, string height, string battery,
        string text)
        => $"{vehicle,-8}{phase,-14}{lanes,-9}{left,8}{seen,7}{height,9}{battery,9}  {text}".TrimEnd();

    private static string Lanes(LaneShare share) => share.SystemId == 0 ? "-"
        : share.Count == 0 ? "none"
        : share.Count == 1 ? FlightText.Number(share.First + 1)
        : FlightText.Number(share.First + 1) + "-" + FlightText.Number(share.First + share.Count);

    // "vehicle 1:     5.400000 mission control: ...": the times are all of one width.
    private static string TimeOf(string line)
    {
        const int Width = 13;
        int begin = line.IndexOf(':') + 2;
        return begin + Width > line.Length ? string.Empty : line.Substring(begin, Width);
    }
}
