using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>The state of a flight at one moment, by the posted messages. A plain value.</summary>
public struct FlightSample
{
    /// <summary>By the clock of the run.</summary>
    public TimeSpan Time { get; set; }

    /// <summary>Whether the position is known; without it <see cref="Position"/> is empty.</summary>
    public bool HasPosition { get; set; }

    /// <summary>By the autopilot.</summary>
    public GeodeticPosition Position { get; set; }

    /// <summary>Metres.</summary>
    public double HeightAboveHomeMetres { get; set; }

    /// <summary>Over ground, horizontally, metres per second.</summary>
    public double GroundSpeed { get; set; }

    /// <summary>Clockwise from north.</summary>
    public Angle Yaw { get; set; }

    /// <summary>Remaining charge, 0 to 1; NaN where it is not known.</summary>
    public double BatteryRemaining { get; set; }

    /// <summary>
    /// What is truly left in the battery, by the energy model of Mission Control, 0 to 1; NaN where it is not known.
    /// </summary>
    public double ChargeLeft { get; set; }

    /// <summary>
    /// What the way home and the reserve take, 0 to 1; NaN where it is not known.
    /// </summary>
    public double ChargeNeeded { get; set; }

    /// <summary>What Mission Control did.</summary>
    public MissionPhase Phase { get; set; }

    /// <summary>The part of the area that was searched, 0 to 1.</summary>
    public double Coverage { get; set; }

    /// <summary>By Health Monitoring.</summary>
    public HealthLevel Health { get; set; }
}
