using System.Collections.Generic;
using Rabit.Mavlink;
using Rabit.Uav.Messages;

namespace Rabit.Uav.GroundControl;

/// <summary>
/// The names under which the values of the mission are parameters of our component, in the order of their indices.
/// docs/ground-stations.md lists them.
/// </summary>
internal static class MissionParameterTable
{
    public static readonly IReadOnlyList<(string Name, MissionParameter Parameter)> All =
    [
        ("RBT_HEIGHT", MissionParameter.Height),
        ("RBT_SPEED", MissionParameter.Speed),
        ("RBT_SPACING", MissionParameter.LaneSpacing),
        ("RBT_REVISIT", MissionParameter.Revisits),
        ("RBT_REVISIT_HGT", MissionParameter.RevisitHeight),
        ("RBT_REVISIT_RAD", MissionParameter.RevisitRadius),
        ("RBT_BAT_START", MissionParameter.BatteryAtStart),
        ("RBT_BAT_RESERVE", MissionParameter.EnergyReserve),
        ("RBT_COVERAGE", MissionParameter.RequiredCoverage),
    ];

    /// <summary>The index of a name; -1 where there is none.</summary>
    public static int IndexOf(string name)
    {
        for (int i = 0; i < All.Count; i++)
        {
            if (string.Equals(All[i].Name, name, System.StringComparison.Ordinal))
                return i;
        }

        return -1;
    }
}
