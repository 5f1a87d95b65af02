namespace Rabit.Diagnostics.Protocol;

/// <summary>Why a request, or a client, is refused.</summary>
internal sealed record ErrorLine
{
    public string Type { get; init; } = "error";

    public string Text { get; init; } = string.Empty;
}
