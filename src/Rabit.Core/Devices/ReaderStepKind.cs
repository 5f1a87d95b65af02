namespace Rabit.Core;

/// <summary>The three things a read can come to.</summary>
public enum ReaderStepKind
{
    /// <summary>Nothing now.</summary>
    Wait,

    /// <summary>A value.</summary>
    Value,

    /// <summary>Nothing now or later.</summary>
    Ended,
}
