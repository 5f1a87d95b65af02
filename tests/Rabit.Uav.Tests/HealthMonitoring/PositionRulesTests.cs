using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.HealthMonitoring;

/// <summary>The rules for the position: each with its dwell, what it advises, and what ends it.</summary>
public class PositionRulesTests
{
    private static readonly HealthReport Good = new() { Level = HealthLevel.Good };

    [Fact]
    public void Flight_SourcesAgree_IsGoodThroughTurnsAndStops()
    {
        using var vehicle = new FlownVehicle();
        foreach (double speed in new[] { 6, -6, 0, 15, -0.2, 0 })
        {
            vehicle.Speed = speed;
            vehicle.Fly(20);
            Assert.Equal((HealthReasons.None, HealthAdvice.None), (vehicle.Report.Reasons, vehicle.Report.Advice));
        }
    }

    [Fact]
    public void Fix_LostInGpsRawIntOnly_HoldsContinuesAndReturnsWhenItLasts()
    {
        using var vehicle = new FlownVehicle();
        vehicle.Fly(5);
        vehicle.Fly(1.5, NoFix);
        AssertReport(Good, vehicle);
        vehicle.Fly(2, NoFix);
        Assert.Equal(
            (HealthReasons.PositionFixPoor, HealthAdvice.Hold, "no satellite fix (NoFix)"),
            (vehicle.Report.Reasons, vehicle.Report.Advice, vehicle.Report.AdviceText));
        vehicle.Fly(2.5);
        Assert.Equal(HealthAdvice.Hold, vehicle.Report.Advice);
        vehicle.Fly(2);
        AssertReport(Good, vehicle);

        vehicle.Fly(31, NoFix);
        Assert.Equal(
            (HealthLevel.Critical, HealthAdvice.ReturnToLaunch), (vehicle.Report.Level, vehicle.Report.Advice));
    }

    [Fact]
    public void Fix_ReceiverReportsNothing_IsNoFix()
    {
        using var vehicle = new FlownVehicle();
        vehicle.Fly(5);
        TimeSpan last = vehicle.Rig.Reactor.Now;
        vehicle.Fly(8, (ref VehicleState s, ref NavigationStatus _) => s.GpsTime = last);
        Assert.Equal(
            (HealthReasons.PositionFixPoor, HealthAdvice.Hold), (vehicle.Report.Reasons, vehicle.Report.Advice));
    }

    [Theory]
    [InlineData(5, 0.9, "few satellites (5)")]
    [InlineData(12, 3.1, "poor satellite geometry (HDOP 3.1)")]
    public void Fix_FewSatellitesOrPoorGeometry_IsReportedWithoutAdvice(int satellites, double hdop, string text)
    {
        using var vehicle = new FlownVehicle();
        void Poor(ref VehicleState s, ref NavigationStatus n)
            => (s.Satellites, n.HorizontalDilution) = (satellites, hdop);

        vehicle.Fly(4.5, Poor);
        AssertReport(Good, vehicle);
        vehicle.Fly(2, Poor);
        Assert.Equal(
            (HealthReasons.PositionFixPoor, HealthAdvice.None, text),
            (vehicle.Report.Reasons, vehicle.Report.Advice, vehicle.Report.Text));

        // Just at the limit it does not come and go.
        vehicle.Fly(10, (ref VehicleState s, ref NavigationStatus n)
            => (s.Satellites, n.HorizontalDilution) = (satellites == 5 ? 6 : 12, hdop > 1 ? 2.4 : 0.9));
        Assert.Equal(HealthReasons.PositionFixPoor, vehicle.Report.Reasons);
        vehicle.Fly(7);
        AssertReport(Good, vehicle);
    }

    [Fact]
    public void Position_NoneThatIsOne_IsReportedWithinTwoSecondsAndAHalf()
    {
        using var vehicle = new FlownVehicle();
        vehicle.Fly(5);
        TimeSpan last = vehicle.Rig.Reactor.Now;
        vehicle.Fly(2.75, (ref VehicleState s, ref NavigationStatus _) => s.PositionTime = last);
        Assert.Equal(
            (HealthReasons.PositionInvalid, HealthLevel.Critical, "the autopilot reports no valid position"),
            (vehicle.Report.Reasons, vehicle.Report.Level, vehicle.Report.Text));
    }

    [Theory]
    [InlineData(6, 3)]
    [InlineData(3, 6)]
    public void Position_FrozenWhileTheVelocityIsNot_HoldsAndLandsWhenItLasts(double speed, double within)
    {
        using var vehicle = new FlownVehicle { Speed = speed };
        vehicle.Fly(10);
        void Freeze(ref VehicleState s, ref NavigationStatus _) => s.Position = FlownVehicle.PlaceOf(speed * 10);
        vehicle.Fly(within, Freeze);
        Assert.Equal(
            (HealthReasons.PositionInvalid, HealthAdvice.Hold,
                "the position stands still while the velocity does not"),
            (vehicle.Report.Reasons, vehicle.Report.Advice, vehicle.Report.AdviceText));

        // The vehicle holds: a position that stands still is no longer contradicted, and not to be trusted either.
        vehicle.Speed = 0;
        vehicle.Fly(10, Freeze);
        Assert.Equal(HealthAdvice.Hold, vehicle.Report.Advice);
        vehicle.Fly(6, Freeze);
        Assert.Equal(HealthAdvice.Land, vehicle.Report.Advice);
    }

