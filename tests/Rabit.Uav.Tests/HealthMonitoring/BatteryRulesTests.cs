using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.HealthMonitoring;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.HealthMonitoring;

/// <summary>The rules for the battery: charge, voltage of a cell, and what the autopilot announces.</summary>
public class BatteryRulesTests
{
    [Fact]
    public void Charge_AtTheLimit_DoesNotComeAndGo()
    {
        using var vehicle = new FlownVehicle();
        vehicle.Fly(3, Remaining(0.25));
        vehicle.Fly(5, Remaining(0.28));
        Assert.Equal((HealthReasons.BatteryLow, "battery low (28 %)"), (vehicle.Report.Reasons, vehicle.Report.Text));
        vehicle.Fly(1, Remaining(0.29));
        vehicle.Fly(1, Remaining(0.28));
        Assert.Equal(HealthReasons.BatteryLow, vehicle.Report.Reasons);
        vehicle.Fly(3, Remaining(0.29));
        Assert.Equal(HealthReasons.None, vehicle.Report.Reasons);
    }

    [Theory]
    [InlineData(0.2)]
    [InlineData(0)]
    public void Charge_LowInOneReport_IsNoReason(double wrong)
    {
        using var vehicle = new FlownVehicle();
        for (int i = 0; i < 10; i++)
        {
            vehicle.Fly(1, Remaining(wrong));
            Assert.Equal(HealthReasons.None, vehicle.Report.Reasons);
            vehicle.Fly(1);
            Assert.Equal((HealthReasons.None, HealthAdvice.None), (vehicle.Report.Reasons, vehicle.Report.Advice));
        }
    }

    [Fact]
    public void Rules_OfTheBattery_HaveADwellEach()
    {
        Assert.All(HealthRules.OfBattery, r => Assert.NotEqual(TimeSpan.Zero, r.Dwell(new HealthOptions())));
        Assert.All(HealthRules.OfBatteryState, r => Assert.NotEqual(TimeSpan.Zero, r.Dwell(new HealthOptions())));
        Assert.All(HealthRules.OfEnergy, r => Assert.NotEqual(TimeSpan.Zero, r.Dwell(new HealthOptions())));
    }

    [Theory]
    [InlineData(3.45, HealthReasons.BatteryLow, HealthAdvice.ReturnToLaunch, "battery low (3.5 V a cell)")]
    [InlineData(3.15, HealthReasons.BatteryCritical, HealthAdvice.Land, "battery nearly empty (3.2 V a cell)")]
    public void Voltage_LowUnderLoadWithAGoodCount_IsJudgedAfterTenSeconds(
        double cell, HealthReasons reason, HealthAdvice advice, string text)
    {
        using var vehicle = new FlownVehicle();
        vehicle.Fly(5);
        void Sag(ref VehicleState s, ref NavigationStatus _) => s.BatteryVolts = 3 * cell;
        vehicle.Fly(9, Sag);
        vehicle.Fly(1);
        vehicle.Fly(9, Sag);
        Assert.Equal(HealthReasons.None, vehicle.Report.Reasons);
        vehicle.Fly(2, Sag);
        Assert.Equal(
            (reason, advice, text), (vehicle.Report.Reasons, vehicle.Report.Advice, vehicle.Report.AdviceText));
    }

    [Theory]
    [InlineData(12.6, 3)]
    [InlineData(11.1, 3)]
    [InlineData(13.05, 3)]
    [InlineData(14.8, 4)]
    [InlineData(16.8, 4)]
    [InlineData(22.2, 6)]
    [InlineData(25.2, 6)]
    [InlineData(50.4, 12)]
    public void Cells_FromTheFirstVoltage_AreFound(double volts, int cells)
    {
        BatteryFacts facts = new BatteryCellWatch().Update(
            new VehicleState { BatteryTime = TimeSpan.Zero, BatteryVolts = volts, BatteryAmperes = 0 }, TimeSpan.Zero,
            new HealthOptions());
        Assert.Equal(volts / cells, facts.CellVolts, 6);
    }

    [Fact]
    public void Cells_OfTheOptions_Count()
    {
        BatteryFacts facts = new BatteryCellWatch().Update(
            new VehicleState { BatteryTime = TimeSpan.Zero, BatteryVolts = 12, BatteryAmperes = 100, BatteryCells = 3 },
            TimeSpan.Zero, new HealthOptions { BatteryCells = 4 });

        // A drop by the load of more than 0.1 V is not trusted.
        Assert.Equal(3.1, facts.CellVolts, 6);
    }

