using System;

namespace Rabit.Core;

/// <summary>
/// Searches for bugs of order: runs the same small system in virtual time once for each seed, every time in another
/// legal order, until a run fails.
/// </summary>
/// <remarks>
/// Units of work are put in another order, and shifted where their duration is modelled; they are never cut in two.
/// What goes wrong only between two lines of one unit of work is found by other means.
/// </remarks>
public static class SeedSearch
{
    /// <summary>
    /// Runs the seeds one after the other, on the calling thread, and returns with the first that fails.
    /// </summary>
    /// <param name="firstSeed">The first seed.</param>
    /// <param name="count">How many seeds at most; above zero.</param>
    /// <param name="run">
    /// Makes new managers and a reactor in the virtual time that it is given, runs it, and throws when something went
    /// wrong: an assertion of a test will do. Called once for each seed; it must depend on nothing else.
    /// </param>
    /// <returns>The first seed that failed, and how; null when none did.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The count is not above zero.</exception>
    /// <exception cref="InvalidOperationException">
    /// A seed failed and did not fail when it was run once more: something beside the seed decides, perhaps a clock or
    /// a thread of the system's own. The first failure is the inner exception.
    /// </exception>
    public static FailingSeed? Find(long firstSeed, int count, Action<VirtualTime> run)
    {
        Require.NotNull(run, nameof(run));
        if (count <= 0)
            throw new ArgumentOutOfRangeException(nameof(count), count, "A search needs at least one seed.");
        for (int i = 0; i < count; i++)
        {
            long seed = unchecked(firstSeed + i);
            if (FailureOf(seed, run) is not { } failure)
                continue;
            if (FailureOf(seed, run) is null)
                throw new InvalidOperationException(FormattableString.Invariant(
                    $"Seed {seed} failed once and passed when it was run again: something beside the seed decides."),
                        failure);
            return new FailingSeed(seed, failure);
        }

        return null;
    }

    private static Exception? FailureOf(long seed, Action<VirtualTime> run)
    {
        try
        {
            run(new VirtualTime(seed));
            return null;
        }
        catch (Exception e)
        {
            // Whatever the user's check throws is what was searched for.
            return e;
        }
    }
}
