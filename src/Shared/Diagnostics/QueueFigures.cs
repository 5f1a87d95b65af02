namespace Rabit.Diagnostics.Protocol;

/// <summary>One queue at one moment; counts since the start of the run.</summary>
internal sealed record QueueFigures
{
    public string Name { get; init; } = string.Empty;

    /// <summary>The type of its values.</summary>
    public string ValueType { get; init; } = string.Empty;

    /// <summary>How many values are in it.</summary>
    public int Level { get; init; }

    public int HighWater { get; init; }

    public int Capacity { get; init; }

    public long Pushed { get; init; }

    public double? PushesPerSecond { get; init; }

    public long Popped { get; init; }

    public long Dropped { get; init; }

    public long Rejected { get; init; }
}
