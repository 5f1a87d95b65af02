using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>A mission laid out from where the vehicle stands: frame, fence and lanes. Immutable.</summary>
internal sealed class FlightPlan
{
    // Further away it is probably the wrong mission.
    private const double MaxAreaDistanceMetres = 5000;
    private const double MaxHomeDistanceMetres = 50;
    private const double MaxAltitudeDifferenceMetres = 50;
    private const int MaxLanes = 2000;

    private FlightPlan(MissionPlan mission, LocalNedFrame frame)
    {
        Frame = frame;
        Area = new PlanePolygon(mission.Area.Select(c => frame.ToNed(c)).Select(n => new PlanePoint(n.North, n.East)));
        Fence = PlanePolygon.HullOf(Area.Corners.Concat([default])).Grown(mission.FenceMarginMetres);
        HeadingRadians = mission.LaneHeadingRadians ?? LanePlanner.BestHeading(Area, mission.LaneSpacingMetres);
        Lanes = LanePlanner.Plan(Area, mission.LaneSpacingMetres, HeadingRadians, from: default);
        Message = ToMessage(mission);
    }

    /// <summary>Its origin is on the ground where the vehicle stands.</summary>
    public LocalNedFrame Frame { get; }

    public PlanePolygon Area { get; }

    /// <summary>What the vehicle may not leave; convex, so that every way between two points in it is in it.</summary>
    public PlanePolygon Fence { get; }

    /// <summary>Along the lanes.</summary>
    public double HeadingRadians { get; }

    public IReadOnlyList<LaneSegment> Lanes { get; }

    /// <summary>The same for others.</summary>
    public SearchPlan Message { get; }

    /// <summary>Lays a mission out.</summary>
    /// <param name="mission">The mission.</param>
    /// <param name="home">Where the vehicle stands; its altitude is that of the ground.</param>
    /// <param name="fault">Why it cannot be flown from there; empty where it can.</param>
    public static FlightPlan? Make(MissionPlan mission, GeodeticPosition home, out string fault)
    {
        var frame = LocalNedFrame.IgnoringGeoid(home);
        fault = FindFault(mission, frame) ?? string.Empty;
        if (fault.Length > 0)
            return null;
        var plan = new FlightPlan(mission, frame);
        if (plan.Lanes.Count > MaxLanes)
            fault = $"it has {MissionText.Of(plan.Lanes.Count)} lanes; at most {MissionText.Of(MaxLanes)} are flown";
        return fault.Length > 0 ? null : plan;
    }

    private static string? FindFault(MissionPlan mission, LocalNedFrame frame)
    {
        double far = mission.Area.Select(c => frame.ToNed(c)).Max(n => new PlanePoint(n.North, n.East).Length);
        if (!(far <= MaxAreaDistanceMetres))
            return $"the area reaches {MissionText.Of(far)} m from the vehicle; at most {MissionText.Of(MaxAreaDistanceMetres)} m are flown";
        if (mission.Home is not { } home)
            return null;
        NedVector off = frame.ToNed(GeodeticPosition.FromRadians(home.LatitudeRadians, home.LongitudeRadians, frame.Origin.AltitudeAmslMetres));
        double distance = new PlanePoint(off.North, off.East).Length;
        if (!(distance <= MaxHomeDistanceMetres))
            return $"the vehicle stands {MissionText.Of(distance)} m from the mission's home; at most {MissionText.Of(MaxHomeDistanceMetres)} m are allowed";
        double difference = Math.Abs((home.GroundAltitudeAmslMetres ?? frame.Origin.AltitudeAmslMetres) - frame.Origin.AltitudeAmslMetres);
        return difference <= MaxAltitudeDifferenceMetres
            ? null
            : $"the ground is {MissionText.Of(frame.Origin.AltitudeAmslMetres)} m above sea level by the vehicle; the mission says {MissionText.Of(home.GroundAltitudeAmslMetres!.Value)} m";
    }

    private SearchPlan ToMessage(MissionPlan mission) => new()
    {
        Name = mission.Name,
        Area = Places(Area.Corners, down: 0),
        Fence = Places(Fence.Corners, down: 0),
        Lanes = Places(Lanes.SelectMany(l => new[] { l.Start, l.End }), -mission.HeightMetres),
        Home = Frame.Origin,
        HeightAboveHomeMetres = mission.HeightMetres,
        SpeedMetresPerSecond = mission.SpeedMetresPerSecond,
    };

    private ImmutableArray<GeodeticPosition> Places(IEnumerable<PlanePoint> points, double down)
        => points.Select(p => Frame.ToGeodetic(new NedVector(p.North, p.East, down))).ToImmutableArray();
}
