using System;
using Rabit.Core.Reactors;
using Rabit.Core.WakeUp;

namespace Rabit.Core;

/// <summary>
/// Real time: every manager, reader and writer on a thread of its own, timed waits by the operating system. The
/// default.
/// </summary>
public sealed class RealTime : RabitTime
{
    /// <summary>Real time by the machine's clock.</summary>
    public RealTime()
        : this(TimeProvider.System)
    {
    }

    /// <summary>Real time by another clock, for example one that is disciplined by a GPS receiver.</summary>
    /// <param name="clock">
    /// Its <see cref="TimeProvider.GetTimestamp"/> must be monotonic and run at the pace of real time; its wall clock
    /// may jump.
    /// </param>
    public RealTime(TimeProvider clock) => Clock = Require.NotNull(clock, nameof(clock));

    /// <inheritdoc/>
    public override TimeProvider Clock { get; }

    /// <summary>What threads sleep on. Set before the start.</summary>
    /// <value>The default is <see cref="WaitEngine.Best"/>.</value>
    /// <exception cref="ArgumentOutOfRangeException">There is no such engine.</exception>
    public WaitEngine WaitEngine
    {
        get;
        set => field = value is WaitEngine.Best or WaitEngine.Event or WaitEngine.Futex
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "There is no such wait engine.");
    }

    internal override bool AllowsBlocking => true;

    internal override ReactorEngine CreateEngine(EngineContext context)
    {
        WaitEngine engine = WaitEngines.Choose(
            WaitEngine, Environment.GetEnvironmentVariable(WaitEngines.Variable), Futex.IsThere, out string? note);
        if (note is not null)
            context.Log.Write(RabitLogKind.Note, "wait engine", note);
        return new ThreadEngine(context, engine);
    }
}
