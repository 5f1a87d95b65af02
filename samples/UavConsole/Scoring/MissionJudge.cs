using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>Judges a flown mission: the targets, the landing, the fence.</summary>
internal static class MissionJudge
{
    /// <summary>Landed at home is landed no farther from it than this.</summary>
    public const double HomeMetres = 3;

    // Below this it never left the ground.
    private const double FlownHeightMetres = 1;

    /// <param name="record">The flight.</param>
    /// <param name="truth">What was there to be found; null where nobody knows: then the targets are not judged.</param>
    /// <param name="trueEnd">Where the vehicle really stands at the end; null where only the autopilot knows.</param>
    public static MissionOutcome Judge(FlightRecord record, Truth? truth, GeodeticPosition? trueEnd)
    {
        SearchPlan? plan = record.Mission.Plan;
        MissionScore? score = truth is null ? null : TargetScoring.Score(truth, record.Tracks.Tracks);
        bool hasFlown = record.GreatestHeightMetres > FlownHeightMetres;
        double distance = DistanceFromHome(record, plan, trueEnd);
        bool hasLanded = hasFlown && !record.Vehicle.IsArmed;
        double outside = plan is null ? 0 : FarthestOutside(record, plan);

        var failures = new List<string>();
        if (score is not null)
            JudgeTargets(score, failures);
        else if (hasFlown && record.Mission.Aborted is { } reason)
            failures.Add("the search was given up before its end: " + reason);
        if (!hasFlown)
            failures.Add("it did not fly" + (record.Mission.Text is { } why ? $" ({why})" : string.Empty));
        else if (!hasLanded)
            failures.Add($"it has not landed: it is armed, {Metres(record.Vehicle.HeightAboveHomeMetres)} high, in mode {record.Vehicle.Mode ?? "not known"}; we command it no more");
        else if (!(distance <= HomeMetres))
            failures.Add(double.IsNaN(distance) ? "where it landed is not known" : $"it landed {Metres(distance)} from home");
        if (outside > 0)
            failures.Add($"it was {Metres(outside)} outside the fence");

        return new MissionOutcome
        {
            Score = score,
            Plan = plan,
            Phase = record.Mission.Phase,
            Aborted = record.Mission.Aborted,
            CoveragePercent = record.Mission.Coverage * 100,
            FlownMetres = record.FlownMetres,
            FlightTime = record.ArmedTime,
            BatteryUsedPercent = (record.FirstBatteryRemaining - (record.Vehicle.BatteryTime is null ? double.NaN : record.Vehicle.BatteryRemaining)) * 100,
            HasLanded = hasLanded,
            DistanceFromHomeMetres = distance,
            OutsideFenceMetres = outside,
            Failures = failures,
        };
    }

    private static void JudgeTargets(MissionScore score, List<string> failures)
    {
        foreach (TargetScore missed in score.Targets.Where(t => !t.IsFound))
            failures.Add($"target {missed.Target.Name} ({Colours.Name(missed.Target.Class)}) was not found");
        foreach (TargetTrack track in score.FalseTracks)
            failures.Add($"track {track.Id.ToString(CultureInfo.InvariantCulture)} ({Colours.Name(track.Class)}) was confirmed and is no target");
    }

    private static double DistanceFromHome(FlightRecord record, SearchPlan? plan, GeodeticPosition? trueEnd)
    {
        if (plan is null || (trueEnd is null && record.Vehicle.PositionTime is null))
            return double.NaN;
        NedPosition end = LocalNedFrame.IgnoringGeoid(plan.Home).ToNed(trueEnd ?? record.Vehicle.Position);
        return Math.Sqrt((end.North * end.North) + (end.East * end.East));
    }

    private static double FarthestOutside(FlightRecord record, SearchPlan plan)
    {
        if (plan.Fence.Length < 3)
            return 0;
        var frame = LocalNedFrame.IgnoringGeoid(plan.Home);
        var fence = new Polygon(plan.Fence.Select(frame.ToNed).ToArray());
        return record.Samples
            .Where(s => s.HasPosition)
            .Select(s => fence.MetresOutside(frame.ToNed(s.Position)))
            .DefaultIfEmpty(0)
            .Max();
    }

    private static string Metres(double value) => value.ToString("0.0", CultureInfo.InvariantCulture) + " m";
}
