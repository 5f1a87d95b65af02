using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Uav.Json;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>The confirmed targets of a progress file: those of this flight, and those of the flights before.</summary>
internal static class ProgressTargets
{
    // Two ellipses of 95 % that are apart by more are of two targets; this much is added for a home that has moved.
    private const double SameTargetMetres = 5;

    /// <summary>Whether a track is of a target that was found before.</summary>
    public static bool AreSame(MissionProgressTarget earlier, TargetTrack track)
    {
        var frame = LocalNedFrame.IgnoringGeoid(
            GeodeticPosition.FromRadians(earlier.Position.Latitude.Radians, earlier.Position.Longitude.Radians, 0));
        NedPosition off = frame.ToNed(
            GeodeticPosition.FromRadians(track.Position.Latitude.Radians, track.Position.Longitude.Radians, 0));
        double limit = SameTargetMetres + earlier.HalfMajorAxis95Metres + track.Covariance.HalfMajorAxis95Metres;
        return earlier.Class == track.Class && new PlanePoint(off.North, off.East).Length <= limit;
    }

    public static void Write(Utf8JsonWriter json, ProgressSnapshot snapshot)
    {
        Write(json, "targets", snapshot.Tracks.Confirmed.ToList(), snapshot.Earlier, snapshot);
        List<TargetTrack> rejected = snapshot.Tracks.Tracks.Where(t => t.State == TrackState.Rejected).ToList();
        Write(json, "rejectedTargets", rejected, snapshot.EarlierRejected, snapshot);
    }

    private static void Write(
        Utf8JsonWriter json, string name, List<TargetTrack> tracks, ImmutableArray<MissionProgressTarget> before,
        ProgressSnapshot snapshot)
    {
        json.WriteStartArray(name);
        foreach (MissionProgressTarget earlier in before.Where(e => !snapshot.Tracks.Tracks.Any(
            t => t.State is TrackState.Confirmed or TrackState.Rejected && AreSame(e, t))))
            Write(json, earlier);
        foreach (TargetTrack track in tracks)
        {
            Write(json, new MissionProgressTarget
            {
                TrackId = track.Id,
                Class = track.Class,
                Position = track.Position,
                HalfMajorAxis95Metres = track.Covariance.HalfMajorAxis95Metres,
                Reports = track.Reports,
                IsRevisited = snapshot.Revisited.Contains(track.Id),
            });
        }

        json.WriteEndArray();
    }

    public static ImmutableArray<MissionProgressTarget> Read(JsonFields fields, string name, List<string> faults)
    {
        if (fields.Array(name) is not { } items)
            return [];
        var targets = ImmutableArray.CreateBuilder<MissionProgressTarget>();
        foreach (JsonElement item in items.EnumerateArray())
        {
            var target = new JsonFields(
                item, FormattableString.Invariant($"{name}[{targets.Count}]"), faults);
            if (!TargetClassName.TryParse(target.Text("class"), out TargetClassName targetClass))
                target.Missing("class");
            targets.Add(new MissionProgressTarget
            {
                TrackId = target.RequiredWholeNumber("trackId"),
                Class = targetClass,
                Position = MissionProgressFormat.ReadPosition(target, altitude: 0),
                HalfMajorAxis95Metres = target.RequiredNumber("halfMajorAxis95Metres"),
                Reports = target.RequiredWholeNumber("reports"),
                IsRevisited = target.Flag("isRevisited") ?? false,
            });
        }

        return targets.ToImmutable();
    }

    private static void Write(Utf8JsonWriter json, MissionProgressTarget target)
    {
        json.WriteStartObject();
        json.WriteNumber("trackId", target.TrackId);
        json.WriteString("class", target.Class.ToString());
        MissionProgressFormat.Write(json, target.Position);
        json.WriteNumber("halfMajorAxis95Metres", target.HalfMajorAxis95Metres);
        json.WriteNumber("reports", target.Reports);
        json.WriteBoolean("isRevisited", target.IsRevisited);
        json.WriteEndObject();
    }
}
