using System;

namespace Rabit.Latency.Signals;

/// <summary>What a thread written without Rabit sleeps on: the peers of a manager's wake-up.</summary>
internal abstract class Signal : IDisposable
{
    public abstract void Set();

    public abstract void Wait();

    public abstract void Dispose();
}
