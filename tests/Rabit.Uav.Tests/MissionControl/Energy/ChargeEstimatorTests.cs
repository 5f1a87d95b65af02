using System;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl.Energy;

/// <summary>What is truly left, by percentage, charge drawn and voltage, as far as these are reported.</summary>
public class ChargeEstimatorTests
{
    private readonly ChargeEstimator _estimator = new(new EnergyOptions { Cells = 4 });

    [Fact]
    public void Update_NothingReported_IsNotKnown()
    {
        Assert.False(_estimator.Update(new VehicleState { BatteryRemaining = 0.9 }));
        Assert.False(_estimator.IsKnown);
        Assert.True(double.IsNaN(_estimator.Left));
    }

    [Fact]
    public void Update_NeitherPercentNorCurrent_IsNotKnown()
    {
        new Battery { Reports = Reported.Volts }.Discharge(_estimator, to: 0.9);
        Assert.False(_estimator.IsKnown);
    }

    [Fact]
    public void Update_SameReportTwice_IsTakenOnce()
    {
        VehicleState state = new Battery().Report();
        Assert.True(_estimator.Update(state));
        Assert.False(_estimator.Update(state));
    }

    [Theory]
    [InlineData(1.0, 0)]
    [InlineData(0.9, 0)]
    [InlineData(0.8, 0)]
    [InlineData(1.0, 0.01)]
    [InlineData(0.8, 0.01)]
    [InlineData(0.8, -0.01)]
    public void CapacityFraction_DischargedToAThird_IsFoundOutAndItsDeviationShrinks(double capacity, double offset)
    {
        var battery = new Battery { CapacityFraction = capacity, CurveOffsetVolts = offset };
        battery.Discharge(_estimator, to: 0.95);
        double before = _estimator.CapacityFractionDeviation;
        battery.Discharge(_estimator, to: 0.33);

        double deviation = _estimator.CapacityFractionDeviation;
        Assert.InRange(deviation, 0.02, before / 1.5);
        double allowed = offset.Equals(0d) ? 0.05 : 2 * deviation;
        Assert.InRange(_estimator.CapacityFraction, capacity - allowed, capacity + allowed);
        Assert.InRange(_estimator.LeftDeviation, 0.01, 0.06);
        Assert.InRange(
            _estimator.Left, battery.Charge - (2 * _estimator.LeftDeviation),
            battery.Charge + (2 * _estimator.LeftDeviation));
    }

    [Theory]
    [InlineData(Reported.All)]
    [InlineData(Reported.Percent)]
    [InlineData(Reported.Percent | Reported.Volts)]
    [InlineData(Reported.Amperes | Reported.Volts)]
    [InlineData(Reported.Percent | Reported.Amperes | Reported.Volts)]
    public void Left_WhateverIsReported_FollowsTheTruth(Reported reports)
    {
        var battery = new Battery { CapacityFraction = 0.9, Reports = reports };
        while (battery.Charge > 0.3)
        {
            battery.Discharge(_estimator, to: battery.Charge - 0.05);
            double allowed = Math.Max(0.05, 2.5 * _estimator.LeftDeviation);
            Assert.True(
                _estimator.IsKnown && Math.Abs(_estimator.Left - battery.Charge) <= allowed,
                $"{_estimator.Left} +- {_estimator.LeftDeviation}, truly {battery.Charge}");
        }
    }

    [Fact]
    public void Left_ThatOfAnAgedBattery_IsLessThanTheAutopilotReports()
    {
        var battery = new Battery { CapacityFraction = 0.8 };
        battery.Discharge(_estimator, to: 0.4);
        Assert.True(_estimator.Left < battery.Report().BatteryRemaining - 0.07, $"{_estimator.Left}");
    }

    [Fact]
    public void Left_PercentIsZero_IsZero()
    {
        var battery = new Battery { Reports = Reported.Percent };
        battery.Discharge(_estimator, to: 0);
        Assert.Equal(0, _estimator.Left);
        Assert.True(_estimator.IsKnown);
    }

