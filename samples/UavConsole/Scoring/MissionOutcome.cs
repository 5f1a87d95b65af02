using System;
using System.Collections.Generic;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>What a mission came to, and whether that is what was asked for. Immutable.</summary>
internal sealed class MissionOutcome
{
    /// <summary>Against the truth; null where none is known.</summary>
    public MissionScore? Score { get; init; }

    /// <summary>The plan that was flown; null where Mission Control never made one.</summary>
    public SearchPlan? Plan { get; init; }

    public MissionPhase Phase { get; init; }

    /// <summary>Why the search was given up before its end; null where it was not.</summary>
    public string? Aborted { get; init; }

    /// <summary>0 to 100.</summary>
    public double CoveragePercent { get; init; }

    public double FlownMetres { get; init; }

    /// <summary>From arming to disarming.</summary>
    public TimeSpan FlightTime { get; init; }

    /// <summary>0 to 100; NaN where the autopilot does not know it.</summary>
    public double BatteryUsedPercent { get; init; }

    /// <summary>Whether it flew and stands on the ground with its motors off.</summary>
    public bool HasLanded { get; init; }

    /// <summary>How far from home it stands at the end; NaN where that is not known.</summary>
    public double DistanceFromHomeMetres { get; init; }

    /// <summary>The farthest that it was outside the fence; 0 where it never was.</summary>
    public double OutsideFenceMetres { get; init; }

    /// <summary>What the mission failed by, for people; none when it did not.</summary>
    public IReadOnlyList<string> Failures { get; init; } = [];

    public bool HasPassed => Failures.Count == 0;
}
