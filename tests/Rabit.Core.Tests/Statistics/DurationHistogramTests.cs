using System;
using System.Linq;
using System.Reflection;
using Rabit.Core.Statistics;
using Xunit;

namespace Rabit.Core.Tests.Statistics;

/// <summary>Contract 4.4: percentiles from a histogram of fixed size, against the sorted values themselves.</summary>
public sealed class DurationHistogramTests
{
    private const double Error = 1 / 16.0;

    [Theory, Trait("Clause", "4.4")]
    [InlineData(1)]
    [InlineData(7)]
    [InlineData(1000)]
    [InlineData(25_000)]
    public void Percentiles_RandomDurations_AreWithinASixteenth(int count)
    {
        const int Seed = 20260;
        var random = new Random(Seed + count);
        for (int round = 0; round < 20; round++)
        {
            // From a tick to days, each octave as likely as the next.
            double octaves = random.Next(1, 43);
            long[] ticks = Enumerable.Range(0, count)
                .Select(_ => (long)Math.Pow(2, random.NextDouble() * octaves)).ToArray();
            var histogram = new DurationHistogram();
            foreach (long t in ticks)
                histogram.Add(new TimeSpan(t));
            histogram.Percentiles(out TimeSpan half, out TimeSpan p99, out TimeSpan p999);

            Array.Sort(ticks);
            AssertNear(ticks[count - (count / 2) - 1], half);
            AssertNear(ticks[count - (count / 100) - 1], p99);
            AssertNear(ticks[count - (count / 1000) - 1], p999);

            void AssertNear(long exact, TimeSpan found) => Assert.True(
                found.Ticks >= exact && found.Ticks <= exact * (1 + Error),
                $"seed {Seed + count}, round {round}: {found.Ticks} for {exact}");
        }
    }

    [Theory, Trait("Clause", "4.4")]
    [InlineData(-5, 0)]
    [InlineData(0, 0)]
    [InlineData(1, 1)]
    [InlineData(15, 15)]
    [InlineData(16, 16)]
    [InlineData(31, 31)]
    [InlineData(32, 33)]
    [InlineData(long.MaxValue, (1L << 43) - 1)]
    public void Percentiles_OneDuration_IsTheUpperEndOfItsStep(long ticks, long expected)
    {
        var histogram = new DurationHistogram();
        histogram.Add(new TimeSpan(ticks));
        histogram.Percentiles(out TimeSpan half, out TimeSpan p99, out TimeSpan p999);

        Assert.Equal((expected, expected, expected), (half.Ticks, p99.Ticks, p999.Ticks));
    }

    [Fact, Trait("Clause", "4.4")]
    public void Add_ToAFullStep_ChangesNothing()
    {
        var histogram = new DurationHistogram();
        histogram.Add(TimeSpan.FromTicks(3));
        FieldInfo field = typeof(DurationHistogram)
            .GetField("_counts", BindingFlags.Instance | BindingFlags.NonPublic)!;
        var counts = (int[])field.GetValue(histogram)!;
        int step = Array.IndexOf(counts, 1);
        counts[step] = int.MaxValue;   // as after years

        histogram.Add(TimeSpan.FromTicks(3));
        histogram.Percentiles(out TimeSpan half, out _, out TimeSpan p999);

        Assert.Equal(int.MaxValue, counts[step]);
        Assert.Equal((3, 3), (half.Ticks, p999.Ticks));
    }

    [Fact, Trait("Clause", "4.4")]
    public void Clear_Later_StartsAgain()
    {
        var histogram = new DurationHistogram();
        histogram.Add(TimeSpan.FromSeconds(1));
        histogram.Clear();
        histogram.Percentiles(out TimeSpan none, out _, out _);
        histogram.Add(TimeSpan.FromTicks(3));
        histogram.Percentiles(out TimeSpan half, out _, out TimeSpan p999);

        Assert.Equal(TimeSpan.Zero, none);
        Assert.Equal((3, 3), (half.Ticks, p999.Ticks));
    }
}
