using System;

namespace Rabit.Latency.Measuring;

/// <summary>Something to do when a subject ends.</summary>
internal sealed class Ending(Action end) : IDisposable
{
    public void Dispose() => end();
}
