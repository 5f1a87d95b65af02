using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.SensorFusion;
using Xunit;

namespace Rabit.Uav.Tests.SensorFusion;

/// <summary>The three best pictures of a track.</summary>
public sealed class BestReportsTests
{
    private const int Seed = 3;

    [Fact]
    public void None_HasNoPicture()
    {
        BestReports best = default;

        Assert.Equal((-1L, 0), (best.PictureNumber, best.ReportIndex));
        Assert.Empty(best.Others);
    }

    [Fact]
    public void Add_Many_KeepsTheThreeBestInTheirOrder()
    {
        var random = new Random(Seed);
        for (int run = 0; run < 200; run++)
        {
            double[] scores = [.. Enumerable.Range(0, random.Next(1, 9)).Select(_ => random.Next(5) / 4.0)];
            BestReports best = default;
            for (int i = 0; i < scores.Length; i++)
                best.Add(scores[i], new TrackPicture(i, i % 3));

            // Of equal ones the first.
            long[] expected =
                [.. Enumerable.Range(0, scores.Length).OrderByDescending(i => scores[i]).Take(3).Select(i => (long)i)];
            Assert.Equal(expected, Pictures(ref best));
        }
    }

    [Fact]
    public void Add_NoNumber_IsNotTaken()
    {
        BestReports best = default;
        best.Add(double.NaN, new TrackPicture(4, 0));
        Assert.Equal(-1, best.PictureNumber);
        best.Add(0.5, new TrackPicture(5, 0));
        best.Add(double.NaN, new TrackPicture(6, 0));

        Assert.Equal([5L], Pictures(ref best));
    }

    [Fact]
    public void Add_ThoseOfAnotherTrack_AreTheBestOfBoth()
    {
        BestReports one = default;
        one.Add(0.9, new TrackPicture(1, 0));
        one.Add(0.3, new TrackPicture(2, 0));
        BestReports other = default;
        other.Add(0.8, new TrackPicture(3, 2));
        other.Add(0.1, new TrackPicture(4, 0));
        one.Add(other);

        Assert.Equal([1L, 3, 2], Pictures(ref one));
        Assert.Equal(2, one.Others[0].ReportIndex);
        Assert.Equal([3L, 4], Pictures(ref other));
    }

    private static IEnumerable<long> Pictures(ref BestReports best)
        => [best.PictureNumber, .. best.Others.Select(o => o.PictureNumber)];
}
