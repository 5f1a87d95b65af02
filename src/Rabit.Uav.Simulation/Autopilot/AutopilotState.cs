using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The autopilot's estimate at a step, as it reports it: with the errors of its sensors. A plain value.
/// </summary>
internal struct AutopilotState
{
    /// <summary>By the clock of the run.</summary>
    public TimeSpan Time;

    /// <summary>By its own clock.</summary>
    public long BootMicroseconds;

    /// <summary>UTC, microseconds since 1970; 0 until the GPS knows it.</summary>
    public ulong UtcMicroseconds;

    public bool HasPosition;

    /// <summary>Whether the GPS has a fix.</summary>
    public bool HasGps;

    /// <summary>How far what the GPS says is off to the north, metres.</summary>
    public double GpsErrorNorth;

    /// <summary>What of the error of the position is the barometer's, metres down: the GPS does not have it.</summary>
    public double BarometerErrorDown;

    /// <summary>Whether it reports of its satellites that there is no fix, whatever there is.</summary>
    public bool HidesFix;

    /// <summary>Whether it reports 0/0 as its position, whatever it knows.</summary>
    public bool HidesPlace;

    /// <summary>How far the estimate is off the measurements; 1 is where they are rejected.</summary>
    public double EstimatorRatio;

    /// <summary>Where it truly is, metres down in the world: what its barometer measures.</summary>
    public double TrueDown;

    /// <summary>Metres in the world.</summary>
    public NedVector Position;

    public NedVector Velocity;

    public EulerAngles Attitude;

    public BodyRates Rates;

    public NedVector AirVelocity;

    /// <summary>As the gimbal reports it.</summary>
    public GimbalAngles Gimbal;

    /// <summary>NaN where it does not know it.</summary>
    public double BatteryVolts;

    /// <summary>NaN where it does not know it.</summary>
    public double BatteryAmperes;

    /// <summary>NaN where it does not know it.</summary>
    public double BatteryRemaining;

    public double ConsumedAmpereHours;

    public double ConsumedJoules;
}
