using System;
using System.Linq;
using Rabit.Uav.ImageProcessing;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing.Pictures;

public sealed class PictureRateTests
{
    [Theory]
    [InlineData(30, 10)]
    [InlineData(30, 7)]
    [InlineData(25, 24)]
    public void Takes_MoreThanWanted_TakesAsManyAsWanted(double given, double wanted)
    {
        var rate = new PictureRate(wanted);

        int taken = Enumerable.Range(0, (int)(100 * given)).Count(i => rate.Takes(TimeSpan.FromSeconds(i / given)));

        Assert.InRange(taken, 100 * wanted * 0.99, (100 * wanted * 1.01) + 1);
    }

    [Fact]
    public void Takes_AsManyAsWantedWithJitter_TakesAll()
    {
        const int Seed = 3;
        var random = new Random(Seed);
        var rate = new PictureRate(10);

        int taken = Enumerable.Range(0, 1000).Count(
            i => rate.Takes(TimeSpan.FromSeconds((i / 10.0) + (0.04 * random.NextDouble()))));

        Assert.True(taken == 1000, $"seed {Seed}: {taken} of 1000");
    }

    [Fact]
    public void Takes_AfterAGap_DoesNotCatchUp()
    {
        var rate = new PictureRate(10);
        rate.Takes(TimeSpan.Zero);

        int taken = Enumerable.Range(0, 100).Count(i => rate.Takes(TimeSpan.FromSeconds(60 + (i / 100.0))));

        Assert.InRange(taken, 10, 11);
    }

    // The first one starts the clock, however late the camera begins, or begins again.
    [Theory]
    [InlineData(0)]
    [InlineData(0.07)]
    [InlineData(10)]
    public void Takes_ManyFromAMomentOn_TakesNoTwoAtOnce(double from)
    {
        var rate = new PictureRate(5);

        double[] taken = Enumerable.Range(0, 100).Select(i => from + (i / 50.0))
            .Where(t => rate.Takes(TimeSpan.FromSeconds(t))).ToArray();

        Assert.Equal(from, taken[0]);
        Assert.All(taken.Zip(taken.Skip(1), (a, b) => b - a), gap => Assert.InRange(gap, 0.099, 0.221));
    }
}
