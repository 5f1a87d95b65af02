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

    public void Apply(TimeSpan time, SimulatedVehicle vehicle)
    {
        for (; _next < faults.Count && faults[_next].At <= time; _next++)
            Begin(faults[_next], vehicle);
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
            case ScriptedFaultKind.WindTo:
                if (fault.Duration > TimeSpan.Zero)
                    _windReturns.Add((fault.At + fault.Duration, vehicle.Air.MeanSpeed));
                vehicle.Air.MeanSpeed = fault.Value;
                break;
            case ScriptedFaultKind.PilotMode:
                vehicle.Controller.TrySetMode((uint)fault.Value);
                break;
        }
    }
}
