namespace Rabit.Diagnostics.Protocol;

/// <summary>What woke a manager, since the start of the run.</summary>
internal sealed record WakeUpFigures
{
    public long Timer { get; init; }

    public long Post { get; init; }

    public long Push { get; init; }

    public long Pop { get; init; }

    public long Request { get; init; }

    public long Device { get; init; }

    /// <summary>Wake-ups that merged with one that waited.</summary>
    public long Merged { get; init; }
}
