using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Simulation;

namespace UavConsole;

/// <summary>What the simulated camera is like, and what it sees.</summary>
internal sealed class SimulatedLook
{
    /// <summary>What holds it.</summary>
    public SimulatedGimbal Gimbal { get; init; }

    /// <summary>What makes its pictures worse: moderate or harsh; nothing else does.</summary>
    public string? Effects { get; init; }

    /// <summary>What the targets are, in turn; none: coloured panels.</summary>
    public IReadOnlyList<SimulatedTargetKind> TargetKinds { get; init; } = [];

    /// <summary>How many of them are overgrown.</summary>
    public int PartlyHidden { get; init; }

    /// <summary>How many trees and roofs hide what is below them.</summary>
    public int Occluders { get; init; }

    /// <summary>Before the world is made.</summary>
    public void ApplyTo(SimulationOptions world)
    {
        world.Camera.Gimbal = Gimbal;
        if (Effects == "moderate")
            Apply(world.Camera, SimulatedPictureEffects.CreateModerate(), exposureMilliseconds: 6);
        else if (Effects == "harsh")
            Apply(world.Camera, SimulatedPictureEffects.CreateHarsh(), exposureMilliseconds: 12);
        (world.TargetKinds, world.PartlyHiddenCount) = (TargetKinds, PartlyHidden);
        world.OccluderCount = Occluders;
    }

    /// <summary>
    /// The mission, which also searches for the classes of such targets, and points the gimbal where one holds the
    /// camera.
    /// </summary>
    public MissionPlan Declare(MissionPlan mission, SimulatedWorld world)
    {
        MissionPlan declared = mission.WithTargets(world.Targets.Select(t => t.Declared).OfType<TargetClass>());
        return Gimbal == SimulatedGimbal.AgainstBody ? declared : declared.WithGimbal();
    }

    private static void Apply(SimulatedCameraOptions camera, SimulatedPictureEffects effects, int exposureMilliseconds)
        => (camera.Effects, camera.Exposure) = (effects, TimeSpan.FromMilliseconds(exposureMilliseconds));
}
