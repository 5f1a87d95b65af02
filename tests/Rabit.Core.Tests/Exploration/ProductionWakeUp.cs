using System;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Tests.Exploration;

/// <summary>The code that flies, with a wait engine of its own.</summary>
internal sealed class ProductionWakeUp : WakeUpUnderTest
{
    private readonly WakeUpEvent<ExploredSyncPoints> _wakeUp = new();
    private readonly StepLoop<ExploredSyncPoints> _loop;

    public ProductionWakeUp(IWaitSignal signal, RunClock clock)
    {
        _wakeUp.Connect(signal, clock);
        _loop = new StepLoop<ExploredSyncPoints>(_wakeUp, signal, clock);
    }

    public static WakeUpUnderTest OnEvent(RunClock clock)
        => new ProductionWakeUp(new EventWaitSignal<ExploredSyncPoints>(clock), clock);

    public static WakeUpUnderTest OnFutex(RunClock clock)
        => new ProductionWakeUp(new FutexWaitSignal<ExploredSyncPoints>(clock), clock);

    public static Func<RunClock, WakeUpUnderTest> On(string engine) => engine switch
    {
        "event" => OnEvent,
        "futex" => OnFutex,
        _ => throw new ArgumentException($"No wait engine is called {engine}.", nameof(engine)),
    };

    public override void Wake(WakeUpCauses cause) => _wakeUp.Wake(cause);

    public override void RequestStop() => _wakeUp.RequestStop();

    public override void Run(NextStep next, Func<ConsumedWakeUps, TimeSpan?, NextStep> runStep)
        => _loop.Run(next, runStep);
}
