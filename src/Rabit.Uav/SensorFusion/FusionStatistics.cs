namespace Rabit.Uav.SensorFusion;

/// <summary>What is counted, while it is counted. See <see cref="SensorFusionCounters"/>.</summary>
internal sealed class FusionStatistics
{
    public long ReportsUsed;
    public long TracksStarted;
    public long ReportsTwice;
    public long ReportsLate;
    public long ReportsRefused;
    public long ReportsWithoutRoom;
    public long Observations;
    public long ObservationsRefused;
    public long TracksDropped;
    public long TracksMerged;
    public long TracksStartedByEstimates;
    public long EstimatesUsed;
    public long EstimatesNotNeeded;
    public long EstimatesTwice;
    public long EstimatesRefused;
    public long EstimatesWithoutRoom;
    public long TracksOccluded;
    public long TracksFoundAgain;
    public long TracksExchanged;
    public long MeetingsWithoutRoom;

    /// <summary>Refused reports by vehicle and reason.</summary>
    public RefusalCounts Refusals { get; } = new();

    public SensorFusionCounters Close() => new()
    {
        ReportsUsed = ReportsUsed,
        TracksStarted = TracksStarted,
        ReportsTwice = ReportsTwice,
        ReportsLate = ReportsLate,
        ReportsRefused = ReportsRefused,
        ReportsWithoutRoom = ReportsWithoutRoom,
        Observations = Observations,
        ObservationsRefused = ObservationsRefused,
        TracksDropped = TracksDropped,
        TracksMerged = TracksMerged,
        TracksStartedByEstimates = TracksStartedByEstimates,
        EstimatesUsed = EstimatesUsed,
        EstimatesNotNeeded = EstimatesNotNeeded,
        EstimatesTwice = EstimatesTwice,
        EstimatesRefused = EstimatesRefused,
        EstimatesWithoutRoom = EstimatesWithoutRoom,
        TracksOccluded = TracksOccluded,
        TracksFoundAgain = TracksFoundAgain,
        TracksExchanged = TracksExchanged,
        MeetingsWithoutRoom = MeetingsWithoutRoom,
        Refused = Refusals.Close(),
    };
}
