using System;
using Rabit.Core;

namespace Rabit.Uav.Reporting;

/// <summary>
/// The state of a manager at one moment; counts are since the start, so that samples may be left out. A plain value.
/// </summary>
/// <param name="time">By the clock of the run.</param>
/// <param name="state">As last posted.</param>
/// <param name="runs">Units of work.</param>
/// <param name="faults">Faults.</param>
public readonly struct ManagerSample(TimeSpan time, ManagerState state, long runs, long faults)
{
    /// <summary>By the clock of the run.</summary>
    public TimeSpan Time { get; } = time;

    /// <summary>As last posted.</summary>
    public ManagerState State { get; } = state;

    /// <summary>How many units of work it had executed.</summary>
    public long Runs { get; } = runs;

    /// <summary>How many faults it had had.</summary>
    public long Faults { get; } = faults;
}
