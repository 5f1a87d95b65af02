using System;
using System.Collections.Generic;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>What the recorder has kept of a flight so far. Immutable.</summary>
internal sealed class FlightRecord
{
    /// <summary>Nothing yet.</summary>
    public static FlightRecord Empty { get; } = new();

    /// <summary>Oldest first, evenly spaced.</summary>
    public IReadOnlyList<FlightSample> Samples { get; init; } = [];

    /// <summary>Pictures that were searched, and the ground that they show.</summary>
    public IReadOnlyList<CameraObservation> Looks { get; init; } = [];

    /// <summary>The best of each track.</summary>
    public IReadOnlyList<ImageChip> Pictures { get; init; } = [];

    public IReadOnlyList<PhaseChange> Phases { get; init; } = [];

    public IReadOnlyList<HealthChange> HealthChanges { get; init; } = [];

    public IReadOnlyList<ManagerTimeLine> Managers { get; init; } = [];

    /// <summary>As last told.</summary>
    public VehicleState Vehicle { get; init; }

    /// <summary>As last told.</summary>
    public MissionStatus Mission { get; init; }

    /// <summary>As last told.</summary>
    public HealthReport Health { get; init; }

    /// <summary>As last told.</summary>
    public ImagingStatus Imaging { get; init; }

    /// <summary>As last told.</summary>
    public CommandAuthority Authority { get; init; }

    /// <summary>As last told.</summary>
    public TrackList Tracks { get; init; } = TrackList.None;

    /// <summary>Length of the path that was flown, metres: speed over ground and climb, added up over time.</summary>
    public double FlownMetres { get; init; }

    /// <summary>How long the motors could turn.</summary>
    public TimeSpan ArmedTime { get; init; }

    /// <summary>The greatest height above home, metres.</summary>
    public double GreatestHeightMetres { get; init; }

    /// <summary>What was in the battery when it was first told, 0 to 1; NaN where it never was.</summary>
    public double FirstBatteryRemaining { get; init; } = double.NaN;
}
