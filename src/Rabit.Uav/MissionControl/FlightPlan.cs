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

    // Of the vehicle from a keep-out: what it drifts and overshoots.
    private const double ClearanceMetres = MissionPlanRules.FenceReserveMetres;

    // Nearer than this a path around a keep-out is not looked for.
    private const double MinClearanceMetres = 0.5;

    // By so much the vehicle may be nearer to a keep-out, where a path begins.
    private const double SlackMetres = 2;

    private readonly SearchRegion _airspace;
    private readonly SearchRegion _lastResort;

    private FlightPlan(
        MissionPlan mission, LocalNedFrame frame, IReadOnlyList<LaneSegment>? lanes, bool isFixedWing, bool isQuick,
        bool isShared)
    {
        Frame = frame;
        Area = ToPlane(mission.Area, frame);
        KeepOuts = KeepOutsOf(mission, frame);
        Fence = FenceOutline.Of(Area, default, mission.FenceMarginMetres);
        _airspace = new SearchRegion(
            FenceOutline.Of(Area, default, mission.FenceMarginMetres - ClearanceMetres), KeepOuts, ClearanceMetres,
            SlackMetres, SlackMetres);
        _lastResort = new SearchRegion(Fence, KeepOuts, ClearanceMetres, 0, ClearanceMetres - MinClearanceMetres);

        lanes ??= isShared
            ? PlanSharedLanes(mission, frame, isQuick)
            : PlanLanes(mission, frame, isFixedWing, isQuick);
        Lanes = lanes ?? [];
        HeadingRadians = mission.LaneHeading?.Radians
            ?? Lanes.OrderByDescending(l => l.Length).Select(l => l.HeadingRadians).FirstOrDefault();
    }

    /// <summary>Its origin is on the ground, at home.</summary>
    public LocalNedFrame Frame { get; }

    public PlanePolygon Area { get; }

    /// <summary>Where it may not fly; of the area they are not searched.</summary>
    public IReadOnlyList<PlanePolygon> KeepOuts { get; }

    /// <summary>
    /// The geofence, which the vehicle may not leave. Where it is not convex, a straight path may leave it:
    /// <see cref="PathBetween"/>.
    /// </summary>
    public PlanePolygon Fence { get; }

    /// <summary>Direction of the lanes, of the longest where they differ, radians clockwise from true north.</summary>
    public double HeadingRadians { get; }

    public IReadOnlyList<LaneSegment> Lanes { get; }

    /// <summary>The plan as other managers receive it.</summary>
    public SearchPlan Message { get; private set; } = new();

    /// <summary>Heights over the terrain; null where the ground is taken for level.</summary>
    public TerrainFollowing? Terrain { get; private set; }

    /// <summary>Plans a mission.</summary>
    /// <param name="mission">The mission.</param>
    /// <param name="home">Position of the vehicle; its altitude is that of the ground.</param>
    /// <param name="fault">Why the mission cannot be flown from there; empty where it can.</param>
    /// <param name="lanes">Lanes that were planned before; null to plan them.</param>
    /// <param name="isFixedWing">Whether the lanes are those of a fixed wing: parallel, and all of a length.</param>
    /// <param name="isQuick">Whether the vehicle flies, and waits for the plan.</param>
    /// <param name="terrain">The ground; null where it is taken for level.</param>
    /// <param name="isShared">
    /// Whether the lanes are those of a group: the same, and in the same order, wherever home is.
    /// </param>
    public static FlightPlan? Create(
        MissionPlan mission, GeodeticPosition home, out string fault, IReadOnlyList<LaneSegment>? lanes = null,
        bool isFixedWing = false, bool isQuick = false, TerrainGrid? terrain = null, bool isShared = false)
    {
        var frame = LocalNedFrame.IgnoringGeoid(home);
        fault = FindFault(mission, frame) ?? string.Empty;
        if (fault.Length > 0)
            return null;
        var plan = new FlightPlan(mission, frame, lanes, isFixedWing, isQuick, isShared);
        fault = plan.FindKeepOutFault(isFixedWing) ?? string.Empty;
        if (fault.Length > 0)
            return null;
        double far = plan.Lanes.Max(l => Math.Max(l.Start.Length, l.End.Length)) + MissionPlanRules.FenceReserveMetres;
        if (far > mission.MaxDistanceMetres)
        {
            fault = $"a lane ends {MissionNumbers.Of(far - MissionPlanRules.FenceReserveMetres)} m from home; with a "
                + $"reserve of {MissionNumbers.Of(MissionPlanRules.FenceReserveMetres)} m it must be within "
                + $"limits.maxDistanceMetres, {MissionNumbers.Of(mission.MaxDistanceMetres.Value)} m";
        }
        else if (plan.Lanes.Count > MaxLanes)
            fault = $"it has {MissionNumbers.Of(plan.Lanes.Count)} lanes; the limit is {MissionNumbers.Of(MaxLanes)}";
        else if (terrain is not null)
            fault = plan.FollowTerrain(terrain, mission, isFixedWing) ?? string.Empty;
        plan.Message = plan.ToMessage(mission);
        return fault.Length > 0 ? null : plan;
    }

    /// <summary>The height above home to fly at a place.</summary>
    /// <param name="at">The place.</param>
    /// <param name="heightMetres">Above ground; above home where the ground is taken for level.</param>
    public double HeightAboveHome(PlanePoint at, double heightMetres)
        => Terrain?.HeightAboveHome(at, heightMetres) ?? heightMetres;

    /// <summary>The height above ground at which a place is flown over.</summary>
    /// <param name="at">The place.</param>
    /// <param name="heightMetres">The height that is kept.</param>
    public double HeightAboveGround(PlanePoint at, double heightMetres)
        => Terrain is null ? heightMetres : Terrain.HeightAboveHome(at, heightMetres) - Terrain.GroundMetres(at);

    /// <summary>The height of the ground above home; 0 where it is taken for level, or not known.</summary>
    public double GroundAboveHome(PlanePoint at)
        => Terrain?.GroundMetres(at) is { } ground && !double.IsNaN(ground) ? ground : 0;

    /// <summary>The height above home that is enough on the whole way between two places.</summary>
    public double HeightAboveHome(PlanePoint from, PlanePoint to, double heightMetres)
        => Terrain?.HeightAboveHome(from, to, heightMetres) ?? heightMetres;

    /// <summary>How much is climbed on the way between two places, and the height above home at its end.</summary>
    public (double ClimbedMetres, double HeightMetres) ClimbBetween(
        PlanePoint from, PlanePoint to, double heightMetres)
        => Terrain?.ClimbBetween(from, to, heightMetres) ?? (0, heightMetres);

    /// <summary>Whether the vehicle can follow the terrain at a speed; null where it can.</summary>
    public string? FindFaultOfSpeed(double metresPerSecond)
        => Terrain is null || metresPerSecond <= Terrain.MaxSpeedMetresPerSecond
            ? null
            : $"speedMetresPerSecond is {MissionNumbers.Of(metresPerSecond)}; the heights over the terrain are planned "
                + $"for {MissionNumbers.Of(Terrain.MaxSpeedMetresPerSecond)} at most";

    /// <summary>Whether the area can be flown over at the heights of a mission; null where it can.</summary>
    public string? FindHeightFault(MissionPlan mission)
    {
        if (Terrain is null)
            return null;
        double limit = mission.MaxHeightMetres - MissionPlanRules.HeightReserveMetres
            ?? MissionPlanRules.MaxHeightMetres;
        double height = mission.Revisit.IsEnabled
            ? Math.Max(mission.HeightMetres, mission.Revisit.HeightMetres ?? 0)
            : mission.HeightMetres;
        (double highest, PlanePoint at) = Terrain.MaxHeightAboveGround(height);
        return highest <= limit
            ? null
            : $"over the terrain the vehicle is up to {MissionNumbers.Of(highest)} m above ground, at "
                + $"{MissionNumbers.Of(at)} from home; the limit is {MissionNumbers.Of(limit)} m. Slower than "
                + $"{MissionNumbers.Of(Terrain.MaxSpeedMetresPerSecond)} m/s it follows the ground more closely";
    }

    /// <summary>
    /// The points between two others on the shortest path that stays in the fence and clear of the keep-outs; none
    /// where it is straight, or where there is no such path.
    /// </summary>
    public IReadOnlyList<PlanePoint> PathBetween(PlanePoint a, PlanePoint b)
        => _airspace.PathBetween(a, b) ?? _lastResort.PathBetween(a, b) ?? [];

    /// <summary>Legs in the order and the directions in which the way from a place is shortest.</summary>
    public IReadOnlyList<LaneSegment> Ordered(IReadOnlyList<LaneSegment> legs, PlanePoint from)
        => LaneOrder.Find(_airspace, legs.Select(l => (l.Start, l.End)).ToArray(), from)
            ?.Select(o => o.IsReversed ? new LaneSegment(legs[o.Lane].End, legs[o.Lane].Start) : legs[o.Lane]).ToArray()
            ?? legs;

    /// <summary>Length of the way from a place along legs, with the straight ways between them.</summary>
    public static double WayAlong(IReadOnlyList<LaneSegment> legs, PlanePoint from)
    {
        double sum = 0;
        foreach (LaneSegment leg in legs)
        {
            sum += from.DistanceTo(leg.Start) + leg.Length;
            from = leg.End;
        }

        return sum;
    }

    /// <summary>
    /// How far a place is inside the fence and outside the keep-outs, metres; below zero elsewhere.
    /// </summary>
    public double InsideMetres(PlanePoint at)
    {
        double inside = Fence.SignedDistance(at);
        foreach (PlanePolygon keepOut in KeepOuts)
            inside = Math.Min(inside, -keepOut.SignedDistance(at));
        return inside;
    }

    private string? FollowTerrain(TerrainGrid terrain, MissionPlan mission, bool isFixedWing)
    {
        if (isFixedWing)
            return "a fixed wing does not follow terrain";
        Terrain = TerrainFollowing.Create(terrain, Frame, Fence, mission.SpeedMetresPerSecond, out string fault);
        if (Terrain is null)
            return fault;
        Terrain.AddPlaces(Area, KeepOuts);
        PlanePoint at = default;
        foreach (PlanePoint end in Lanes.SelectMany(l => new[] { l.Start, l.End }))
        {
            foreach (PlanePoint next in PathBetween(at, end).Append(end))
            {
                Terrain.AddPlaces(at, next);
                at = next;
            }
        }

        return FindHeightFault(mission);
    }

    private string? FindKeepOutFault(bool isFixedWing)
    {
        if (KeepOuts.Count > 0 && isFixedWing)
            return "a fixed wing flies no area with keepOuts: its circles would enter them";
        for (int i = 0; i < KeepOuts.Count; i++)
        {
            if (KeepOuts[i].SignedDistance(default) > -ClearanceMetres)
                return $"keepOuts[{MissionNumbers.Of(i)}] contains home, or is within "
                    + $"{MissionNumbers.Of(ClearanceMetres)} m of it";
        }

        if (Lanes.Count == 0)
            return "the keepOuts cut the area in two, or leave nothing of it";
        return KeepOuts.Count > 0 && _airspace.PathBetween(default, Lanes[0].Start) is null
            ? "the keepOuts leave no way from home to the area"
            : null;
    }

    // On a convex area plain lanes have fewer corners, at each of which a multirotor stops.
    private static IReadOnlyList<LaneSegment>? PlanLanes(
        MissionPlan mission, LocalNedFrame frame, bool isFixedWing, bool isQuick)
    {
        PlanePolygon area = ToPlane(mission.Area, frame);
        PlanePolygon[] keepOuts = KeepOutsOf(mission, frame);
        return isFixedWing || (keepOuts.Length == 0 && FenceOutline.IsNearlyConvex(area))
            ? LanePlanner.Plan(area, mission.LaneSpacingMetres, mission.LaneHeading?.Radians, from: default)
            : SearchPlanner.Plan(
                area, keepOuts, ClearanceMetres, mission.LaneSpacingMetres, mission.LaneHeading?.Radians,
                from: default, isQuick)?.Legs;
    }

    // In a frame that all have: its origin is the first corner of the area.
    private static LaneSegment[]? PlanSharedLanes(
        MissionPlan mission, LocalNedFrame frame, bool isQuick)
    {
        var common = LocalNedFrame.IgnoringGeoid(mission.Area[0]);
        return PlanLanes(mission, common, isFixedWing: false, isQuick)
            ?.Select(l => new LaneSegment(ToOurs(l.Start), ToOurs(l.End))).ToArray();

        PlanePoint ToOurs(PlanePoint p)
            => ToPoint(frame.ToNed(common.ToGeodetic(new NedPosition(p.North, p.East, 0))));
    }

    private static PlanePolygon[] KeepOutsOf(MissionPlan mission, LocalNedFrame frame)
        => mission.KeepOuts.IsDefault ? [] : mission.KeepOuts.Select(k => ToPlane(k, frame)).ToArray();

    private static PlanePoint ToPoint(NedPosition ned) => new(ned.North, ned.East);

    private static PlanePolygon ToPlane(ImmutableArray<GeodeticPosition> corners, LocalNedFrame frame)
        => new(corners.Select(c => ToPoint(frame.ToNed(c))));

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
        KeepOuts = KeepOuts.Select(k => Positions(k.Corners, down: 0)).ToImmutableArray(),
        Lanes = Lanes.SelectMany(l => new[] { l.Start, l.End })
            .Select(p => ToPosition(p, -HeightAboveHome(p, mission.HeightMetres))).ToImmutableArray(),
        Home = Frame.Origin,
        HeightAboveHomeMetres = mission.HeightMetres,
        SpeedMetresPerSecond = mission.SpeedMetresPerSecond,
    };

    private ImmutableArray<GeodeticPosition> Positions(IEnumerable<PlanePoint> points, double down)
        => points.Select(p => ToPosition(p, down)).ToImmutableArray();

    private GeodeticPosition ToPosition(PlanePoint p, double down)
        => Frame.ToGeodetic(new NedPosition(p.North, p.East, down));
}
