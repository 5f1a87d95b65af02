using System;

namespace Rabit.Latency.Throughput;

/// <summary>As <see cref="IPop{T}"/>, several values at a time.</summary>
internal interface IPopBatch<T>
{
    /// <returns>How many were taken out; 0 when the queue is empty.</returns>
    int PopInto(Span<T> target);
}
