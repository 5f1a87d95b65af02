using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>How things stood at one moment of the flight, as the messages told. A plain value.</summary>
internal struct FlightSample
{
    /// <summary>By the clock of the run.</summary>
    public TimeSpan Time { get; set; }

    /// <summary>Whether the vehicle has told where it is; without it <see cref="Position"/> is empty.</summary>
    public bool HasPosition { get; set; }

    public GeodeticPosition Position { get; set; }

    public double HeightAboveHomeMetres { get; set; }

    /// <summary>Over ground, horizontally, metres per second.</summary>
    public double GroundSpeed { get; set; }

    public double YawRadians { get; set; }

    /// <summary>0 to 1; NaN where it is not known.</summary>
    public double BatteryRemaining { get; set; }

    public MissionPhase Phase { get; set; }

    /// <summary>0 to 1.</summary>
    public double Coverage { get; set; }

    public HealthLevel Health { get; set; }
}
