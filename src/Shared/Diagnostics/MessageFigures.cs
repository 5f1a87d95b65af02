namespace Rabit.Diagnostics.Protocol;

/// <summary>One message at one moment.</summary>
internal sealed record MessageFigures
{
    public string Name { get; init; } = string.Empty;

    /// <summary>The type of its values.</summary>
    public string ValueType { get; init; } = string.Empty;

    /// <summary>Since the start of the run.</summary>
    public long Posts { get; init; }

    public double? PostsPerSecond { get; init; }

    /// <summary>How long ago the latest value was true; null before the first post.</summary>
    public double? AgeSeconds { get; init; }
}
