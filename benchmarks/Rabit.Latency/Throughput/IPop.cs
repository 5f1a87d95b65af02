namespace Rabit.Latency.Throughput;

/// <summary>
/// The end of a queue that takes out. Implemented by structs, so that the loop around it is compiled for each.
/// </summary>
internal interface IPop<T>
{
    /// <returns>False when the queue is empty.</returns>
    bool TryPop(out T value);
}
