using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Simulation;

namespace UavConsole;

/// <summary>The targets of the simulation that move, for <c>--moving</c>.</summary>
internal static class SimulatedMotions
{
    private static readonly SimulatedMotion[] InTurn =
        [SimulatedMotion.Walking, SimulatedMotion.Vehicle, SimulatedMotion.Erratic];

    public static SimulatedMotion[] MotionsOf(int count)
        => Enumerable.Range(0, count).Select(i => InTurn[i % InTurn.Length]).ToArray();

    /// <summary>
    /// The motions of the classes with targets that move, as a mission file may declare them; without those that the
    /// mission does declare, which count.
    /// </summary>
    public static ImmutableDictionary<TargetClassName, TargetMotion> Declare(
        MissionPlan mission, SimulatedWorld world)
        => world.Targets
            .Where(t => t.Motion != SimulatedMotion.Standing && !mission.TargetMotions.ContainsKey(t.Class))
            .GroupBy(t => t.Class)
            .ToImmutableDictionary(c => c.Key, c => c.Max(t => MotionOf(t.Motion)));

    // One that moves erratically turns and brakes as a vehicle does. Of a class with several, the liveliest.
    private static TargetMotion MotionOf(SimulatedMotion motion)
        => motion == SimulatedMotion.Walking ? TargetMotion.Walking : TargetMotion.Vehicle;
}
