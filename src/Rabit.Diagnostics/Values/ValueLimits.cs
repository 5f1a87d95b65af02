namespace Rabit.Diagnostics.Values;

/// <summary>How much of a value is written; what is left out is named in its place.</summary>
internal sealed record ValueLimits
{
    public int MaxDepth { get; init; } = 12;

    /// <summary>Of one collection.</summary>
    public int MaxItems { get; init; } = 100;

    /// <summary>Of one text, in characters.</summary>
    public int MaxTextLength { get; init; } = 2000;

    /// <summary>Of one message: members and items.</summary>
    public int MaxParts { get; init; } = 5000;
}
