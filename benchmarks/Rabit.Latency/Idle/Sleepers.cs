using System;

namespace Rabit.Latency.Idle;

/// <summary>
/// Things that do nothing, again and again: sixteen where nothing else is said. They run from their making to their
/// end.
/// </summary>
internal abstract class Sleepers : IDisposable
{
    public const int Number = 16;

    public abstract void Dispose();
}
