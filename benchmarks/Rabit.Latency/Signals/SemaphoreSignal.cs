using System.Threading;

namespace Rabit.Latency.Signals;

/// <summary>A <see cref="SemaphoreSlim"/>, which spins before it sleeps.</summary>
internal sealed class SemaphoreSignal : Signal
{
    private readonly SemaphoreSlim _semaphore = new(0);

    public override void Set() => _semaphore.Release();

    public override void Wait() => _semaphore.Wait();

    public override void Dispose() => _semaphore.Dispose();
}
