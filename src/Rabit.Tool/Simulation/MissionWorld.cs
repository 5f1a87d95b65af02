using System;
using System.IO;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Simulation;

namespace Rabit.Tool.Simulation;

/// <summary>
/// Takes from a mission file what the world must agree with: home, if it says one, the area in which the targets
/// lie, and the direction of a camera that is fixed.
/// </summary>
internal static class MissionWorld
{
    /// <exception cref="ArgumentException">The file is no mission; the text says why.</exception>
    public static void Read(string path, SimulationOptions world)
    {
        try
        {
            world.TakePlacesFrom(MissionPlan.Parse(
                File.ReadAllText(path), path, Path.GetDirectoryName(Path.GetFullPath(path))));
        }
        catch (MissionPlanException e)
        {
            throw new ArgumentException($"--mission {path}: {e.Sentence}", nameof(path), e);
        }
    }
}
