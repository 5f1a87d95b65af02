using System;
using System.Collections.Generic;
using Rabit.Uav.ImageProcessing;

namespace Rabit.Uav.Reporting;

/// <summary>
/// What a <see cref="FlightRecorderManager"/> records, and when it ends the run. Read once, when the recorder is
/// made.
/// </summary>
public sealed class FlightRecorderOptions
{
    /// <summary>The managers whose state is recorded; they must be in the same reactor.</summary>
    /// <value>The default is none.</value>
    public IReadOnlyList<string> ManagerNames { get; set; } = [];

    /// <summary>
    /// Whether the run ends when the mission is over: landed, or failed or handed over with motors off.
    /// </summary>
    /// <value>The default is false.</value>
    public bool StopsWhenMissionEnds { get; set; }

    /// <summary>
    /// With <see cref="StopsWhenMissionEnds"/>: the run ends after this time also where the mission is not over; null
    /// for no limit.
    /// </summary>
    /// <value>The default is null.</value>
    public TimeSpan? MaxMissionTime { get; set; }

    /// <summary>
    /// Returns the newest image chips, as <see cref="ImageProcessingManager.ImageChips"/> does; null for a record
    /// without pictures. Called on the recorder's thread.
    /// </summary>
    /// <value>The default is null.</value>
    public Func<IReadOnlyList<ImageChip>>? ImageChips { get; set; }

    /// <summary>
    /// Returns a whole picture by its number, as <see cref="ImageProcessingManager.FindPictureOverview"/> does; null
    /// for a record without them. Called on the recorder's thread.
    /// </summary>
    /// <value>The default is null.</value>
    public Func<long, PictureOverview?>? FindPictureOverview { get; set; }
}
