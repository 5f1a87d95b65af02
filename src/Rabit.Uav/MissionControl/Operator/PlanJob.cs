using Rabit.Core;
using Rabit.Geodesy;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// A mission to be planned beside the flight: planning takes longer than a unit of work may. Mission Control makes it,
/// the planner's thread fills it, and once it is done it is Mission Control's again.
/// </summary>
[HandedOver]
internal sealed class PlanJob(
    MissionPlan mission, GeodeticPosition home, bool isFixedWing, TerrainGrid? terrain = null, bool isShared = false)
{
    private volatile bool _isDone;

    public MissionPlan Mission { get; } = mission;

    /// <summary>Whether the others may be read.</summary>
    public bool IsDone => _isDone;

    /// <summary>Null where it cannot be flown.</summary>
    public FlightPlan? Plan { get; private set; }

    /// <summary>The route of the plan, with nothing flown or seen.</summary>
    public SearchRoute? Route { get; private set; }

    /// <summary>Why it cannot be flown.</summary>
    public string Fault { get; private set; } = "it could not be planned";

    /// <summary>On the planner's thread.</summary>
    public void Make()
    {
        try
        {
            Plan = FlightPlan.Create(
                Mission, home, out string fault, isFixedWing: isFixedWing, isQuick: true, terrain: terrain,
                isShared: isShared);
            Fault = fault;
            Route = Plan is null ? null : new SearchRoute(Plan, Mission.LaneSpacingMetres);
        }
        finally
        {
            _isDone = true;
        }
    }
}
