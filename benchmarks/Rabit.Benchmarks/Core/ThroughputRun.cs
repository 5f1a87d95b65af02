using System;

namespace Rabit.Benchmarks.Core;

/// <summary>Senders and a receiver on threads of their own, that transfer a number of messages when told to.</summary>
internal abstract class ThroughputRun : IDisposable
{
    /// <summary>Comes back when the last message was received.</summary>
    /// <param name="messages">In all; each sender sends its share.</param>
    public abstract void Transfer(int messages);

    public abstract void Dispose();
}
