using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl.Energy;

/// <summary>Time and energy of the way home, to the limits of physics.</summary>
public class WayHomeTests
{
    private static readonly PowerModel Power = new(new EnergyOptions());

    [Theory]
    [InlineData(10, 15, 0, 0, 10)]
    [InlineData(10, 15, -4, 0, 10)]
    [InlineData(10, 15, -8, 0, 7)]
    [InlineData(10, 15, 8, 0, 10)]
    [InlineData(20, 15, 8, 0, 15)]
    [InlineData(20, 15, 0, 9, 12)]
    [InlineData(10, 15, -13.9, 0, 1.1)]
    [InlineData(10, 15, -14.5, 0, 0)]
    [InlineData(10, 15, -15, 0, 0)]
    [InlineData(10, 15, -30, 0, 0)]
    [InlineData(10, 15, 0, 15, 0)]
    [InlineData(10, 15, 10, 16, 0)]
    [InlineData(10, 0, 0, 0, 0)]
    [InlineData(10, 15, double.NaN, 0, 0)]
    [InlineData(10, 15, 0, double.NaN, 0)]
    [InlineData(10, double.NaN, 0, 0, 0)]
    public void GroundSpeed_ByWind_IsThatOfPx4AndZeroWhereItIsTooStrong(
        double commanded, double maxAirspeed, double along, double cross, double expected)
        => Assert.Equal(expected, WayHome.GroundSpeed(commanded, maxAirspeed, along, cross), 9);

    [Theory]
    [InlineData(15)]
    [InlineData(20)]
    [InlineData(double.NaN)]
    public void Of_HeadWindOfTheAirspeedOrMore_IsInfinite(double wind)
    {
        // North of home, and the wind blows north.
        (double joules, double seconds) = Of(new PlanePoint(500, 0), new PlanePoint(wind, 0));
        Assert.Equal((double.PositiveInfinity, double.PositiveInfinity), (joules, seconds));
    }

    [Fact]
    public void Of_UnknownPlace_IsInfinite()
        => Assert.Equal(
            double.PositiveInfinity, Of(new PlanePoint(double.NaN, 0), default).Joules);

    [Fact]
    public void Of_StrongWindAtHome_IsTheLandingAlone()
    {
        (double joules, double seconds) = Of(default, new PlanePoint(20, 0));
        Assert.Equal(WayHome.Landing(Power, 40, 20), (joules, seconds));
    }

    [Fact]
    public void Of_WithoutWind_IsTheWayAndTheLanding()
    {
        (double joules, double seconds) = Of(new PlanePoint(300, 400), default);
        (double landing, double landingSeconds) = WayHome.Landing(Power, 40, 0);
        Assert.Equal(500 / 10.0, seconds - landingSeconds, 9);
        Assert.Equal(50 * Power.Watts(10), joules - landing, 6);
    }

    [Fact]
    public void Of_WindOnTheWay_CostsMoreTheMoreItIsAgainstAndATailWindGivesNothing()
    {
        var place = new PlanePoint(1000, 0);
        double last = Of(place, default).Joules;
        for (double wind = 1; wind < 13; wind++)
        {
            double joules = Of(place, new PlanePoint(wind, 0)).Joules;
            Assert.True(joules > last, $"{wind} m/s: {joules} J after {last} J");
            last = joules;
        }

        Assert.True(Of(place, new PlanePoint(-8, 0)).Joules >= Of(place, default).Joules);
        Assert.True(Of(place, default, more: 3).Joules > Of(place, default).Joules);
    }

    [Theory]
    [InlineData(-5, 15)]
    [InlineData(0, 15)]
    [InlineData(6, 27)]
    [InlineData(12, 39)]
    [InlineData(42, 59)]
    public void Landing_ByHeight_TakesItsTime(double height, double seconds)
        => Assert.Equal(seconds, WayHome.Landing(Power, height, 0).Seconds, 9);

    private static (double Joules, double Seconds) Of(PlanePoint place, PlanePoint wind, double more = 0)
        => WayHome.Of(
            Power, place, height: 40, wind, more, speed: 10, maxAirspeed: 15, startSeconds: 0);
}
