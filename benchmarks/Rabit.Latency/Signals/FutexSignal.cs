using Rabit.Latency.Native;

namespace Rabit.Latency.Signals;

/// <summary>The limit.</summary>
internal sealed class FutexSignal : Signal
{
    private readonly FutexWord _word = new();

    public override void Set() => _word.Set();

    public override void Wait() => _word.Wait();

    public override void Dispose() => _word.Dispose();
}
