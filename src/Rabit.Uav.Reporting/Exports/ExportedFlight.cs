using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting.Exports;

/// <summary>What of a flight has a place, in the order in which the exports write it.</summary>
internal sealed class ExportedFlight(FlightSummary summary)
{
    private const int EllipseSteps = 48;
    private const double MaxEllipseMetres = 100_000;

    public string Name => Plan is { Name.Length: > 0 } plan ? Printable(plan.Name) : "flight";

    public SearchPlan? Plan => summary.Record.Mission.Plan;

    /// <summary>Samples with a position, oldest first.</summary>
    public IReadOnlyList<FlightSample> Path { get; } =
        [.. summary.Record.Samples.Where(s => s.HasPosition && s.Position.IsValid)];

    /// <summary>Confirmed and lost tracks, by number.</summary>
    public IReadOnlyList<TargetTrack> Targets { get; } =
    [
        .. summary.Record.Tracks.Tracks.Where(t => t.State != TrackState.Tentative && t.Position.IsValid)
            .OrderBy(t => t.Id),
    ];

    /// <summary>Where the targets really are; none where that is not known.</summary>
    public IReadOnlyList<TargetScore> Truth => summary.Mission?.Score?.Targets ?? [];

    /// <summary>Areas of the plan, and what they are.</summary>
    public IEnumerable<(string Kind, IReadOnlyList<GeodeticPosition> Corners)> Polygons()
    {
        if (Plan is not { } plan)
            yield break;
        if (plan.Area.Length > 2)
            yield return ("area", plan.Area);
        if (plan.Fence.Length > 2)
            yield return ("fence", plan.Fence);
        foreach (ImmutableArray<GeodeticPosition> keepOut in plan.KeepOuts.IsDefault ? [] : plan.KeepOuts)
            yield return ("keep-out", keepOut);
    }

    /// <summary>Start and end of each lane, in the order of the plan.</summary>
    public IEnumerable<(GeodeticPosition Start, GeodeticPosition End)> Lanes()
    {
        for (int index = 0; index + 1 < (Plan?.Lanes.Length ?? 0); index += 2)
            yield return (Plan!.Lanes[index], Plan.Lanes[index + 1]);
    }

    /// <summary>The ground that was seen.</summary>
    public IReadOnlyList<SeenPatch> SeenGround() => Exports.SeenGround.Trace(summary.Record.Observations);

    /// <summary>How much of the area was seen, 0 to 100.</summary>
    public double CoveragePercent => summary.Record.Mission.Coverage * 100;

    /// <summary>The edge of the 95 % ellipse; empty where the covariance is none.</summary>
    public static IReadOnlyList<GeodeticPosition> Ellipse(TargetTrack track)
    {
        double major = track.Covariance.HalfMajorAxis95Metres;
        double minor = track.Covariance.HalfMinorAxis95Metres;
        double direction = track.Covariance.MajorAxis.Radians;
        if (!(major > 0 && major < MaxEllipseMetres && minor > 0) || double.IsNaN(direction))
            return [];
        var frame = LocalNedFrame.IgnoringGeoid(track.Position);
        (double cos, double sin) = (Math.Cos(direction), Math.Sin(direction));
        return
        [
            .. Enumerable.Range(0, EllipseSteps).Select(step => -2 * Math.PI * step / EllipseSteps).Select(angle =>
            {
                (double along, double across) = (major * Math.Cos(angle), minor * Math.Sin(angle));
                return frame.ToGeodetic(
                    new NedPosition((along * cos) - (across * sin), (along * sin) + (across * cos), 0));
            }),
        ];
    }

    /// <summary>
    /// A closed ring as GeoJSON and KML have it: the first corner again at the end; seen from above counter-clockwise,
    /// or clockwise for a hole.
    /// </summary>
    public static IReadOnlyList<GeodeticPosition> Ring(IReadOnlyList<GeodeticPosition> corners, bool isHole = false)
    {
        double doubleArea = 0;
        for (int index = 0; index < corners.Count; index++)
        {
            // About the first corner: far from the origin the differences would be lost in rounding.
            (double x1, double y1) = Offset(corners[index], corners[0]);
            (double x2, double y2) = Offset(corners[(index + 1) % corners.Count], corners[0]);
            doubleArea += (x1 * y2) - (x2 * y1);
        }

        IEnumerable<GeodeticPosition> ordered = doubleArea > 0 == isHole ? corners.Reverse() : corners;
        GeodeticPosition[] ring = [.. ordered];
        return [.. ring, ring[0]];
    }

    /// <summary>A text from outside, without what neither XML nor JSON may hold.</summary>
    public static string Printable(string text)
    {
        char[] characters = FlightText.Printable(text).ToCharArray();
        for (int index = 0; index < characters.Length; index++)
        {
            if (char.IsHighSurrogate(characters[index]) && index + 1 < characters.Length
                && char.IsLowSurrogate(characters[index + 1]))
                index++;
            else if (char.IsSurrogate(characters[index]) || characters[index] is '\uFFFE' or '\uFFFF')
                characters[index] = '.';
        }

        return new string(characters);
    }

    /// <summary>Confirmed or lost.</summary>
    public static string StateOf(TargetTrack target) => target.State.ToString().ToLowerInvariant();

    private static (double X, double Y) Offset(GeodeticPosition position, GeodeticPosition origin)
        => (position.Longitude.Radians - origin.Longitude.Radians, position.Latitude.Radians - origin.Latitude.Radians);
}
