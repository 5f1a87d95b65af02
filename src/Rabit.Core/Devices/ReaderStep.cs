using System;

namespace Rabit.Core;

/// <summary>What a call of <see cref="IReaderSource{T}.Read"/> came to. A plain value.</summary>
public readonly struct ReaderStep
{
    private ReaderStep(ReaderStepKind kind, TimeSpan due)
    {
        Kind = kind;
        Due = due;
    }

    /// <summary>A value was read.</summary>
    public static ReaderStep Value => new(ReaderStepKind.Value, TimeSpan.Zero);

    /// <summary>Nothing now; ask again when <see cref="ReaderContext.Signal"/> was called.</summary>
    public static ReaderStep WaitForSignal => new(ReaderStepKind.Wait, TimeSpan.MaxValue);

    /// <summary>Nothing now or later.</summary>
    public static ReaderStep Ended => new(ReaderStepKind.Ended, TimeSpan.Zero);

    /// <summary>Which of the three.</summary>
    public ReaderStepKind Kind { get; }

    /// <summary>
    /// When to ask again, by the clock of the run; <see cref="TimeSpan.MaxValue"/> for at a signal only.
    /// </summary>
    public TimeSpan Due { get; }

    /// <summary>Nothing now; ask again at a time, or when <see cref="ReaderContext.Signal"/> was called.</summary>
    /// <param name="due">By the clock of the run; a time that has passed means at once.</param>
    public static ReaderStep WaitUntil(TimeSpan due)
        => new(ReaderStepKind.Wait, due < TimeSpan.Zero ? TimeSpan.Zero : due);
}