    [Fact]
    public void Position_FrozenForAWhile_ContinuesOnceItIsRightAgain()
    {
        using var vehicle = new FlownVehicle();
        vehicle.Fly(10);
        vehicle.Fly(3, (ref VehicleState s, ref NavigationStatus _) => s.Position = FlownVehicle.PlaceOf(60));
        Assert.Equal(HealthAdvice.Hold, vehicle.Report.Advice);
        vehicle.Speed = 0;
        vehicle.Fly(12);
        AssertReport(Good, vehicle);
    }

    [Fact]
    public void Position_Jumps_HoldsForSomeSeconds()
    {
        using var vehicle = new FlownVehicle();
        vehicle.Fly(10);
        double jump = 40;
        void Jump(ref VehicleState s, ref NavigationStatus _)
            => s.Position = Geodesy.LocalNedFrame.IgnoringGeoid(s.Position)
                .ToGeodetic(new Geodesy.NedPosition(jump, 0, 0));
        vehicle.Fly(1.5, Jump);
        Assert.Equal(
            (HealthReasons.PositionInvalid, HealthAdvice.Hold, "the position jumped by 40 m"),
            (vehicle.Report.Reasons, vehicle.Report.Advice, vehicle.Report.AdviceText));
        vehicle.Fly(9, Jump);
        AssertReport(Good, vehicle);
    }

    [Fact]
    public void Position_SingleWrongSample_ChangesNothing()
    {
        using var vehicle = new FlownVehicle();
        vehicle.Fly(10);
        vehicle.Fly(0.25, (ref VehicleState s, ref NavigationStatus _) => s.Position = FlownVehicle.PlaceOf(500));
        Assert.Equal(HealthAdvice.None, vehicle.Report.Advice);
        vehicle.Fly(5);
        AssertReport(Good, vehicle);
    }

    [Fact]
    public void Estimator_RatioTooLarge_HoldsContinuesAndReturnsWhenItLasts()
    {
        using var vehicle = new FlownVehicle();
        static void Contradict(ref VehicleState s, ref NavigationStatus n) => n.EstimatorRatio = 1.1;
        vehicle.Fly(0.75, Contradict);
        AssertReport(Good, vehicle);
        vehicle.Fly(1, Contradict);
        Assert.Equal(
            (HealthReasons.EstimatorUnhealthy, HealthAdvice.Hold,
                "the autopilot's estimator contradicts its sensors"),
            (vehicle.Report.Reasons, vehicle.Report.Advice, vehicle.Report.AdviceText));
        vehicle.Fly(10, (ref VehicleState _, ref NavigationStatus n) => n.EstimatorRatio = 0.7);
        Assert.Equal(HealthAdvice.Hold, vehicle.Report.Advice);
        vehicle.Fly(4);
        AssertReport(Good, vehicle);
        vehicle.Fly(31, Contradict);
        Assert.Equal(HealthAdvice.ReturnToLaunch, vehicle.Report.Advice);
    }

    [Fact]
    public void Estimator_NoPosition_HoldsAndLands()
    {
        using var vehicle = new FlownVehicle();
        static void Lose(ref VehicleState s, ref NavigationStatus n)
            => (n.EstimatorFault, s.EstimatorTime, s.EstimatorFlags)
                = ("no horizontal position", n.EstimatorTime, EstimatorStatusFlags.Attitude);
        vehicle.Fly(2, Lose);
        Assert.Equal(
            (HealthAdvice.Hold, "the autopilot's estimator has no position"),
            (vehicle.Report.Advice, vehicle.Report.AdviceText));
        vehicle.Fly(14, Lose);
        Assert.Equal(HealthAdvice.Land, vehicle.Report.Advice);
    }

    [Theory]
    [InlineData(16, HealthReasons.HeightInconsistent)]
    [InlineData(-16, HealthReasons.HeightInconsistent)]
    [InlineData(13, HealthReasons.None)]
    public void Height_OffThatOfTheAirPressure_ReturnsToLaunch(double off, HealthReasons expected)
    {
        using var vehicle = new FlownVehicle();
        vehicle.Fly(2);
        vehicle.Fly(6, (ref VehicleState _, ref NavigationStatus n) => n.PressureHeightMetres += off);
        Assert.Equal(expected, vehicle.Report.Reasons);
        Assert.Equal(
            expected == HealthReasons.None ? HealthAdvice.None : HealthAdvice.ReturnToLaunch, vehicle.Report.Advice);
    }

    [Fact]
    public void OnTheGround_NothingOfIt_IsJudged()
    {
        using var vehicle = new FlownVehicle { Speed = 0 };
        vehicle.Fly(40, static (ref VehicleState s, ref NavigationStatus n) =>
        {
            NoFix(ref s, ref n);
            (s.LandedState, s.IsArmed, s.PositionTime) = (MavLandedState.OnGround, false, null);
            (n.EstimatorFault, s.EstimatorTime, n.EstimatorRatio) = ("no attitude", n.EstimatorTime, 3);
        });
        AssertReport(Good, vehicle);
    }

    private static void NoFix(ref VehicleState state, ref NavigationStatus navigation)
    {
        (state.GpsFix, state.Satellites) = (GpsFixType.NoFix, 0);
        navigation.HorizontalDilution = double.NaN;
    }

    private static void AssertReport(HealthReport expected, FlownVehicle vehicle)
        => Assert.Equal(
            (expected.Level, expected.Reasons, expected.Advice),
            (vehicle.Report.Level, vehicle.Report.Reasons, vehicle.Report.Advice));
}
