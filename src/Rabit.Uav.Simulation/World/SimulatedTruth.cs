using System;
using System.Collections.Generic;
using Rabit.Uav.ImageProcessing.Geolocation;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The true state of the simulated vehicle, and what it has done so far. A snapshot, immutable; all in the frame of
/// the world.
/// </summary>
public sealed class SimulatedTruth
{
    internal SimulatedTruth()
    {
    }

    /// <summary>How it is now.</summary>
    public TruePose Pose { get; internal init; }

    /// <summary>Where it has been, about five times a second while it was armed; from its start.</summary>
    public IReadOnlyList<TruePose> Path { get; internal init; } = Array.Empty<TruePose>();

    /// <summary>Whether the motors are armed.</summary>
    public bool IsArmed { get; internal init; }

    /// <summary>Whether it is off the ground.</summary>
    public bool IsAirborne { get; internal init; }

    /// <summary>Whether it was off the ground at any time.</summary>
    public bool HasFlown { get; internal init; }

    /// <summary>Where and when it last came down; null while it has not.</summary>
    public TruePose? Landing { get; internal init; }

    /// <summary>How fast it came down then, m/s.</summary>
    public double TouchdownMetresPerSecond { get; internal init; }

    /// <summary>Whether it came down so fast (above 2 m/s) that a real one would be broken.</summary>
    public bool HasCrashed { get; internal init; }

    /// <summary>Flight mode, by ArduCopter's number.</summary>
    public uint CustomMode { get; internal init; }

    /// <summary>Flight mode, by ArduCopter's name.</summary>
    public string Mode { get; internal init; } = string.Empty;

    /// <summary>What is truly left in the battery, of its true capacity, 0 to 1.</summary>
    public double BatteryRemaining { get; internal init; }

    /// <summary>Off the ground, all flights together.</summary>
    public TimeSpan Airtime { get; internal init; }

    /// <summary>Flown over ground, metres.</summary>
    public double FlownMetres { get; internal init; }

    /// <summary>Above the ground, metres.</summary>
    public double MaxHeightMetres { get; internal init; }

    /// <summary>Over ground, m/s.</summary>
    public double MaxSpeedMetresPerSecond { get; internal init; }

    /// <summary>Furthest from home over ground, metres.</summary>
    public double MaxDistanceMetres { get; internal init; }

    /// <summary>Frames that the vehicle sent.</summary>
    public long FramesSent { get; internal init; }

    /// <summary>Frames that it received.</summary>
    public long FramesReceived { get; internal init; }

    /// <summary>
    /// Frames that were lost on either way: by a scripted silence, a full queue, a link that could not take them, or
    /// an id that no dialect knows.
    /// </summary>
    public long FramesLost { get; internal init; }
}
