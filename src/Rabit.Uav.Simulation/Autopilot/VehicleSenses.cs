using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// What the autopilot steers by at a step. The errors that are slow are in it, so that it really flies by its
/// estimated position. A plain value.
/// </summary>
internal struct VehicleSenses
{
    /// <summary>By the clock of the run.</summary>
    public TimeSpan Time;

    /// <summary>Metres in the world.</summary>
    public NedVector Position;

    /// <summary>m/s over ground.</summary>
    public NedVector Velocity;

    /// <summary>Radians clockwise from north.</summary>
    public double Yaw;

    /// <summary>What the weight on the legs says.</summary>
    public bool TouchesGround;

    /// <summary>Whether the GPS has a fix.</summary>
    public bool HasGps;

    /// <summary>Whether what the GPS says jumps away from where the vehicle is.</summary>
    public bool IsGpsGlitching;

    /// <summary>Whether the estimator's variances are too large, whatever the reason.</summary>
    public bool IsEstimatorBad;

    /// <summary>Whether the remote control is received.</summary>
    public bool IsRadioReceived;

    /// <summary>The flight mode at the pilot's mode switch; null until it has been used.</summary>
    public uint? ModeOfSwitch;

    /// <summary>How often the switch was moved.</summary>
    public int SwitchCount;

    /// <summary>As measured.</summary>
    public double BatteryVolts;

    /// <summary>0 to 1.</summary>
    public double BatteryRemaining;

    /// <summary>Charge drawn since the start.</summary>
    public double ConsumedAmpereHours;
}
