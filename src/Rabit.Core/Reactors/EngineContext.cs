using System;
using Rabit.Core.Diagnostics;
using Rabit.Core.Time;

namespace Rabit.Core.Reactors;

/// <summary>What an engine needs of its reactor.</summary>
internal sealed class EngineContext(RunClock clock, RabitLog log, Action<Exception> fail)
{
    public RunClock Clock { get; } = clock;

    public RabitLog Log { get; } = log;

    /// <summary>Stops the run because the engine itself found an error.</summary>
    public Action<Exception> Fail { get; } = fail;
}
