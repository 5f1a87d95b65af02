using System.Collections.Immutable;

namespace Rabit.Uav.SensorFusion;

/// <summary>
/// The counters of Sensor Fusion since the start: every report that arrived is in exactly one of the counts of reports.
/// <see cref="TracksStarted"/> and <see cref="TracksStartedByEstimates"/> less <see cref="TracksDropped"/> and
/// <see cref="TracksMerged"/> is how many tracks there are. Immutable.
/// </summary>
public sealed class SensorFusionCounters
{
    /// <summary>Reports that updated a track.</summary>
    public long ReportsUsed { get; init; }

    /// <summary>Reports that started a track.</summary>
    public long TracksStarted { get; init; }

    /// <summary>Reports that arrived before: same source, picture and index.</summary>
    public long ReportsTwice { get; init; }

    /// <summary>Reports that were too old to be used.</summary>
    public long ReportsLate { get; init; }

    /// <summary>
    /// Reports that are not valid: not a number, a covariance that is none, a place far away from all others, a time in
    /// the future.
    /// </summary>
    public long ReportsRefused { get; init; }

    /// <summary>Reports that should have started a track or waited, and found no room.</summary>
    public long ReportsWithoutRoom { get; init; }

    /// <summary>Observations that were used: pictures of our own camera that were searched.</summary>
    public long Observations { get; init; }

    /// <summary>Observations whose corners, number or time are not valid; their reports are used.</summary>
    public long ObservationsRefused { get; init; }

    /// <summary>
    /// Who sent the reports that were refused, and why: <see cref="ReportsRefused"/> and <see cref="EstimatesRefused"/>
    /// by vehicle, and of targets that move also the reports that were too old. By vehicle and reason; those without
    /// any are not there.
    /// </summary>
    public ImmutableArray<RefusedReports> Refused { get; init; } = [];

    /// <summary>Tracks that were deleted: before they were confirmed, or of targets that move and are gone.</summary>
    public long TracksDropped { get; init; }

    /// <summary>
    /// Tracks that turned out to be of the target of another track, which goes on as both, or without one of another
    /// class that it was taken for; of a target that was hidden also one of <see cref="TracksFoundAgain"/>.
    /// </summary>
    public long TracksMerged { get; init; }

    /// <summary>
    /// Tracks of other vehicles that started one of ours; each is in <see cref="EstimatesUsed"/>, too.
    /// </summary>
    public long TracksStartedByEstimates { get; init; }

    /// <summary>
    /// Tracks of other vehicles that started one of ours or were fused with it; each is in exactly one of the counts
    /// of estimates.
    /// </summary>
    public long EstimatesUsed { get; init; }

    /// <summary>Those of a target of which ours is as new, or of a class that does not move here.</summary>
    public long EstimatesNotNeeded { get; init; }

    /// <summary>Those that arrived before: same vehicle, track and picture.</summary>
    public long EstimatesTwice { get; init; }

    /// <summary>
    /// Those that are not valid, too old or of the future; <see cref="Refused"/> says whose, and why.
    /// </summary>
    public long EstimatesRefused { get; init; }

    /// <summary>Those that found no room for a track.</summary>
    public long EstimatesWithoutRoom { get; init; }

    /// <summary>
    /// How often a track of a target that moves was missed where it should have been seen, and kept since its target
    /// is taken to be hidden.
    /// </summary>
    public long TracksOccluded { get; init; }

    /// <summary>How often the target of one of these was seen again, and has kept its track.</summary>
    public long TracksFoundAgain { get; init; }

    /// <summary>How often two tracks that had met gave each other the reports that were the other one's.</summary>
    public long TracksExchanged { get; init; }

    /// <summary>
    /// How often two tracks met and were not looked at later, since too many others had met; counted each time that
    /// both are reported.
    /// </summary>
    public long MeetingsWithoutRoom { get; init; }
}
