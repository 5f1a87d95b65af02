using Rabit.Geodesy;
using Rabit.Tests.Shared;
using Rabit.Uav.SensorFusion;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.SensorFusion;

public class PositionFilterTests(ITestOutputHelper output)
{
    [Fact]
    public void Update_IndependentAxes_IsTheMeanWeightedByTheInverseVariances()
    {
        var filter = new PositionFilter(1, 10, new HorizontalCovariance(4, 0, 1));
        filter.Update(7, 20, new HorizontalCovariance(2, 0, 4));
        Assert.Equal(((1 / 4.0) + (7 / 2.0)) / ((1 / 4.0) + (1 / 2.0)), filter.North, 1e-12);
        Assert.Equal((10 + (20 / 4.0)) / (1 + (1 / 4.0)), filter.East, 1e-12);
        Assert.Equal(1 / ((1 / 4.0) + (1 / 2.0)), filter.Covariance.NorthNorth, 1e-12);
        Assert.Equal(1 / (1 + (1 / 4.0)), filter.Covariance.EastEast, 1e-12);
        Assert.Equal(0, filter.Covariance.NorthEast);
    }

    [Fact]
    public void Update_InAnyOrder_IsTheSame()
    {
        (double North, double East, HorizontalCovariance Covariance)[] all =
        [
            (1, 10, new HorizontalCovariance(4, 1, 3)),
            (3, 14, new HorizontalCovariance(2, -0.5, 5)),
            (-2, 9, new HorizontalCovariance(0.5, 0.2, 1)),
        ];
        PositionFilter Of(params int[] order)
        {
            (double north, double east, HorizontalCovariance covariance) = all[order[0]];
            var filter = new PositionFilter(north, east, covariance);
            for (int i = 1; i < order.Length; i++)
                filter.Update(all[order[i]].North, all[order[i]].East, all[order[i]].Covariance);
            return filter;
        }

        PositionFilter a = Of(0, 1, 2);
        foreach (PositionFilter b in new[] { Of(2, 1, 0), Of(1, 0, 2) })
        {
            Assert.Equal(a.North, b.North, 1e-12);
            Assert.Equal(a.East, b.East, 1e-12);
            Assert.Equal(a.Covariance.NorthNorth, b.Covariance.NorthNorth, 1e-12);
            Assert.Equal(a.Covariance.NorthEast, b.Covariance.NorthEast, 1e-12);
            Assert.Equal(a.Covariance.EastEast, b.Covariance.EastEast, 1e-12);
        }
    }

    [Fact]
    public void Covariance_SeededTargets_IsAsSureAsItShouldBe()
    {
        const int Runs = 2000;
        const int Seed = 7;
        output.WriteLine($"seed {Seed}");
        var random = new SeededNumbers(Seed);
        double sum = 0;
        for (int run = 0; run < Runs; run++)
        {
            PositionFilter filter = default;
            for (int i = 0; i < 20; i++)
            {
                // Two independent errors along axes that are turned by some angle give one that is correlated.
                (double along, double across, double angle) =
                    (random.Uniform(0.5, 3), random.Uniform(0.5, 3), random.Uniform(0, System.Math.PI));
                (double a, double b) = (along * random.Gauss(), across * random.Gauss());
                (double sin, double cos) = (System.Math.Sin(angle), System.Math.Cos(angle));
                var r = new HorizontalCovariance(
                    (along * along * cos * cos) + (across * across * sin * sin),
                    ((along * along) - (across * across)) * sin * cos,
                    (along * along * sin * sin) + (across * across * cos * cos));
                (double north, double east) = ((a * cos) - (b * sin), (a * sin) + (b * cos));
                if (i == 0)
                    filter = new PositionFilter(north, east, r);
                else
                    filter.Update(north, east, r);
            }

            sum += filter.Covariance.MahalanobisSquared(filter.North, filter.East);
        }

        // Chi-square with 4000 degrees of freedom over 2000: 2 with a standard deviation of 0.045.
        output.WriteLine($"mean NEES {sum / Runs:0.000}");
        Assert.InRange(sum / Runs, 1.87, 2.13);
    }
}
