namespace Rabit.Diagnostics.Protocol;

/// <summary>What a client asks for.</summary>
internal sealed record RequestLine
{
    public const string Status = "status";
    public const string Graph = "graph";
    public const string Echo = "echo";

    public string? Request { get; init; }

    /// <summary>Of a status or an echo: how often. Without it one line is the answer.</summary>
    public int? EveryMilliseconds { get; init; }

    /// <summary>Of a graph: text, mermaid or dot.</summary>
    public string? Format { get; init; }

    /// <summary>Of an echo: the name of the message.</summary>
    public string? Message { get; init; }

    /// <summary>The name of one reactor; without it all.</summary>
    public string? Reactor { get; init; }
}
