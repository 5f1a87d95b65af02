using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>
/// The result of a mission in figures and words: what Mission Control posted (<see cref="MissionResult"/>) and, where
/// the truth is known, the score of its targets. Immutable.
/// </summary>
/// <example>
/// <code>
/// var mission = new MissionSummary(recorder.Record, score: null);   // null where the truth is not known
/// Console.WriteLine(mission.HasPassed ? "ACCOMPLISHED" : string.Join("; ", mission.Failures));
/// </code>
/// </example>
public sealed class MissionSummary
{
    /// <summary>Summarises a mission.</summary>
    /// <param name="record">The flight.</param>
    /// <param name="score">
    /// Null where the truth is not known. Where it is, a mission that was given up after all its targets were found and
    /// as much of the area was seen as is required has passed, where a coverage is required at all.
    /// </param>
    public MissionSummary(FlightRecord record, MissionScore? score)
        : this(record, score, isCompletedByOthers: false, lanesSkippedByOthers: 0)
    {
    }

    /// <param name="record">The flight.</param>
    /// <param name="score">Null where the truth is not known.</param>
    /// <param name="isCompletedByOthers">
    /// Whether other vehicles of a group completed the search: that this one gave it up, or was called off before it
    /// took off, is no failure then.
    /// </param>
    /// <param name="lanesSkippedByOthers">
    /// How many lanes the operators of the other vehicles of a group skipped: no vehicle flies these.
    /// </param>
    internal MissionSummary(
        FlightRecord record, MissionScore? score, bool isCompletedByOthers, int lanesSkippedByOthers)
    {
        if (record is null)
            throw new ArgumentNullException(nameof(record));
        MissionStatus mission = record.Mission;
        Score = score;
        Plan = mission.Plan;
        Phase = mission.Phase;
        Text = mission.Text;
        Aborted = mission.Aborted;
        StopResult = mission.StopResult;
        CoveragePercent = mission.Coverage * 100;
        RequiredCoveragePercent = mission.Result.RequiredCoverage * 100;
        LanesFlown = mission.LanesFlown;
        Revisits = mission.Revisits;
        FlownMetres = record.FlownMetres;
        FlightTime = record.ArmedTime;
        double remaining = record.Vehicle.BatteryTime is null ? double.NaN : record.Vehicle.BatteryRemaining;
        BatteryUsedPercent = (record.FirstBatteryRemaining - remaining) * 100;
        Energy = mission.Energy;
        HasLanded = mission.Result.HasLanded;
        DistanceFromHomeMetres = score?.DistanceFromHomeMetres ?? mission.Result.DistanceFromHomeMetres;
        OutsideFenceMetres = mission.Result.OutsideFenceMetres;
        string[] first =
        [
            .. NotFlown(mission.Result, isCompletedByOthers),
            .. isCompletedByOthers
                ? []
                : CoverageFailures(mission.Result, mission.LanesSkipped, lanesSkippedByOthers),
        ];
        Failures = [.. first, .. TargetFailures(score), .. FlightFailures(record, isCompletedByOthers)];
        Remarks = [.. NothingFound(record)];
        Headlines = [.. first, .. Remarks];
    }

    /// <summary>Compared with the truth; null where it is not known.</summary>
    public MissionScore? Score { get; }

    /// <summary>The plan that was flown; null where Mission Control did not make one.</summary>
    public SearchPlan? Plan { get; }

    /// <summary>The last phase.</summary>
    public MissionPhase Phase { get; }

    /// <summary>What Mission Control said of its last phase; null for nothing.</summary>
    public string? Text { get; }

    /// <summary>Why the search was given up before its end; null where it was not.</summary>
    public string? Aborted { get; }

    /// <summary>What became of the vehicle when the program was stopped while we commanded it.</summary>
    public MissionStopResult StopResult { get; }

    /// <summary>The part of the area that was searched, 0 to 100.</summary>
    public double CoveragePercent { get; }

    /// <summary>The part of the area that had to be searched, 0 to 100; 0 for a mission without a camera.</summary>
    public double RequiredCoveragePercent { get; }

    /// <summary>How many segments of the lanes were flown.</summary>
    public int LanesFlown { get; }

    /// <summary>How many tracks were revisited.</summary>
    public int Revisits { get; }

    /// <summary>Length of the path that was flown, metres.</summary>
    public double FlownMetres { get; }

    /// <summary>From arming to disarming.</summary>
    public TimeSpan FlightTime { get; }

    /// <summary>Used part of the battery, 0 to 100; NaN where the autopilot does not know it.</summary>
    public double BatteryUsedPercent { get; }

    /// <summary>The energy of the flight, as Mission Control estimated it last.</summary>
    public EnergyStatus Energy { get; }

