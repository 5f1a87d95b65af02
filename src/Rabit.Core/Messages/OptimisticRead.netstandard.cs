namespace Rabit.Core.Messages;

/// <summary>
/// netstandard2.0 has no barriers that are cheap enough, and some older runtimes that use it, Mono among them, have had
/// faults in those they have: each fetch pins.
/// </summary>
internal static class OptimisticRead
{
    /// <summary>How often a fetcher tries before it pins: never.</summary>
    public const int Tries = 0;

    /// <summary>How many spare slots a poster has: one to write while the one before is still read.</summary>
    public const int Spares = 2;
}
