using System;
using System.Globalization;
using System.IO;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;
using Rabit.Uav.Simulation;

namespace UavConsole;

/// <summary>Writes the summary of a group for people.</summary>
internal static class GroupSummaryText
{
    public static void Write(TextWriter output, GroupFlightSummary summary)
    {
        output.WriteLine($"--- summary of {FlightText.Number((long)summary.Vehicles.Count)} vehicles ---");
        output.WriteLine("mission: " + (summary.HasPassed ? "ACCOMPLISHED" : "FAILED"));
        foreach (string failure in summary.Failures)
            output.WriteLine("  failed: " + failure);
        foreach (string remark in summary.Remarks)
            output.WriteLine("  " + remark);
        output.WriteLine(string.Format(
            CultureInfo.InvariantCulture, "{0} from the first take-off to the last landing, {1:0.0} % of the area seen",
            FlightText.Clock(summary.FlightTime), summary.Coverage * 100));
        MissionScore score = summary.Score!; // the truth of a simulation is known
        output.WriteLine(string.Format(
            CultureInfo.InvariantCulture, "{0} of {1} targets found, {2} false{3}{4}", score.Found,
            score.Targets.Count, score.FalseTracks.Count,
            FlightText.RejectedTracks(score) + FlightText.IdentitySwitches(score),
            score.Found == 0 ? string.Empty : $"; {FlightText.Number(score.RmseMetres, "0.0")} m RMS"));
        foreach (ValidationTask task in summary.Validations)
            output.WriteLine(Of(task, summary.PositionOf(task)));
        foreach (FollowTask task in summary.Followings)
        {
            output.WriteLine($"{task.Class}, of a class that moves: found by vehicle "
                + $"{FlightText.Number((long)task.Finder)}, followed: {summary.DescribeFollowing(task)}");
        }

        foreach (TargetTrack track in summary.NotFollowed)
            output.WriteLine($"{At(track.Class, track.Position)}, of a class that moves: NOT FOLLOWED");

        foreach (GroupVehicleSummary vehicle in summary.Vehicles)
            output.WriteLine(Of(vehicle));
    }

    /// <summary>Two vehicles that came too near to each other.</summary>
    public static string Of(Separation pair) => string.Format(
        CultureInfo.InvariantCulture,
        "vehicles {0} and {1} were {2:0.0} m apart over ground and {3:0.0} m in height at {4}",
        pair.First + 1, pair.Second + 1, pair.HorizontalMetres, pair.VerticalMetres, FlightText.Clock(pair.Time));

    private static string At(TargetClassName name, GeodeticPosition position) => string.Format(
        CultureInfo.InvariantCulture, "{0} at {1:0.000000} {2:0.000000}", name, position.Latitude.Degrees,
        position.Longitude.Degrees);

    private static string Of(in ValidationTask task, GeodeticPosition position)
    {
        string found = $"{At(task.Class, position)}: found by vehicle {FlightText.Number((long)task.Finder)}, ";
        return found + (task.IsRejectedByOperator ? "rejected by the operator"
            : task.State == ValidationState.Closed
            ? $"by vehicle {FlightText.Number(task.Validator)} {task.Result.ToString().ToLowerInvariant()}"
            : "NOT VALIDATED");
    }

    private static string Of(GroupVehicleSummary vehicle)
    {
        MissionSummary mission = vehicle.Flight.Mission!;
        RadioUse radio = vehicle.Radio!;
        return string.Format(
            CultureInfo.InvariantCulture,
            "vehicle {0}: {1}, {2} flown, {3} m, motors on for {4}, {5} % of the battery; radio {6} frames, {7} kbit/s",
            vehicle.SystemId, FlightText.Phase(mission.Phase),
            mission.LanesFlown == 1 ? "1 lane" : $"{FlightText.Number((long)mission.LanesFlown)} lanes",
            FlightText.Number(mission.FlownMetres, "0"), FlightText.Clock(mission.FlightTime),
            FlightText.Number(mission.BatteryUsedPercent, "0"), radio.FramesSent,
            FlightText.Number(radio.KilobitsPerSecond, "0.00"));
    }
}