    /// <summary>Whether the vehicle took off and is on the ground with its motors off.</summary>
    public bool HasLanded { get; }

    /// <summary>
    /// Horizontal distance from home at the end, metres, by the truth where it is known; NaN where it is not known at
    /// all.
    /// </summary>
    public double DistanceFromHomeMetres { get; }

    /// <summary>The largest distance that the vehicle was outside the fence, metres; 0 where it never was.</summary>
    public double OutsideFenceMetres { get; }

    /// <summary>Why the mission failed, for people; none where it passed.</summary>
    public IReadOnlyList<string> Failures { get; }

    /// <summary>
    /// What is said before everything else, for people: that it did not fly, that the area was not fully seen, that
    /// nothing was found. None where none holds.
    /// </summary>
    public IReadOnlyList<string> Headlines { get; }

    /// <summary>The headlines that are no failures.</summary>
    internal IReadOnlyList<string> Remarks { get; }

    /// <summary>Whether the mission did what was asked for.</summary>
    public bool HasPassed => Failures.Count == 0;

    private IEnumerable<string> CoverageFailures(MissionResult result, int lanesSkipped, int lanesSkippedByOthers)
    {
        if ((result.Failures & MissionFailures.AreaNotSeen) == 0)
            yield break;
        string skipped = (lanesSkipped + lanesSkippedByOthers) switch
        {
            0 => string.Empty,
            1 => "; the operator skipped a lane",
            int lanes => $"; the operator skipped {FlightText.Number((long)lanes)} lanes",
        };
        if (lanesSkippedByOthers > 0)
            skipped += " of the group";
        yield return $"the area was not fully seen: {FlightText.Number(CoveragePercent, "0.0")} % of it, "
            + $"{FlightText.Number(RequiredCoveragePercent, "0.#")} % are required" + skipped;
    }

    // One that the operator called off before its take-off did as commanded.
    private IEnumerable<string> NotFlown(MissionResult result, bool isCompletedByOthers)
    {
        bool isMadeGood = isCompletedByOthers && (result.Failures & MissionFailures.CalledOff) != 0;
        if (!result.HasFlown && !isMadeGood)
            yield return "it did not fly" + (Text is { } why ? $" ({why})" : string.Empty);
    }

    private static IEnumerable<string> NothingFound(FlightRecord record)
    {
        if (!record.Mission.Result.HasFlown || record.Mission.Plan is null || record.Tracks.Confirmed.Any())
            yield break;
        yield return record.Imaging.HasCamera || record.Imaging.Observations > 0
            ? "nothing was found: no target was confirmed"
            : "nothing was searched for: there was no camera";
    }

    private static IEnumerable<string> TargetFailures(MissionScore? score)
    {
        if (score is null)
            yield break;
        foreach (TargetScore missed in score.Targets.Where(t => !t.IsFound))
            yield return $"target {missed.Name} ({TargetClassNames.Name(missed.Class)}) "
                + FlightText.Missed(missed);
        foreach (TargetTrack track in score.FalseTracks)
            yield return $"track {FlightText.Number(track.Id)} ({TargetClassNames.Name(track.Class)}) was confirmed "
                + "and is not a target";
    }

    private IEnumerable<string> FlightFailures(FlightRecord record, bool isCompletedByOthers)
    {
        MissionResult result = record.Mission.Result;
        // Without a required coverage nothing else says that the search was complete.
        bool isComplete = isCompletedByOthers || (Score is not null && RequiredCoveragePercent > 0);
        if (!isComplete && (result.Failures & MissionFailures.GivenUp) != 0)
            yield return "the search was given up before its end: " + Aborted;
        if ((result.Failures & MissionFailures.TakenOver) != 0)
            yield return record.Mission.TakenOver ?? "the mission was taken over";
        if (!result.HasFlown)
            yield break;
        if (!HasLanded)
            yield return $"it has not landed: it is armed, {Metres(record.Vehicle.HeightAboveHomeMetres)} high, in "
                + $"mode {record.Vehicle.Mode ?? "not known"}; it is not commanded any more";
        else if (double.IsNaN(DistanceFromHomeMetres))
            yield return Plan is null
                ? "nothing was searched: the vehicle was flying already and was only brought down; how far from home "
                    + "it landed only the autopilot knows"
                : "where it landed is not known";
        else if (DistanceFromHomeMetres > MissionResult.MaxLandingDistanceMetres)
            yield return $"it landed {Metres(DistanceFromHomeMetres)} from home";
        if (OutsideFenceMetres > 0)
            yield return $"it was {Metres(OutsideFenceMetres)} outside the fence";
    }

    private static string Metres(double value) => value.ToString("0.0", CultureInfo.InvariantCulture) + " m";
}
