using System.Collections.Generic;

namespace Rabit.Diagnostics.Protocol;

/// <summary>The wiring of the reactors.</summary>
internal sealed record GraphLine
{
    public string Type { get; init; } = "graph";

    public string Format { get; init; } = string.Empty;

    public IReadOnlyList<ReactorGraph> Reactors { get; init; } = [];
}
