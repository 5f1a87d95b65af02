using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>A mission planned from the position of the vehicle: local frame, geofence and lanes. Immutable.</summary>
internal sealed class FlightPlan
{
    /// <summary>Farther away it is probably the wrong mission file.</summary>
    public const double MaxAreaDistanceMetres = 5000;

    /// <summary>Farther away from where home is expected it is another place.</summary>
    public const double MaxHomeDistanceMetres = 50;
    private const double MaxAltitudeDifferenceMetres = 50;
    private const int MaxLanes = 2000;

    private FlightPlan(MissionPlan mission, LocalNedFrame frame, IReadOnlyList<LaneSegment>? lanes)
    {
        Frame = frame;
        Area = new PlanePolygon(mission.Area.Select(c => frame.ToNed(c)).Select(n => new PlanePoint(n.North, n.East)));
        Fence = PlanePolygon.HullOf(Area.Corners.Concat([default])).Grown(mission.FenceMarginMetres);
        HeadingRadians = mission.LaneHeading?.Radians ?? LanePlanner.BestHeading(Area, mission.LaneSpacingMetres);
        Lanes = lanes ?? LanePlanner.Plan(Area, mission.LaneSpacingMetres, HeadingRadians, from: default);
        Message = ToMessage(mission);
    }

    /// <summary>Its origin is on the ground, at home.</summary>
    public LocalNedFrame Frame { get; }

    public PlanePolygon Area { get; }

    /// <summary>
    /// The geofence, which the vehicle may not leave; convex, so that every straight path between two points in it is
    /// in it.
    /// </summary>
    public PlanePolygon Fence { get; }

    /// <summary>Direction of the lanes, radians clockwise from true north.</summary>
    public double HeadingRadians { get; }

    public IReadOnlyList<LaneSegment> Lanes { get; }

    /// <summary>The plan as other managers receive it.</summary>
    public SearchPlan Message { get; }

    /// <summary>Plans a mission.</summary>
    /// <param name="mission">The mission.</param>
    /// <param name="home">Position of the vehicle; its altitude is that of the ground.</param>
    /// <param name="fault">Why the mission cannot be flown from there; empty where it can.</param>
    /// <param name="lanes">Lanes that were planned before; null to plan them.</param>
    public static FlightPlan? Create(
        MissionPlan mission, GeodeticPosition home, out string fault, IReadOnlyList<LaneSegment>? lanes = null)
    {
        var frame = LocalNedFrame.IgnoringGeoid(home);
        fault = FindFault(mission, frame) ?? string.Empty;
        if (fault.Length > 0)
            return null;
        var plan = new FlightPlan(mission, frame, lanes);
        double far = plan.Lanes.Max(l => Math.Max(l.Start.Length, l.End.Length)) + MissionPlanRules.FenceReserveMetres;
        if (far > mission.MaxDistanceMetres)
        {
            fault = $"a lane ends {MissionNumbers.Of(far - MissionPlanRules.FenceReserveMetres)} m from home; with a "
                + $"reserve of {MissionNumbers.Of(MissionPlanRules.FenceReserveMetres)} m it must be within "
                + $"limits.maxDistanceMetres, {MissionNumbers.Of(mission.MaxDistanceMetres.Value)} m";
        }
        else if (plan.Lanes.Count > MaxLanes)
            fault = $"it has {MissionNumbers.Of(plan.Lanes.Count)} lanes; the limit is {MissionNumbers.Of(MaxLanes)}";
        return fault.Length > 0 ? null : plan;
    }

    private static string? FindFault(MissionPlan mission, LocalNedFrame frame)
    {
        double far = mission.Area.Select(c => frame.ToNed(c)).Max(n => new PlanePoint(n.North, n.East).Length);
        if (!(far <= MaxAreaDistanceMetres))
        {
            return $"the area extends {MissionNumbers.Of(far)} m from the vehicle; the limit is "
                + $"{MissionNumbers.Of(MaxAreaDistanceMetres)} m";
        }

        if (mission.Home is not { } home)
            return null;
        NedPosition off = frame.ToNed(
            GeodeticPosition.FromRadians(
                home.Latitude.Radians, home.Longitude.Radians, frame.Origin.AltitudeAmslMetres));
        double distance = new PlanePoint(off.North, off.East).Length;
        if (!(distance <= MaxHomeDistanceMetres))
            return $"the vehicle is {MissionNumbers.Of(distance)} m from the mission's home; the limit is "
                + $"{MissionNumbers.Of(MaxHomeDistanceMetres)} m";
        double difference = Math.Abs(
            (home.GroundAltitudeAmslMetres ?? frame.Origin.AltitudeAmslMetres) - frame.Origin.AltitudeAmslMetres);
        return difference <= MaxAltitudeDifferenceMetres
            ? null
            : $"the ground is at {MissionNumbers.Of(frame.Origin.AltitudeAmslMetres)} m above mean sea level "
                + "according to the vehicle, "
                + $"at {MissionNumbers.Of(home.GroundAltitudeAmslMetres!.Value)} m according to the mission";
    }

    private SearchPlan ToMessage(MissionPlan mission) => new()
    {
        Name = mission.Name,
        Area = Positions(Area.Corners, down: 0),
        Fence = Positions(Fence.Corners, down: 0),
        Lanes = Positions(Lanes.SelectMany(l => new[] { l.Start, l.End }), -mission.HeightMetres),
        Home = Frame.Origin,
        HeightAboveHomeMetres = mission.HeightMetres,
        SpeedMetresPerSecond = mission.SpeedMetresPerSecond,
    };

    private ImmutableArray<GeodeticPosition> Positions(IEnumerable<PlanePoint> points, double down)
        => points.Select(p => Frame.ToGeodetic(new NedPosition(p.North, p.East, down))).ToImmutableArray();
}
