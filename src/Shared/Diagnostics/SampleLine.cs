using System.Collections.Generic;

namespace Rabit.Diagnostics.Protocol;

/// <summary>One sample of everything.</summary>
internal sealed record SampleLine
{
    public string Type { get; init; } = "status";

    /// <summary>Counts the lines of a stream from 1.</summary>
    public long Sequence { get; init; }

    /// <summary>Samples that were left out so far, since the client did not take the ones before.</summary>
    public long SkippedSamples { get; init; }

    public IReadOnlyList<ReactorFigures> Reactors { get; init; } = [];
}
