using Rabit.Latency.Native;

namespace Rabit.Latency.Signals;

/// <summary>The limit; with a timer beside it, what a manager's sleep cannot go below.</summary>
/// <param name="hasTimer">Whether every wait has a deadline, an hour away.</param>
internal sealed class FutexSignal(bool hasTimer) : Signal
{
    private const long AnHour = 3_600_000_000_000;

    private readonly FutexWord _word = new();

    public override void Set() => _word.Set();

    public override void Wait()
    {
        if (hasTimer)
            _word.WaitUntil(MonotonicClock.Now + AnHour);
        else
            _word.Wait();
    }

    public override void Dispose() => _word.Dispose();
}
