using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.MissionControl;

/// <summary>Which height layers of a group a mission has room for.</summary>
internal static class HeightLayers
{
    /// <summary>
    /// What is wrong with a mission in the layer of a vehicle, to be read after its name; where it is right in layer 0,
    /// with the number of vehicles that there is room for.
    /// </summary>
    /// <param name="mission">As its file says.</param>
    /// <param name="group">The layer, above 0.</param>
    public static IEnumerable<string> FindFaults(MissionPlan mission, GroupOptions group)
    {
        string[] faults = FindFaults(mission, group.HeightLayer, group);
        int room = Enumerable.Range(0, GroupOptions.MaxLayer + 1)
            .TakeWhile(layer => FindFaults(mission, layer, group).Length == 0).Count();
        if (faults.Length == 0 || room == 0)
            return faults.Select(f => ": " + f);
        string layer = MissionNumbers.Of(group.HeightLayer);
        string where = $" in layer {layer}, {MissionNumbers.Of(group.LayerMetres)} m above layer 0: ";
        string fits = $"; with {MissionNumbers.Of(group.LayerSpacingMetres)} m from one layer to the next there is "
            + (room == 1
                ? "room for 1 vehicle, in layer 0"
                : $"room for {MissionNumbers.Of(room)} vehicles, in layers 0 to {MissionNumbers.Of(room - 1)}");
        return faults.Select((f, i) => where + f + (i == faults.Length - 1 ? fits : string.Empty));
    }

    private static string[] FindFaults(MissionPlan mission, int layer, GroupOptions group)
        => MissionPlanRules.FindFaults(
            layer == 0 ? mission : mission.HigherBy(layer * group.LayerSpacingMetres)).ToArray();
}
