using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;

namespace UavConsole;

/// <summary>The words of the views of a group.</summary>
internal static class GroupText
{
    private const string Form = "{0,-10}{1,-14}{2,-9}{3,8}{4,7}{5,9}{6,9}  {7}";

    /// <summary>The names of what <see cref="Row"/> shows.</summary>
    public static string Head { get; } = string.Format(
        CultureInfo.InvariantCulture, Form, "vehicle", "phase", "lanes", "m left", "seen", "height", "battery",
        "what it does").TrimEnd();

    /// <summary>One vehicle in a line.</summary>
    public static string Row(GroupVehicle vehicle)
    {
        string name = FlightText.Number(vehicle.Simulated.SystemId);
        if (!vehicle.Simulated.HasStarted)
            return string.Format(CultureInfo.InvariantCulture, "{0,-10}not switched on yet", name);
        MissionStatus mission = vehicle.Mission;
        VehicleState state = vehicle.Monitor.Vehicle;
        return string.Format(
            CultureInfo.InvariantCulture, Form, name, FlightText.Phase(mission.Phase), Lanes(vehicle.Group.OwnShare),
            FlightText.Number(vehicle.Group.OwnMetresLeft, "0"), FlightText.Number(mission.Coverage * 100, "0' %'"),
            state.PositionTime is null ? "-" : FlightText.Number(state.HeightAboveHomeMetres, "0' m'"),
            state.BatteryTime is null ? "-" : FlightText.Number(state.BatteryRemaining * 100, "0' %'"),
            vehicle.Simulated.IsLost ? "LOST" : FlightText.Printable(mission.Text ?? string.Empty)).TrimEnd();
    }

    /// <summary>The lines of all logs that are new, in the order of their times.</summary>
    public static IEnumerable<string> TakeLog(GroupFlight flight)
        => flight.Vehicles.SelectMany(v => v.Log.TakeAll()).Select((line, i) => (line, i))
            .OrderBy(l => TimeOf(l.line), StringComparer.Ordinal).ThenBy(l => l.i).Select(l => l.line);

    private static string Lanes(LaneShare share) => share.SystemId == 0 ? "-"
        : share.Count == 0 ? "none"
        : FlightText.Number(share.First + 1) + "-" + FlightText.Number(share.First + share.Count);

    // "vehicle 1:     5.400000 mission control: ...": the times are all of one width.
    private static string TimeOf(string line)
    {
        const int Width = 13;
        int begin = line.IndexOf(':') + 2;
        return begin + Width > line.Length ? string.Empty : line.Substring(begin, Width);
    }
}