    [Theory]
    [InlineData(MavBatteryChargeState.Low, 0u, false, HealthReasons.BatteryLow, HealthAdvice.ReturnToLaunch)]
    [InlineData(MavBatteryChargeState.Unhealthy, 0u, false, HealthReasons.BatteryLow, HealthAdvice.ReturnToLaunch)]
    [InlineData(MavBatteryChargeState.Ok, 0u, true, HealthReasons.BatteryLow, HealthAdvice.ReturnToLaunch)]
    [InlineData(MavBatteryChargeState.Ok, 4u, false, HealthReasons.BatteryLow, HealthAdvice.ReturnToLaunch)]
    [InlineData(MavBatteryChargeState.Ok, 32u, false, HealthReasons.None, HealthAdvice.None)]
    [InlineData(MavBatteryChargeState.Critical, 0u, true, HealthReasons.BatteryCritical, HealthAdvice.Land)]
    [InlineData(MavBatteryChargeState.Emergency, 0u, true, HealthReasons.BatteryCritical, HealthAdvice.Land)]
    [InlineData(MavBatteryChargeState.Failed, 0u, true, HealthReasons.BatteryCritical, HealthAdvice.Land)]
    public void Announcement_OfTheAutopilot_IsFollowedAfterASecond(
        MavBatteryChargeState state, uint faults, bool isUnhealthy, HealthReasons reason, HealthAdvice advice)
    {
        using var vehicle = new FlownVehicle();
        void Announce(ref VehicleState s, ref NavigationStatus _)
            => (s.BatteryChargeState, s.BatteryFaults, s.IsBatteryUnhealthy)
                = (state, (MavBatteryFault)faults, isUnhealthy);
        vehicle.Fly(0.75, Announce);
        Assert.Equal(HealthReasons.None, vehicle.Report.Reasons);
        vehicle.Fly(0.75, Announce);
        Assert.Equal((reason, advice), (vehicle.Report.Reasons, vehicle.Report.Advice));
    }

    [Fact]
    public void Unknown_ChargeAndVoltage_IsReportedWithoutAdvice()
    {
        using var vehicle = new FlownVehicle();
        vehicle.Fly(11, static (ref VehicleState s, ref NavigationStatus _)
            => (s.BatteryRemaining, s.BatteryVolts) = (double.NaN, double.NaN));
        Assert.Equal(
            (HealthReasons.BatteryUnknown, HealthLevel.Warning, HealthAdvice.None,
                "battery unknown: neither its charge nor its voltage is reported"),
            (vehicle.Report.Reasons, vehicle.Report.Level, vehicle.Report.Advice, vehicle.Report.Text));
    }

    [Fact]
    public void Unknown_ChargeOnly_FallsBackOnTheVoltage()
    {
        using var vehicle = new FlownVehicle();
        vehicle.Fly(11, static (ref VehicleState s, ref NavigationStatus _) => s.BatteryRemaining = double.NaN);
        Assert.Equal(
            (HealthReasons.BatteryUnknown,
                "the charge of the battery is unknown; it is judged by its voltage, 4.0 V a cell"),
            (vehicle.Report.Reasons, vehicle.Report.Text));
        vehicle.Fly(11, static (ref VehicleState s, ref NavigationStatus _)
            => (s.BatteryRemaining, s.BatteryVolts) = (double.NaN, 10.3));
        Assert.Equal(HealthAdvice.ReturnToLaunch, vehicle.Report.Advice);
    }

    [Fact]
    public void Unknown_MessagesStop_IsReportedAfterTwentySeconds()
    {
        using var vehicle = new FlownVehicle();
        vehicle.Fly(3);
        TimeSpan last = vehicle.Rig.Reactor.Now;
        vehicle.Fly(19, (ref VehicleState s, ref NavigationStatus _) => s.BatteryTime = last);
        Assert.Equal(HealthReasons.None, vehicle.Report.Reasons);
        vehicle.Fly(3, (ref VehicleState s, ref NavigationStatus _) => s.BatteryTime = last);
        Assert.Equal(HealthReasons.BatteryUnknown, vehicle.Report.Reasons);
    }

    private static FlownVehicle.Change Remaining(double remaining)
        => (ref VehicleState s, ref NavigationStatus _) => s.BatteryRemaining = remaining;
}
