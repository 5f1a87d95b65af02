using System.Collections.Generic;

namespace Rabit.Diagnostics.Protocol;

/// <summary>
/// One reactor at one moment. Rates are over the time since the sample before, and null in the first.
/// </summary>
internal sealed record ReactorFigures
{
    public string Name { get; init; } = string.Empty;

    /// <summary>Whether its managers are wired; before that there is nothing to see.</summary>
    public bool IsStarted { get; init; }

    /// <summary>The clock of the run.</summary>
    public double TimeSeconds { get; init; }

    /// <summary>Seconds of the run's clock in a second: 1 in real time.</summary>
    public double? Speed { get; init; }

    public IReadOnlyList<ManagerFigures> Managers { get; init; } = [];

    public IReadOnlyList<QueueFigures> Queues { get; init; } = [];

    /// <summary>Without the statuses of the managers, which are in <see cref="Managers"/>.</summary>
    public IReadOnlyList<MessageFigures> Messages { get; init; } = [];
}
