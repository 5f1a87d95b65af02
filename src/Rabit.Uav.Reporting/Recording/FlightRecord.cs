using System;
using System.Collections.Generic;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>What a <see cref="FlightRecorderManager"/> has recorded of a flight so far. Immutable.</summary>
/// <example>
/// <code>
/// FlightRecord record = recorder.Record;   // a snapshot, any thread
/// foreach (PhaseChange change in record.Phases)
///     Console.WriteLine($"{change.Time.TotalSeconds:0.0} s: {change.Phase}");
/// </code>
/// </example>
public sealed class FlightRecord
{
    private IReadOnlyList<PhaseChange> _phases = [];
    private MissionStatus _mission;
    private VehicleState _vehicle;

    /// <summary>Nothing yet.</summary>
    public static FlightRecord Empty { get; } = new();

    /// <summary>Oldest first, evenly spaced.</summary>
    public IReadOnlyList<FlightSample> Samples { get; init; } = [];

    /// <summary>Pictures that were searched, and the ground that they show; evenly spaced.</summary>
    public IReadOnlyList<CameraObservation> Observations { get; init; } = [];

    /// <summary>The best image chips of each track, up to three.</summary>
    public IReadOnlyList<ImageChip> Pictures { get; init; } = [];

    /// <summary>The whole pictures with the best report of each track, scaled down.</summary>
    public IReadOnlyList<PictureOverview> Overviews { get; init; } = [];

    /// <summary>Changes of the mission's phase, oldest first.</summary>
    public IReadOnlyList<PhaseChange> Phases
    {
        get => _phases;
        init => _phases = value;
    }

    /// <summary>Changes of the health report, oldest first.</summary>
    public IReadOnlyList<HealthChange> HealthChanges { get; init; } = [];

    /// <summary>State and counts of each recorded manager over time.</summary>
    public IReadOnlyList<ManagerTimeLine> Managers { get; init; } = [];

    /// <summary>What the frames contain.</summary>
    public TelemetryRecord Telemetry { get; init; } = new();

    /// <summary>As last posted.</summary>
    public AutopilotStatistics Autopilot { get; init; }

    /// <summary>As last posted.</summary>
    public VehicleState Vehicle
    {
        get => _vehicle;
        init => _vehicle = value;
    }

    /// <summary>As last posted.</summary>
    public MissionStatus Mission
    {
        get => _mission;
        init => _mission = value;
    }

    /// <summary>As last posted.</summary>
    public HealthReport Health { get; init; }

    /// <summary>As last posted.</summary>
    public ImagingStatus Imaging { get; init; }

    /// <summary>As last posted.</summary>
    public CommandAuthority Authority { get; init; }

    /// <summary>As last posted, with the confirmed tracks of targets that moved and are gone.</summary>
    public TrackList Tracks { get; init; } = TrackList.None;

    /// <summary>As last posted; default where the vehicle is in no group.</summary>
    public GroupStatus Group { get; init; }

    /// <summary>What it did for its group, at each change, oldest first; none where it is in no group.</summary>
    public IReadOnlyList<GroupRole> GroupRoles { get; init; } = [];

    /// <summary>Where the tracks of targets that move were while they were seen.</summary>
    public IReadOnlyList<TrackPath> MovingTrackPaths { get; init; } = [];

    /// <summary>Length of the path that was flown, metres: speed over ground and climb, integrated over time.</summary>
    public double FlownMetres { get; init; }

    /// <summary>How long the vehicle was armed.</summary>
    public TimeSpan ArmedTime { get; init; }

    /// <summary>The greatest height above home, metres.</summary>
    public double MaxHeightAboveHomeMetres { get; init; }

    /// <summary>
    /// The remaining charge of the battery when it was first reported, 0 to 1; NaN where it never was.
    /// </summary>
    public double FirstBatteryRemaining { get; init; } = double.NaN;

    /// <summary>
    /// What the group asked and knows of a target, as this vehicle knows it: the task of its validation by another one.
    /// Of several, as two vehicles announced it, one that has a result; null where it was never announced.
    /// </summary>
    /// <param name="track">A track of this vehicle.</param>
    /// <exception cref="ArgumentNullException">It is null.</exception>
    public ValidationTask? ValidationOf(TargetTrack track) => TrackValidation.Of(
        track ?? throw new ArgumentNullException(nameof(track)), Group.Validations);

    /// <summary>
    /// The record with what was posted after the recorder's last unit of work: Mission Control posts its last status at
    /// its shutdown.
    /// </summary>
    /// <param name="mission">The status of the mission, which may also be that of the record.</param>
    /// <param name="vehicle">The state of the vehicle, which may also be that of the record.</param>
    public FlightRecord WithLatest(in MissionStatus mission, in VehicleState vehicle)
    {
        var record = (FlightRecord)MemberwiseClone();
        record._mission = mission;
        record._vehicle = vehicle;
        bool isNewPhase = mission.Phase != Mission.Phase || mission.Since != Mission.Since;
        if (isNewPhase)
            record._phases = [.. Phases, new PhaseChange(mission.Since, mission.Phase, mission.Text)];
        return record;
    }
}
