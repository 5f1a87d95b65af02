using System;

namespace Rabit.Latency.PingPong;

/// <summary>Two threads that wake each other in turn.</summary>
internal abstract class PingPongTarget : IDisposable
{
    /// <summary>Goes back and forth a number of times.</summary>
    /// <returns>The nanoseconds that all of it took.</returns>
    public abstract long Play(int roundTrips);

    public abstract void Dispose();

    /// <returns>The mean of one way in microseconds, and of both.</returns>
    public double[] Run(int roundTrips)
    {
        double both = Play(roundTrips) / 1e3 / roundTrips;
        return [both, both / 2];
    }
}
