using System;
using Rabit.Core.Diagnostics;

namespace Rabit.Core;

/// <summary>A seed whose run fails, each time: what <see cref="SeedSearch"/> finds. Immutable.</summary>
public sealed class FailingSeed
{
    internal FailingSeed(long seed, Exception failure)
    {
        Seed = seed;
        Failure = failure;
    }

    /// <summary>Run it again, with <see cref="VirtualTime.EventLog"/>, to see how it comes about.</summary>
    public long Seed { get; }

    /// <summary>What left the run.</summary>
    public Exception Failure { get; }

    /// <summary>One line: the seed and what went wrong.</summary>
    public override string ToString()
        => FormattableString.Invariant($"seed {Seed} fails: {ExceptionText.MessageOf(Failure)}");
}
