namespace Rabit.Latency.Contention;

/// <summary>A message that is immutable.</summary>
internal sealed class PoseObject(double timeSeconds)
{
    public double TimeSeconds { get; } = timeSeconds;
}
