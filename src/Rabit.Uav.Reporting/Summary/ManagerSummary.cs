using System;
using Rabit.Core;

namespace Rabit.Uav.Reporting;

/// <summary>What one manager did in a run. Immutable.</summary>
public sealed class ManagerSummary
{
    /// <summary>Makes an empty one; set the properties.</summary>
    public ManagerSummary()
    {
    }

    /// <summary>Makes it of a manager's result.</summary>
    /// <param name="result">How the manager ended.</param>
    /// <param name="unitOfWorkTime">Of its units of work in real time, also where the run was in virtual time.</param>
    public ManagerSummary(ManagerResult result, in DurationStatistics unitOfWorkTime)
    {
        if (result is null)
            throw new ArgumentNullException(nameof(result));
        Name = result.Name;
        Description = result.ToString();
        Outcome = result.Outcome.ToString();
        Runs = result.Runs;
        Faults = result.FaultCount;
        FirstFault = result.Faults.Count == 0 ? null : result.Faults[0].ToString();
        MeanWork = unitOfWorkTime.Mean;
        LongestWork = unitOfWorkTime.Max;
        TotalWork = unitOfWorkTime.Total;
    }

    /// <summary>The name of the manager.</summary>
    public string Name { get; init; } = string.Empty;

    /// <summary>How it ended, in one line for people.</summary>
    public string Description { get; init; } = string.Empty;

    /// <summary>How it ended.</summary>
    public string Outcome { get; init; } = string.Empty;

    /// <summary>How many units of work it executed.</summary>
    public long Runs { get; init; }

    /// <summary>How many faults it had.</summary>
    public long Faults { get; init; }

    /// <summary>The first fault; null where there was none.</summary>
    public string? FirstFault { get; init; }

    /// <summary>Mean duration of its units of work, in real time.</summary>
    public TimeSpan MeanWork { get; init; }

    /// <summary>Longest duration of a unit of work, in real time.</summary>
    public TimeSpan LongestWork { get; init; }

    /// <summary>Total duration of its units of work, in real time.</summary>
    public TimeSpan TotalWork { get; init; }
}
