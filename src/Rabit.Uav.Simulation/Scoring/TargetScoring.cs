using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Pairs tracks with the real targets of the same class: nearest pairs first, each track once, and each target once at
/// a time: one that moves has another track each time that it is seen again.
/// </summary>
/// <example>
/// <code>
/// MissionScore score = TargetScoring.Score(TargetTruth.Of(world), tracks.Value.Tracks);
/// Console.WriteLine($"{score.Found} of {score.Targets.Count} found, {score.FalseTracks.Count} false");
/// </code>
/// </example>
public static class TargetScoring
{
    /// <summary>A track farther from a target than this is not a track of that target, metres.</summary>
    public const double GateMetres = 10;

    /// <summary>
    /// Scores a mission. A track of a class that moves which was on one target and then on another, as targets of one
    /// class that are out of sight for a while are exchanged, is no false one: it counts as an identity switch.
    /// One that another vehicle rejected when it was asked to validate it counts as what the operator rejected.
    /// </summary>
    /// <param name="truth">The real targets.</param>
    /// <param name="record">The flight.</param>
    /// <param name="trueEnd">
    /// Where the vehicle really is at the end; null where only the autopilot's own position is known.
    /// </param>
    public static MissionScore Score(TargetTruth truth, FlightRecord record, GeodeticPosition? trueEnd)
    {
        if (record is null)
            throw new ArgumentNullException(nameof(record));
        return Score(
            truth, record.Tracks.Tracks, record.MovingTrackPaths, t => IsRejectedByVehicle(record, t),
            DistanceFromHome(record.Mission.Plan, trueEnd));
    }

    /// <summary>Scores tracks, by where they are at the end.</summary>
    /// <param name="truth">The real targets.</param>
    /// <param name="tracks">
    /// Confirmed ones count, and lost ones of a class that moves; of a rejected one its target is said to be rejected;
    /// others are ignored.
    /// </param>
    public static MissionScore Score(TargetTruth truth, IEnumerable<TargetTrack> tracks)
        => Score(truth, tracks, [], _ => false, null);

    private static MissionScore Score(
        TargetTruth truth, IEnumerable<TargetTrack> tracks, IReadOnlyList<TrackPath> paths,
        Func<TargetTrack, bool> isRejectedByVehicle, double? distanceFromHomeMetres)
    {
        if (truth is null)
            throw new ArgumentNullException(nameof(truth));
        TargetTrack[] all = (tracks ?? throw new ArgumentNullException(nameof(tracks))).OrderBy(t => t.Id).ToArray();
        TargetTrack[] rejectedByVehicle = all.Where(t => IsFound(t) && isRejectedByVehicle(t)).ToArray();
        TargetTrack[] confirmed = all.Where(t => IsFound(t) && !rejectedByVehicle.Contains(t)).ToArray();
        var tracksOf = truth.Targets.Select(_ => new List<TargetTrack>()).ToArray();
        var isTaken = new HashSet<int>();
        foreach ((int target, TargetTrack track, _) in Pairs(truth, confirmed))
        {
            List<TargetTrack> taken = tracksOf[target];
            if ((taken.Count == 0 || IsSeenAgain(track, taken)) && isTaken.Add(track.Id))
                taken.Add(track);
        }

        var histories = new TrackHistories(truth, confirmed.Where(t => t.Motion != TargetMotion.Standing), paths);

        // Each is of the nearest one.
        TargetTrack[] rejected = all.Where(t => t.State == TrackState.Rejected).Concat(rejectedByVehicle).ToArray();
        (int Target, TargetTrack Track)[] ofTargets = Pairs(truth, rejected)
            .GroupBy(p => p.Track.Id).Select(g => (g.First().Target, g.First().Track)).ToArray();
        return new MissionScore
        {
            IdentitySwitches = histories.IdentitySwitches,
            Targets = truth.Targets
                .Select((t, index) => Of(
                    t, tracksOf[index].FirstOrDefault(),
                    ofTargets.Where(r => r.Target == index).Select(r => r.Track).FirstOrDefault())).ToArray(),
            FalseTracks = confirmed.Where(t => !isTaken.Contains(t.Id) && !histories.IsOfTargets(t)).ToArray(),
            RejectedTracks = rejectedByVehicle
                .Where(t => !Array.Exists(ofTargets, r => r.Track == t && tracksOf[r.Target].Count == 0)).ToArray(),
            DistanceFromHomeMetres = distanceFromHomeMetres,
        };
    }

    // What the operator rejected has the state of its track.
    private static bool IsRejectedByVehicle(FlightRecord record, TargetTrack track)
        => record.ValidationOf(track) is { Result: ValidationResult.Rejected, IsRejectedByOperator: false };

    // By distance; among equals by target and track, so that the same tracks always score the same.
    private static IEnumerable<(int Target, TargetTrack Track, double Metres)> Pairs(
        TargetTruth truth, TargetTrack[] tracks)
        => Enumerable.Range(0, truth.Targets.Count)
            .SelectMany(target => tracks
                .Where(t => t.Class == truth.Targets[target].Class)
                .Select(t => (Target: target, Track: t, Metres: Of(truth.Targets[target], t).ErrorMetres)))
            .Where(p => p.Metres <= GateMetres)
            .OrderBy(p => p.Metres).ThenBy(p => p.Target).ThenBy(p => p.Track.Id);

    // Of two tracks at the same time one is false.
    private static bool IsSeenAgain(TargetTrack track, List<TargetTrack> others)
        => track.Motion != TargetMotion.Standing
            && others.TrueForAll(o => track.FirstSeen > o.LastSeen || track.LastSeen < o.FirstSeen);

    // A target that moved on out of sight was found all the same.
    private static bool IsFound(TargetTrack track)
        => track.State == TrackState.Confirmed
            || (track.State == TrackState.Lost && track.Motion != TargetMotion.Standing);

    private static TargetScore Of(TruthTarget target, TargetTrack? track, TargetTrack? rejected = null)
    {
        // Where the target was at the time of the track. Both on the ellipsoid: a difference in height is no error.
        GeodeticPosition position = track is null ? target.Position : target.PositionAt(track.Time);
        NedPosition error = track is null
            ? default
            : LocalNedFrame.IgnoringGeoid(OnEllipsoid(position)).ToNed(OnEllipsoid(track.Position));
        return new TargetScore
        {
            Name = target.Name,
            Class = target.Class,
            Position = position,
            Track = track,
            IsRejected = track is null && rejected is not null,
            IsRejectedByVehicle = track is null && rejected is { State: not TrackState.Rejected },
            ErrorNorthMetres = error.North,
            ErrorEastMetres = error.East,
        };
    }

    private static double? DistanceFromHome(SearchPlan? plan, GeodeticPosition? trueEnd)
    {
        if (plan is null || trueEnd is not { } end)
            return null;
        NedPosition offset = LocalNedFrame.IgnoringGeoid(plan.Home).ToNed(end);
        return Math.Sqrt((offset.North * offset.North) + (offset.East * offset.East));
    }

    /// <summary>Over ground: a difference in height is no error.</summary>
    internal static double MetresBetween(GeodeticPosition a, GeodeticPosition b) => NedPosition.Origin
        .HorizontalDistanceTo(LocalNedFrame.IgnoringGeoid(OnEllipsoid(a)).ToNed(OnEllipsoid(b)));

    private static GeodeticPosition OnEllipsoid(GeodeticPosition position)
        => GeodeticPosition.FromRadians(position.Latitude.Radians, position.Longitude.Radians, 0);
}
