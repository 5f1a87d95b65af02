namespace Rabit.Core.Messages;

/// <summary>How values are read that a poster may be writing; see <see cref="SharedValue{T}"/>.</summary>
internal static class OptimisticRead
{
    /// <summary>How often a fetcher tries before it pins.</summary>
    public const int Tries = 4;

    /// <summary>
    /// How many spare slots a poster has: a fetch is spoilt where as many posts come during one copy.
    /// </summary>
    public const int Spares = 7;
}
