using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The flight over one target, to the other side of it and back, with the target in the middle of the picture halfway.
/// Both directions at speed separate a wrong time of the pictures from a wrong mount of the camera; the heading does
/// not change on the way. Immutable.
/// </summary>
internal sealed class RevisitPass
{
    // The vehicle flies and holds to within a few metres.
    private const double FenceReserveMetres = 5;

    // Relative to the direction across the lanes from the side of the vehicle. The first that stays inside the fence is
    // flown: across the lanes a target is seen from the direction that no lane gives.
    private static readonly double[] Directions = [0, 180, 45, -45, 135, -135, 90, -90];

    private RevisitPass(PlanePoint overhead, double headingRadians, double radiusMetres)
    {
        PlanePoint half = radiusMetres * PlanePoint.Towards(headingRadians);
        (Overhead, HeadingRadians) = (overhead, headingRadians);
        (Start, Beyond) = (overhead - half, overhead + half);
        IsThrough = radiusMetres > 0;
    }

    /// <summary>Where it begins.</summary>
    public PlanePoint Start { get; }

    /// <summary>None: the vehicle stays where it is.</summary>
    public static RevisitPass Stay(MissionFlight flight)
        => new(flight.Position, flight.Vehicle.Attitude.Yaw.Radians, radiusMetres: 0);

    /// <summary>Where the vehicle is when the optical axis of the camera meets the target.</summary>
    public PlanePoint Overhead { get; }

    /// <summary>Where the vehicle turns back.</summary>
    public PlanePoint Beyond { get; }

    /// <summary>Of the vehicle, on the whole pass.</summary>
    public double HeadingRadians { get; }

    /// <summary>Whether it has a way: without one the vehicle flies straight to its place over the target.</summary>
    public bool IsThrough { get; }

    /// <summary>How far it is from a place over the pass to its end.</summary>
    public double LengthFrom(PlanePoint place)
        => place.DistanceTo(Start) + Start.DistanceTo(Beyond) + Beyond.DistanceTo(Overhead);

    /// <summary>The pass over a target; null where the target cannot be seen from inside the fence.</summary>
    /// <param name="flight">The vehicle, the mission and its fence.</param>
    /// <param name="target">Where the target is.</param>
    public static RevisitPass? Plan(MissionFlight flight, PlanePoint target)
    {
        MissionPlan mission = flight.Mission;
        PlanePoint across = PlanePoint.Towards(flight.Plan!.HeadingRadians + (Math.PI / 2));
        double first = across.HeadingRadians + (across.Dot(target - flight.Position) >= 0 ? 0 : Math.PI);
        double radius = mission.Revisit.RadiusMetres;
        IEnumerable<RevisitPass> passes =
            from r in radius > 0 ? new[] { radius, radius / 2, 0 } : [0]
            from direction in Directions
            let heading = first + (direction * Math.PI / 180)
            select new RevisitPass(PlaceToSee(flight, target, heading), heading, r);
        return passes.FirstOrDefault(pass => pass.IsInside(flight));
    }

    /// <summary>Where the vehicle is when the optical axis of its camera meets a target.</summary>
    /// <param name="flight">The vehicle and the mission.</param>
    /// <param name="target">Where the target is.</param>
    /// <param name="headingRadians">Of the vehicle.</param>
    public static PlanePoint PlaceToSee(MissionFlight flight, PlanePoint target, double headingRadians)
        => target - Sight(flight, target, headingRadians);

    // From the vehicle to where the optical axis meets the ground; the mission's pitch is at most -20 degrees.
    private static PlanePoint Sight(MissionFlight flight, PlanePoint target, double headingRadians)
    {
        MissionPlan mission = flight.Mission;
        double height = flight.Plan!.HeightAboveGround(target, mission.Revisit.HeightMetres ?? mission.HeightMetres);
        double distance = height * Math.Tan((Math.PI / 2) + mission.CameraPitch.Radians);
        return distance * PlanePoint.Towards(headingRadians + mission.CameraYaw.Radians);
    }

    private bool IsInside(MissionFlight flight)
        => new[] { Start, Overhead, Beyond }.All(p => flight.Plan!.InsideMetres(p) >= FenceReserveMetres);
}
