using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav;
using Rabit.Uav.MissionControl;

namespace UavConsole;

/// <summary>What the command line asked for about the checklist and the autopilot's own settings.</summary>
internal sealed class PreflightChoices
{
    /// <summary>Names of lines that may fail.</summary>
    public IReadOnlyList<string> Overrides { get; init; } = [];

    public bool SetsFailsafes { get; init; }

    public bool UploadsFence { get; init; }

    /// <summary>Where the autopilot's own values are kept.</summary>
    public string OriginalsFile { get; init; } = PreflightArguments.DefaultOriginals;

    /// <summary>Whether the mission is flown without a camera.</summary>
    public bool IsWithoutDetection { get; init; }

    /// <summary>Sets the options of a system that flies a mission.</summary>
    public void ApplyTo(UavOptions options, MissionPlan mission, bool isSimulated)
    {
        options.Preflight.Overrides = Overrides;
        if (isSimulated)
            return;
        options.Preflight.UtcNow = () => DateTimeOffset.UtcNow;
        options.MissionControl.RequiresCamera = !IsWithoutDetection;
        options.Autopilot.Setup.OriginalsFile = OriginalsFile;
        options.Autopilot.Setup.SetsFailsafes = SetsFailsafes;
        if (UploadsFence)
        {
            options.Autopilot.Setup.Fence = mission.AutopilotFence;
            options.Autopilot.Setup.KeepOuts = mission.KeepOuts.Select(k => k.ToArray()).ToArray();
        }

    }
}
