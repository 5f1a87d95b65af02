namespace Rabit.Diagnostics.Protocol;

/// <summary>The wiring of one reactor; empty before its start.</summary>
internal sealed record ReactorGraph
{
    public string Name { get; init; } = string.Empty;

    public string Text { get; init; } = string.Empty;
}
