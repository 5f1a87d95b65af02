namespace Rabit.Diagnostics.Protocol;

/// <summary>How long something took, since the start of the run; null where it is not measured.</summary>
internal sealed record TimesFigures
{
    public double? P50Seconds { get; init; }

    public double? P99Seconds { get; init; }

    public double? MaxSeconds { get; init; }
}
