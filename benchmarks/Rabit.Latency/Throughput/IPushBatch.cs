using System;

namespace Rabit.Latency.Throughput;

/// <summary>As <see cref="IPush{T}"/>, several values at a time.</summary>
internal interface IPushBatch<T>
{
    /// <returns>How many of them, from the first, were put in.</returns>
    int PushFrom(ReadOnlySpan<T> values);
}
