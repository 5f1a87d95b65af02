using System;
using System.Collections.Generic;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Simulation.Tests.Missions;

namespace Rabit.Uav.Simulation.Tests.FaultMatrix;

/// <summary>
/// The world of the fault matrix: a small search; a ground station on its own radio; the failsafes set to return, as
/// the pre-flight checklist wants them.
/// </summary>
internal static class MatrixWorld
{
    private static readonly Dictionary<string, double> Ardupilot = new(StringComparer.Ordinal)
    {
        ["FS_GCS_ENABLE"] = 1,
        ["FS_THR_ENABLE"] = 1,
        ["FS_EKF_ACTION"] = 1,
        ["BATT_FS_LOW_ACT"] = 2,
        ["BATT_FS_CRT_ACT"] = 1,
        ["BATT_LOW_VOLT"] = 9.9,
        ["BATT_CRT_VOLT"] = 9.6,
        ["BATT_LOW_TIMER"] = 3,
        ["FENCE_ENABLE"] = 1,
        ["FENCE_TYPE"] = 1,
        ["FENCE_ACTION"] = 1,
    };

    private static readonly Dictionary<string, double> Px4 = new(StringComparer.Ordinal)
    {
        ["NAV_DLL_ACT"] = 2,
        ["NAV_RCL_ACT"] = 2,
        ["COM_RC_IN_MODE"] = 3,
        ["COM_OBL_RC_ACT"] = 3,
        ["COM_LOW_BAT_ACT"] = 3,
        ["GF_ACTION"] = 3,
    };

    /// <summary>The small search; a revisit over its two lanes takes more than a third of their way.</summary>
    public static MissionPlan Mission() => MissionPlan.Parse(
        SearchFlight.SmallMission.Replace(
            "\"heightMetres\": 30", "\"revisit\": { \"maxWayFraction\": 2 }, \"heightMetres\": 30"),
        "small");

    public static SimulationOptions Options(SimulatedAutopilot model, long seed, params ScriptedFault[] faults) => new()
    {
        Autopilot = model,
        Seed = seed,
        TargetCount = 2,
        DistractorCount = 1,
        HasGroundStation = true,
        Parameters = model == SimulatedAutopilot.Px4 ? Px4 : Ardupilot,
        Camera = SimulatedCameraOptions.CreateLowResolution(),
        Faults = faults,
    };
}
