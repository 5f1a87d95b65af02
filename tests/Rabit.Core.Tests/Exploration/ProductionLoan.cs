using System;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Tests.Exploration;

/// <summary>The code that flies, with a wait engine of its own.</summary>
internal sealed class ProductionLoan : LoanUnderTest
{
    private readonly WakeUpEvent<ExploredSyncPoints> _wakeUp = new();
    private readonly StepLoop<ExploredSyncPoints> _loop;

    private ProductionLoan(IWaitSignal signal, RunClock clock)
    {
        _wakeUp.Connect(signal, clock);
        _loop = new StepLoop<ExploredSyncPoints>(_wakeUp, signal, clock);
    }

    public static Func<RunClock, LoanUnderTest> On(string engine) => engine switch
    {
        "event" => clock => new ProductionLoan(new EventWaitSignal<ExploredSyncPoints>(clock), clock),
        "futex" => clock => new ProductionLoan(new FutexWaitSignal<ExploredSyncPoints>(clock), clock),
        _ => throw new ArgumentException($"No wait engine is called {engine}.", nameof(engine)),
    };

    public override void Wake(WakeUpCauses cause) => _wakeUp.Wake(cause);

    public override void RequestStop() => _wakeUp.RequestStop();

    public override bool TryBorrow() => _wakeUp.TryBorrow();

    public override ConsumedWakeUps ConsumeLent() => _wakeUp.ConsumeLent();

    public override void EndLoan(bool isToWake) => _wakeUp.EndLoan(isToWake);

    public override void Run(NextStep next, Func<ConsumedWakeUps, TimeSpan?, NextStep> runStep)
        => _loop.Run(next, runStep);
}
