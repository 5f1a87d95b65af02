using System;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl.Energy;

/// <summary>Power is learnt from what hover, cruise and climb take.</summary>
public class PowerModelTests
{
    private readonly PowerModel _model = new(new EnergyOptions());

    [Fact]
    public void Watts_BeforeAnythingWasMeasured_IsThePrior()
    {
        Assert.Equal(190, _model.Watts(0), 9);
        Assert.Equal(190 + (0.05 * 1000), _model.Watts(10), 9);
        Assert.Equal(190 + (20 * 2), _model.Watts(0, 2), 9);
    }

    [Fact]
    public void Watts_Descent_IsNoGain() => Assert.Equal(_model.Watts(5), _model.Watts(5, -3), 9);

    [Theory]
    [InlineData(120)]
    [InlineData(280)]
    [InlineData(1500)]
    public void Update_Hover_IsLearntAndTheDeviationShrinks(double hover)
    {
        double before = _model.Deviation(0);
        for (int i = 0; i < 300; i++)
            _model.Update(hover, cubedAirspeed: 0, climbRate: 0, seconds: 1);
        Assert.InRange(_model.HoverWatts, 0.97 * hover, 1.03 * hover);
        Assert.True(_model.Deviation(0) < before / 3, $"{_model.Deviation(0)} after {before}");
    }

    [Fact]
    public void Update_HoverOnly_LeavesWhatIsNotFlownAsUncertainAsItWas()
    {
        double before = Math.Sqrt(Square(_model.Deviation(12)) - Square(_model.Deviation(0)));
        for (int i = 0; i < 300; i++)
            _model.Update(240, cubedAirspeed: 0, climbRate: 0, seconds: 1);
        Assert.True(_model.Deviation(12) >= before, $"{_model.Deviation(12)} after {before}");
        Assert.Equal(20, _model.ClimbWattsPerMetrePerSecond, 6);
    }

    [Fact]
    public void Update_CruiseAndClimbs_AreLearntWithNoise()
    {
        const long Seed = 7;
        var random = new Random((int)Seed);
        for (int i = 0; i < 900; i++)
        {
            (double airspeed, double climb) = (i / 60 % 3) switch
            {
                0 => (0.0, 0.0),
                1 => (12.0, 0.0),
                _ => (0.0, 2.0),
            };
            double watts = Truth(airspeed, climb) * (1 + (0.1 * ((2 * random.NextDouble()) - 1)));
            _model.Update(watts, airspeed * airspeed * airspeed, climb, seconds: 1);
        }

        foreach ((double airspeed, double climb) in new[] { (0.0, 0.0), (8.0, 0.0), (12.0, 0.0), (0.0, 2.0) })
        {
            double truth = Truth(airspeed, climb);
            Assert.InRange(_model.Watts(airspeed, climb), 0.93 * truth, 1.07 * truth);
        }

        static double Truth(double airspeed, double climb)
            => 230 + (0.09 * airspeed * airspeed * airspeed) + (33 * climb);
    }

    [Theory]
    [InlineData(double.NaN, 0, 0, 1)]
    [InlineData(double.PositiveInfinity, 0, 0, 1)]
    [InlineData(200, double.NaN, 0, 1)]
    [InlineData(200, 0, double.NaN, 1)]
    [InlineData(200, double.PositiveInfinity, 0, 1)]
    [InlineData(200, 0, 0, double.NaN)]
    public void Update_NoNumber_ChangesNothing(double watts, double cubedAirspeed, double climbRate, double seconds)
    {
        _model.Update(watts, cubedAirspeed, climbRate, seconds);
        Assert.Equal((190, 20), (_model.HoverWatts, _model.ClimbWattsPerMetrePerSecond));
        Assert.Equal(0.25 * 190, _model.Deviation(0), 9);
    }

    [Fact]
    public void Update_NoPowerAtAll_NothingFliesOnLessThanATenth()
    {
        for (int i = 0; i < 5000; i++)
            _model.Update(0, cubedAirspeed: 0, climbRate: i % 5, seconds: 1);
        Assert.Equal(19, _model.HoverWatts, 9);
        Assert.True(_model.ClimbWattsPerMetrePerSecond >= 0);
    }

    [Fact]
    public void Update_HoursOfFlight_DeviationStaysANumberAboveZero()
    {
        var random = new Random(3);
        for (int i = 0; i < 20_000; i++)
        {
            double speed = 15 * random.NextDouble();
            _model.Update(150 + (100 * random.NextDouble()), speed * speed * speed, random.Next(-2, 3), seconds: 1);
            double deviation = _model.Deviation(speed);
            Assert.True(deviation > 0 && deviation < 1000, $"{deviation} after {i} s");
        }
    }

    private static double Square(double value) => value * value;
}
