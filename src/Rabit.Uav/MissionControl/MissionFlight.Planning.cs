using System.Linq;
using Rabit.Geodesy;

namespace Rabit.Uav.MissionControl;

// How the plan is made, before the flight and in it.
internal sealed partial class MissionFlight
{
    /// <summary>Plans the mission from the present position of the vehicle, or continues an earlier flight.</summary>
    /// <returns>Why that cannot be; empty where it can.</returns>
    public string CreatePlan()
    {
        GeodeticPosition at = Vehicle.Position;
        string fault = CreatePlan(GeodeticPosition.FromRadians(
            at.Latitude.Radians, at.Longitude.Radians, at.AltitudeAmslMetres - HeightMetres));
        if (fault.Length > 0 || Energy.CheckPlan(this) is not { } shortage)
            return fault;
        // Of a group each flies a share, which is not known before the others have taken off.
        if (!Mission.AllowsPartialSearch && !Options.AllowsPartialSearch && Group is null)
        {
            return shortage + "; with allowPartialSearch of the mission, or --allow-partial-search, it is begun, and "
                + "returns in time";
        }

        Log(shortage + ": begun all the same, it returns in time");
        return string.Empty;
    }

    /// <summary>
    /// Plans the mission for a vehicle that is in the air already: only the progress of its flight says where home is.
    /// </summary>
    /// <returns>Why that cannot be; null where it can.</returns>
    public string? PlanInFlight()
    {
        if (Options.Resume is not { } progress)
            return "where home is, is not known without the progress of the flight";
        string fault = CreatePlan(progress.Home);
        GroundAltitudeAmslMetres = progress.Home.AltitudeAmslMetres;
        return fault.Length > 0 ? fault : null;
    }

    private string CreatePlan(GeodeticPosition home)
    {
        if (Options.Resume is not { } progress)
        {
            Plan = FlightPlan.Create(
                Mission, home, out string fault, isFixedWing: IsFixedWing, isQuick: !Options.PlansShortestWay,
                terrain: Options.Terrain, isShared: Group is not null);
            Route = Plan is null ? null : new SearchRoute(Plan, Mission.LaneSpacingMetres);
            return fault;
        }

        NedPosition off = LocalNedFrame.IgnoringGeoid(home).ToNed(progress.Home);
        var earlier = new PlanePoint(off.North, off.East);
        if (!(earlier.Length <= FlightPlan.MaxHomeDistanceMetres))
        {
            return $"the progress is of another place: its home is {MissionNumbers.Of(earlier.Length)} m away; the "
                + $"limit is {MissionNumbers.Of(FlightPlan.MaxHomeDistanceMetres)} m";
        }

        Plan = FlightPlan.Create(
            Mission, home, out string faultOfPlan,
            progress.Legs.Select(l => new LaneSegment(l.Start + earlier, l.End + earlier)).ToArray(), IsFixedWing,
            terrain: Options.Terrain);
        if (Plan is null)
            return faultOfPlan;
        Route = new SearchRoute(Plan, Mission.LaneSpacingMetres);
        Route.Resume(progress, earlier, OverlapMetres);
        bool isComplete = Route.Current is null && Route.Coverage.Fraction >= CoverageGoal;
        return isComplete ? "the progress is that of a search that is complete" : string.Empty;
    }

    /// <summary>
    /// Goes on with another mission from here: what was seen of its area already is not flown over again. In a phase
    /// that flies legs the next unit of work begins the first leg of the new plan.
    /// </summary>
    /// <param name="mission">The mission; its home is not looked at.</param>
    /// <returns>Why that cannot be; null where it was done.</returns>
    public string? Replan(MissionPlan mission)
    {
        if (Plan is null || Route is null)
            return "there is no plan yet";
        if (MissionPlanRules.FindFaults(mission).FirstOrDefault() is { } wrong)
            return wrong;
        FlightPlan? plan = FlightPlan.Create(
            mission, Plan.Frame.Origin, out string fault, isFixedWing: IsFixedWing,
            isQuick: IsFlying || !Options.PlansShortestWay, terrain: Options.Terrain, isShared: Group is not null);
        return plan is null ? fault : Replan(mission, plan, new SearchRoute(plan, mission.LaneSpacingMetres));
    }

    /// <summary>The same with a plan that was made before, and its route, which is not used elsewhere.</summary>
    public string? Replan(MissionPlan mission, FlightPlan plan, SearchRoute route)
    {
        if (Plan is null || Route is null)
            return "there is no plan yet";
        if (IsFlying && plan.InsideMetres(Position) < 0)
        {
            return plan.Fence.SignedDistance(Position) < 0 ? "the vehicle is outside the new fence"
                : "the vehicle is inside a keep-out";
        }

        route.GoOnFrom(Route);
        if (!IsFixedWing)
        {
            route.LeaveOutSeen(OverlapMetres);
            route.Reorder(Position);
        }

        (Mission, Plan, Route) = (mission, plan, route);
        Energy.Mission = mission;
        return null;
    }
}
