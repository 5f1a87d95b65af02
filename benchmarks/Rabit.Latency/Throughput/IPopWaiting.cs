namespace Rabit.Latency.Throughput;

/// <summary>The end of a queue that takes out, and whose thread sleeps while there is nothing.</summary>
internal interface IPopWaiting<T>
{
    T Pop();
}
