using System;
using System.Collections.Generic;

namespace Rabit.Core.Tests.Exploration;

/// <summary>What an exploration found.</summary>
/// <param name="Fault">The first broken promise; null where all were kept, in every interleaving.</param>
/// <param name="Schedule">The steps to it.</param>
/// <param name="Interleavings">
/// How many runs there are, from the beginning to the end; those that two ways make equal on the way are walked once.
/// </param>
/// <param name="States">How many states they go through.</param>
/// <param name="Steps">How many steps were taken.</param>
internal sealed record ExplorationResult(
    string? Fault, IReadOnlyList<string> Schedule, double Interleavings, long States, long Steps)
{
    public override string ToString()
        => Fault is null
            ? FormattableString.Invariant($"{Interleavings:G4} interleavings, {States} states, {Steps} steps: no fault")
            : $"{Fault}\n  {string.Join("\n  ", Schedule)}";
}
