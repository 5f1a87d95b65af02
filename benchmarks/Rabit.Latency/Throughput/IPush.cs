namespace Rabit.Latency.Throughput;

/// <summary>
/// The end of a bounded queue that puts in. Implemented by structs, so that the loop around it is compiled for each.
/// </summary>
internal interface IPush<T>
{
    /// <returns>False when the queue is full.</returns>
    bool TryPush(in T value);
}
