namespace Rabit.Uav.SensorFusion;

/// <summary>The books of Sensor Fusion since the start: every report that came is in exactly one of the counts of reports. Immutable.</summary>
public sealed class SensorFusionCounters
{
    /// <summary>Reports that made a track better.</summary>
    public long ReportsUsed { get; init; }

    /// <summary>Reports that started a track.</summary>
    public long TracksStarted { get; init; }

    /// <summary>Reports that came before already: same source, picture and index.</summary>
    public long ReportsTwice { get; init; }

    /// <summary>Reports that were too old to be used.</summary>
    public long ReportsLate { get; init; }

    /// <summary>Reports that made no sense: no number, a covariance that is none, a place far away from all others, a time to come.</summary>
    public long ReportsRefused { get; init; }

    /// <summary>Reports that should have started a track or waited, and found no room.</summary>
    public long ReportsWithoutRoom { get; init; }

    /// <summary>Looks that were taken in.</summary>
    public long Looks { get; init; }

    /// <summary>Looks whose corners, number or time made no sense.</summary>
    public long ObservationsRefused { get; init; }

    /// <summary>Looks that had fewer reports than they said; they are no miss for anything.</summary>
    public long LooksIncomplete { get; init; }

    /// <summary>Tracks that were never confirmed and given up.</summary>
    public long TracksDropped { get; init; }

    /// <summary>Tracks that turned out to be of the target of another track.</summary>
    public long TracksMerged { get; init; }
}
