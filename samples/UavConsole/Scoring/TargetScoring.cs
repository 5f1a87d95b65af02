using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>Says which track is which real target: nearest pairs first, of the same colour, each only once.</summary>
internal static class TargetScoring
{
    /// <summary>A track farther from a target than this is not that target.</summary>
    public const double GateMetres = 10;

    /// <param name="truth">What is there.</param>
    /// <param name="tracks">Those that are confirmed count; others are ignored.</param>
    public static MissionScore Score(Truth truth, IEnumerable<TargetTrack> tracks)
    {
        TargetTrack[] confirmed = tracks.Where(t => t.State == TrackState.Confirmed).OrderBy(t => t.Id).ToArray();
        var trackOf = new TargetTrack?[truth.Targets.Count];
        var isTaken = new HashSet<int>();
        foreach ((int target, TargetTrack track, _) in Pairs(truth, confirmed))
        {
            if (trackOf[target] is null && isTaken.Add(track.Id))
                trackOf[target] = track;
        }

        return new MissionScore(
            truth.Targets.Select((t, index) => Of(t, trackOf[index])).ToArray(),
            confirmed.Where(t => !isTaken.Contains(t.Id)).ToArray());
    }

    // By distance; among equals by target and track, so that the same tracks always score the same.
    private static IEnumerable<(int Target, TargetTrack Track, double Metres)> Pairs(Truth truth, TargetTrack[] tracks)
        => Enumerable.Range(0, truth.Targets.Count)
            .SelectMany(target => tracks
                .Where(t => t.Class == truth.Targets[target].Class)
                .Select(t => (Target: target, Track: t, Metres: Of(truth.Targets[target], t).ErrorMetres)))
            .Where(p => p.Metres <= GateMetres)
            .OrderBy(p => p.Metres).ThenBy(p => p.Target).ThenBy(p => p.Track.Id);

    private static TargetScore Of(TruthTarget target, TargetTrack? track)
    {
        if (track is null)
            return new TargetScore(target, null, 0, 0);

        // Both on the ellipsoid: a difference in height is no error.
        var frame = LocalNedFrame.IgnoringGeoid(OnEllipsoid(target.Position));
        NedPosition error = frame.ToNed(OnEllipsoid(track.Position));
        return new TargetScore(target, track, error.North, error.East);
    }

    private static GeodeticPosition OnEllipsoid(GeodeticPosition position) => GeodeticPosition.FromRadians(position.Latitude.Radians, position.Longitude.Radians, 0);
}
