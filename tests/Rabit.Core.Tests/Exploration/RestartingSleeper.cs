using System;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// A sleeper whose unit of work has just thrown: it is restarted when the delay is over, and sleeps and runs then. What
/// is kept over the restart, and when what follows, are those of <see cref="KeptWakeUps"/>.
/// </summary>
internal sealed class RestartingSleeper(
    SeededRestartFault fault, TimeSpan resumeAt, RunClock clock, WakeUpUnderTest wakeUp,
    Action<NextStep, ConsumedWakeUps, TimeSpan?> beginUnit, Action<ExploredState> end) : ExploredThread("sleeper")
{
    public override object Begin => new State(
        fault == SeededRestartFault.WakeEndsTheBackOff ? NextStep.At(resumeAt) : NextStep.OnlyAt(resumeAt), default,
        IsRestarting: true);

    public override object? Run(object from)
    {
        var state = (State)from;
        wakeUp.Run(state.Planned, (wakes, wokenAt) => throw Recorder.End(RunStep(state, wakes, wokenAt)));
        ExploredSyncPoints.Note("ended", end);
        return null;
    }

    private State RunStep(State state, ConsumedWakeUps wakes, TimeSpan? wokenAt)
    {
        KeptWakeUps kept = state.Kept;
        if (!state.IsRestarting)
        {
            ConsumedWakeUps all = fault == SeededRestartFault.WakesOfTheStartUpForgotten && !state.HasRun
                ? kept.Take(default)
                : kept.Take(wakes);
            beginUnit(state.Planned, all, wokenAt);
            return new State(NextStep.At(TimeSpan.MaxValue), kept, IsRestarting: false, HasRun: true);
        }

        bool isEarly = kept.TryWait(wakes, clock.Now, resumeAt, out NextStep next);
        if (isEarly && fault != SeededRestartFault.WakeEndsTheBackOff)
            return new State(next, kept, IsRestarting: true);
        if (fault == SeededRestartFault.EarlierWakesForgotten)
            kept = default;
        ExploredSyncPoints.Note("starts up", s => s.Require(s.Now >= resumeAt, "a start-up in the back-off"));
        next = kept.StartedAgain(clock.Now);
        if (fault != SeededRestartFault.RunsInTheSameStep)
            return new State(next, kept, IsRestarting: false);
        beginUnit(next, kept.Take(default), wokenAt);
        return new State(NextStep.At(TimeSpan.MaxValue), kept, IsRestarting: false, HasRun: true);
    }

    private readonly record struct State(
        NextStep Planned, KeptWakeUps Kept, bool IsRestarting, bool HasRun = false);
}
