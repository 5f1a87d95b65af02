using System;
using Rabit.Core.Diagnostics;
using Rabit.Core.Reactors;
using Rabit.Core.Time;

namespace Rabit.Core;

/// <summary>
/// The one seam through which anything in Rabit reads the time or waits. Give one to the reactor:
/// <see cref="RealTime"/> (threads and the machine's clock) or <see cref="VirtualTime"/> (one thread, a clock that
/// jumps, an order fixed by a seed). Manager code does not see the difference.
/// </summary>
public abstract class RabitTime
{
    private protected RabitTime()
    {
    }

    /// <summary>
    /// The clock. Managers see it as <see cref="RabitManager.Clock"/>; anything else that needs the time takes it from
    /// here.
    /// </summary>
    public abstract TimeProvider Clock { get; }

    /// <summary>Whether a source or target that blocks its thread may be used.</summary>
    internal abstract bool AllowsBlocking { get; }

    /// <summary>The event log of the run, where this kind of time has one and it was asked for.</summary>
    internal virtual EventLog? CreateEventLog(RunClock clock, Action<Exception> fail) => null;

    internal abstract ReactorEngine CreateEngine(EngineContext context);
}
