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

    /// <summary>Metres in the world.</summary>
    public NedVector Position;

    public NedVector Velocity;

    public EulerAngles Attitude;

    public BodyRates Rates;

    public NedVector AirVelocity;

    public double CameraPitch;

    public double CameraYaw;

    public double BatteryVolts;

    public double BatteryAmperes;

    public double BatteryRemaining;

    public double ConsumedAmpereHours;

    public double ConsumedJoules;
}
