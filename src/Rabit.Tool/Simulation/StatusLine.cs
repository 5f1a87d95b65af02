using System;
using System.Globalization;
using System.IO;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Simulation;

namespace Rabit.Tool.Simulation;

/// <summary>
/// A plain line when the mode, arming or being in the air changes. An output that takes no more does not end the
/// flight.
/// </summary>
internal sealed class StatusLine(TextWriter output, TextWriter errors)
{
    private string? _last;
    private bool _isClosed;

    /// <summary>Whether lines were lost, but for a reader who wanted no more.</summary>
    public bool HasFailed { get; private set; }

    public void Show(TimeSpan time, SimulatedTruth truth)
    {
        if (truth.Mode.Length == 0)
            return;   // The autopilot has not made its first step.
        string state = $"{truth.Mode}, {(truth.IsArmed ? "ARMED" : "disarmed")}, "
            + $"{(truth.IsAirborne ? "in the air" : "on the ground")}";
        if (state == _last)
            return;
        _last = state;
        Write(string.Format(
            CultureInfo.InvariantCulture,
            "{0,10:0.000}  {1}; north {2:0.0} east {3:0.0} height {4:0.0} m, battery {5:0} %",
            time.TotalSeconds,
            state,
            truth.Pose.Position.North,
            truth.Pose.Position.East,
            Math.Max(0, -truth.Pose.Position.Down),
            truth.BatteryRemaining * 100));
    }

    public void Write(string text)
    {
        if (_isClosed)
            return;
        try
        {
            output.WriteLine(text);
        }
        catch (OutputException e)
        {
            _isClosed = true;
            if (e.IsReaderGone)
                return;
            HasFailed = true;
            errors.WriteLine($"rabit simulate: {e.Message}; the vehicle flies on without its lines.");
        }
    }
}
