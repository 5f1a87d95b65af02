using System;

namespace Rabit.Latency.Idle;

/// <summary>Sixteen things that do nothing, again and again. They run from their making to their end.</summary>
internal abstract class Sleepers : IDisposable
{
    public const int Number = 16;

    public abstract void Dispose();
}
