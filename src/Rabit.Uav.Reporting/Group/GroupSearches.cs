using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>
/// What became of the search of each vehicle of a group. Where some gave it up, it is completed all the same if one
/// accomplished it, or knows that as much was seen as is required.
/// </summary>
internal sealed class GroupSearches(IReadOnlyList<GroupVehicleSummary> vehicles)
{
    private readonly bool _isCompleted = vehicles.Any(v => IsCompleted(v.Flight.Record.Mission));

    /// <summary>What failed of single vehicles and was not made good by others.</summary>
    public IEnumerable<string> Failures => vehicles.SelectMany(
        v => SummaryOf(v, _isCompleted).Failures.Select(f => Of(v, f)));

    /// <summary>What was made good.</summary>
    public IEnumerable<string> Remarks => !_isCompleted ? [] : vehicles.SelectMany(
        v => SummaryOf(v, isCompleted: false).Failures
            .Except(SummaryOf(v, isCompleted: true).Failures, StringComparer.Ordinal)
            .Select(f => Of(v, f) + "; the others completed the search"));

    private static bool IsCompleted(in MissionStatus mission)
        => mission.Result.Outcome == MissionOutcome.Accomplished
            || (mission.Result.RequiredCoverage > 0 && mission.Coverage >= mission.Result.RequiredCoverage);

    private MissionSummary SummaryOf(GroupVehicleSummary vehicle, bool isCompleted)
        => new(
            vehicle.Flight.Record, score: null, isCompleted,
            vehicles.Where(v => v != vehicle).Sum(v => v.Flight.Record.Mission.LanesSkipped));

    private static string Of(GroupVehicleSummary vehicle, string text)
        => $"vehicle {FlightText.Number((long)vehicle.SystemId)}: {text}";
}
