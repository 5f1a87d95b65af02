namespace Rabit.Diagnostics.Protocol;

/// <summary>One manager at one moment; counts since the start of the run.</summary>
internal sealed record ManagerFigures
{
    public string Name { get; init; } = string.Empty;

    /// <summary>The name of a state, in small letters.</summary>
    public string State { get; init; } = string.Empty;

    public long Runs { get; init; }

    /// <summary>By the clock of the run.</summary>
    public double? RunsPerSecond { get; init; }

    /// <summary>The part of real time that its units of work took, 0 to 1.</summary>
    public double? Load { get; init; }

    public WakeUpFigures WakeUps { get; init; } = new();

    public TimesFigures UnitOfWork { get; init; } = new();

    public TimesFigures WakeLatency { get; init; } = new();

    public TimesFigures PeriodError { get; init; } = new();

    public long MissedDeadlines { get; init; }

    public long LateUnitsOfWork { get; init; }

    public long Faults { get; init; }

    public string? LastFault { get; init; }

    public long Restarts { get; init; }

    public long Hangs { get; init; }

    public string? LastHang { get; init; }
}
