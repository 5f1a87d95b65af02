using System;

namespace Rabit.Benchmarks.Core.Queues;

/// <summary>Something that moves messages through a queue, and is timed.</summary>
internal interface IContender : IDisposable
{
    string Name { get; }

    /// <summary>Comes back when all were pushed and popped.</summary>
    void Transfer(int messages);
}
