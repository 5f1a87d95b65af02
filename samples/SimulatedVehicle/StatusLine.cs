using System;
using System.Globalization;
using System.IO;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Simulation;

namespace SimulatedVehicle;

/// <summary>A plain line when the mode, arming or being in the air changes.</summary>
internal sealed class StatusLine(TextWriter output)
{
    private string? _last;

    public void Show(TimeSpan time, SimulatedTruth truth)
    {
        string state = $"{truth.Mode}, {(truth.IsArmed ? "ARMED" : "disarmed")}, "
            + $"{(truth.IsAirborne ? "in the air" : "on the ground")}";
        if (state == _last)
            return;
        _last = state;
        output.WriteLine(string.Format(
            CultureInfo.InvariantCulture,
            "{0,10:0.000}  {1}; north {2:0.0} east {3:0.0} height {4:0.0} m, battery {5:0} %",
            time.TotalSeconds,
            state,
            truth.Pose.Position.North,
            truth.Pose.Position.East,
            Math.Max(0, -truth.Pose.Position.Down),
            truth.BatteryRemaining * 100));
    }
}
