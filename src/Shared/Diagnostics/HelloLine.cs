using System.Collections.Generic;

namespace Rabit.Diagnostics.Protocol;

/// <summary>The first line that a program sends.</summary>
internal sealed record HelloLine
{
    /// <summary>
    /// The version of the protocol. One that adds fields, or answers new requests, keeps its number.
    /// </summary>
    public const int CurrentProtocol = 1;

    public string Type { get; init; } = "hello";

    public int Protocol { get; init; } = CurrentProtocol;

    public string Program { get; init; } = string.Empty;

    public int ProcessId { get; init; }

    /// <summary>The version of the package.</summary>
    public string Version { get; init; } = string.Empty;

    public IReadOnlyList<string> Reactors { get; init; } = [];
}
