using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl.Energy;

/// <summary>The energy of a mission with what an autopilot may report, or not.</summary>
public sealed class EnergyModelTests : IDisposable
{
    private readonly MissionRig _rig = new(MissionRig.Mission());
    private double _battery = 0.9;

    public EnergyModelTests()
    {
        _rig.Vehicle.More = ReportPercentOnly;
        _rig.RunUntil(MissionPhase.Searching, 90);
    }

    public void Dispose() => _rig.Dispose();

    [Fact]
    public void Energy_PercentOnly_IsKnownAndThePowerIsLearnt()
    {
        Discharge(seconds: 60);
        EnergyStatus energy = _rig.Status.Energy;
        Assert.True(energy.IsKnown && !energy.MustReturn);
        Assert.InRange(energy.HoverWatts, 191, 600);
    }

    // 90 % to 30 % within a second would be 250 kW.
    [Fact]
    public void Energy_PercentJumpsInOneReport_PowerAndReturnAreAsBefore()
    {
        Discharge(seconds: 20);
        double watts = _rig.Status.Energy.HoverWatts;
        double battery = _battery;
        _battery = 0.3;
        _rig.Run(0.2);
        _battery = battery;
        _rig.Run(2);
        EnergyStatus energy = _rig.Status.Energy;
        Assert.True(energy.IsKnown && !energy.MustReturn);
        Assert.InRange(energy.HoverWatts, 0.9 * watts, 1.1 * watts);

        Discharge(seconds: 60);
        Assert.True(_rig.Status.Energy.HoverWatts > 1.02 * watts, "nothing is learnt any more");
    }

    [Fact]
    public void Energy_PercentMissesForAWhile_IsNotKnownMeanwhile()
    {
        Discharge(seconds: 5);
        double battery = _battery;
        _battery = double.NaN;
        _rig.Run(5);
        Assert.False(_rig.Status.Energy.IsKnown);
        _battery = battery;
        _rig.Run(2);
        Assert.True(_rig.Status.Energy.IsKnown);
        double watts = _rig.Status.Energy.HoverWatts;
        Discharge(seconds: 60);
        Assert.NotEqual(watts, _rig.Status.Energy.HoverWatts);
    }

    [Fact]
    public void Energy_WindIsNoNumber_IsAssumed()
    {
        _rig.Vehicle.More = (ref VehicleState s) =>
        {
            ReportPercentOnly(ref s);
            (s.WindTime, s.WindVelocityNed) = (s.BatteryTime, new NedVector(double.NaN, double.NaN, 0));
        };
        _rig.Run(5);
        EnergyStatus energy = _rig.Status.Energy;
        Assert.True(energy.IsKnown && !energy.IsWindMeasured && !energy.MustReturn);
        Assert.InRange(energy.ChargeHome, 0.001, 0.3);
    }

    // 1 % in 4 s: some 1000 W.
    private void Discharge(int seconds)
    {
        for (int i = 0; i < seconds; i++)
        {
            _battery -= 0.0025;
            _rig.Run(1);
        }
    }

    private void ReportPercentOnly(ref VehicleState state)
    {
        state.BatteryRemaining = Math.Round(_battery, 2);
        (state.BatteryVolts, state.BatteryAmperes, state.BatteryConsumedAmpereHours)
            = (double.NaN, double.NaN, double.NaN);
    }
}