    [Fact]
    public void Left_TakenForFullWithHalfTheVoltage_BeginsByTheVoltage()
    {
        var battery = new Battery { Charge = 0.5, PercentOffset = 0.5 };
        battery.Discharge(_estimator, to: 0.48);
        Assert.InRange(_estimator.Left, 0.38, 0.6);
    }

    // A single wrong report: the next is as the one before.
    [Theory]
    [InlineData(0.02)]
    [InlineData(1)]
    public void Left_PercentJumpsInOneReport_IsAsItWas(double wrong)
    {
        var battery = new Battery();
        battery.Discharge(_estimator, to: 0.6);
        double before = _estimator.Left;
        _estimator.Update(battery.Report() with { BatteryRemaining = wrong });
        Assert.Equal(before, _estimator.Left, 2);
        battery.Discharge(_estimator, to: 0.55);
        Assert.InRange(_estimator.Left, battery.Charge - 0.06, battery.Charge + 0.06);
    }

    [Fact]
    public void Left_PercentFallsAndStays_Follows()
    {
        var battery = new Battery();
        battery.Discharge(_estimator, to: 0.8);
        battery.PercentOffset = -0.5;
        battery.Discharge(_estimator, to: 0.79);
        Assert.InRange(_estimator.Left, 0.25, 0.31);
    }

    // The autopilot started again and takes its battery for full.
    [Fact]
    public void Left_PercentRisesAndStays_DoesNotRise()
    {
        var battery = new Battery();
        battery.Discharge(_estimator, to: 0.5);
        battery.PercentOffset = 0.4;
        battery.Discharge(_estimator, to: 0.45);
        Assert.InRange(_estimator.Left, 0.37, 0.52);
    }

    // Percent without current: where that is missing too for a while, the estimate is not known, and not lost.
    [Fact]
    public void Left_PercentMissesForAWhile_IsNotKnownMeanwhile()
    {
        var battery = new Battery { Reports = Reported.Percent };
        battery.Discharge(_estimator, to: 0.8);
        battery.Reports = Reported.None;
        battery.Discharge(_estimator, to: 0.7);
        Assert.False(_estimator.IsKnown);
        battery.Reports = Reported.Percent;
        battery.Discharge(_estimator, to: 0.69);
        Assert.True(_estimator.IsKnown);
        battery.Discharge(_estimator, to: 0.4);
        Assert.InRange(_estimator.Left, 0.3, 0.45);
    }

    [Fact]
    public void Left_CurrentIsLostOnTheWay_GoesOnByPercent()
    {
        var battery = new Battery { Reports = Reported.Percent | Reported.Amperes | Reported.Volts };
        battery.Discharge(_estimator, to: 0.7);
        battery.Reports = Reported.Percent | Reported.Volts;
        battery.Discharge(_estimator, to: 0.4);
        Assert.True(_estimator.IsKnown);
        Assert.InRange(_estimator.Left, 0.32, 0.46);
    }

    [Fact]
    public void Left_ACellFails_IsThatOfTheVoltage()
    {
        var battery = new Battery();
        battery.Discharge(_estimator, to: 0.8);
        battery.LostVolts = 0.45;
        battery.Discharge(_estimator, to: 0.75);
        Assert.InRange(_estimator.Left, 0, 0.3);
    }

    [Fact]
    public void FractionOf_AnEnergy_IsMoreOfAnAgedBattery()
    {
        var aged = new ChargeEstimator(new EnergyOptions { Cells = 4 });
        new Battery { CapacityFraction = 0.8 }.Discharge(aged, to: 0.3);
        new Battery().Discharge(_estimator, to: 0.3);
        Assert.InRange(aged.FractionOf(50_000, 190) / _estimator.FractionOf(50_000, 190), 1.12, 1.35);
        Assert.Equal(0, _estimator.FractionOf(0, 190));
        Assert.Equal(double.PositiveInfinity, _estimator.FractionOf(double.PositiveInfinity, 190));
    }
}
