using System;
using System.Collections.Generic;

namespace Rabit.Uav.Simulation;

/// <summary>Makes go wrong what the script says, when it says so. The faults are in the order of their times.</summary>
internal sealed class FaultScript(IReadOnlyList<ScriptedFault> faults)
{
    private readonly List<(TimeSpan At, double Wind)> _windReturns = [];
    private int _next;

    public bool IsOn(ScriptedFaultKind kind, TimeSpan time)
    {
        for (int index = 0; index < faults.Count; index++)
        {
            if (faults[index].Kind == kind && faults[index].IsOn(time))
                return true;
        }

        return false;
    }

    /// <summary>The value of the fault of a kind that is on and began last; null where none is on.</summary>
    public double? ValueOf(ScriptedFaultKind kind, TimeSpan time)
    {
        double? value = null;
        for (int index = 0; index < faults.Count; index++)
        {
            if (faults[index].Kind == kind && faults[index].IsOn(time))
                value = faults[index].Value;
        }

        return value;
    }

    /// <summary>By how much gusts raise the wind, m/s: each as the square of a sine over its duration.</summary>
    private double GustAt(TimeSpan time)
    {
        double gust = 0;
        for (int index = 0; index < faults.Count; index++)
        {
            if (faults[index].Kind != ScriptedFaultKind.Gust || !faults[index].IsOn(time))
                continue;
            double sine = Trig.Sin(
                Math.PI * (time - faults[index].At).ExactSeconds / faults[index].Duration.ExactSeconds);
            gust += faults[index].Value * sine * sine;
        }

        return gust;
    }

    public void Apply(TimeSpan time, SimulatedVehicle vehicle)
    {
        for (; _next < faults.Count && faults[_next].At <= time; _next++)
            Begin(faults[_next], vehicle);
        vehicle.Air.Gust = GustAt(time);
        vehicle.Pack.SensorVolts = ValueOf(ScriptedFaultKind.BatteryVolts, time);
        vehicle.Radio.IsReceived = !IsOn(ScriptedFaultKind.RcLost, time);
        for (int index = _windReturns.Count - 1; index >= 0; index--)
        {
            if (_windReturns[index].At > time)
                continue;
            vehicle.Air.MeanSpeed = _windReturns[index].Wind;
            _windReturns.RemoveAt(index);
        }
    }

    private void Begin(in ScriptedFault fault, SimulatedVehicle vehicle)
    {
        switch (fault.Kind)
        {
            case ScriptedFaultKind.BatteryTo:
                vehicle.Pack.Set(fault.Value);
                break;
            case ScriptedFaultKind.BatteryTrueTo:
                vehicle.Pack.SetTrue(fault.Value);
                break;
            case ScriptedFaultKind.WindTo:
                if (fault.Duration > TimeSpan.Zero)
                    _windReturns.Add((fault.At + fault.Duration, vehicle.Air.MeanSpeed));
                vehicle.Air.MeanSpeed = fault.Value;
                break;
            case ScriptedFaultKind.PilotMode:
                if (fault.BySwitch)
                    vehicle.Radio.SwitchTo((uint)fault.Value);
                else
                    vehicle.Autopilot.TrySetMode((uint)fault.Value);
                break;
            case ScriptedFaultKind.Reboot:
                vehicle.Reboot(staysArmed: fault.Value.Equals(0d));
                break;
        }
    }
}
