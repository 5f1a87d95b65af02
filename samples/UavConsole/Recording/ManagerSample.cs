using System;
using Rabit.Core;

namespace UavConsole;

/// <summary>How a manager stood at one moment; counts are since the start, so that samples may be left out. A plain value.</summary>
internal readonly struct ManagerSample(TimeSpan time, ManagerState state, long runs, long faults)
{
    /// <summary>By the clock of the run.</summary>
    public TimeSpan Time { get; } = time;

    public ManagerState State { get; } = state;

    public long Runs { get; } = runs;

    public long Faults { get; } = faults;
}
