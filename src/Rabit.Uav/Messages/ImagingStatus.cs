using System;

namespace Rabit.Uav.Messages;

/// <summary>
/// What Image Processing did so far: posted for each picture that was searched, and at least once a second. A plain
/// value; counts are since the start.
/// </summary>
public struct ImagingStatus
{
    /// <summary>Whether there is a camera at all.</summary>
    public bool HasCamera { get; set; }

    /// <summary>The mode of the last command.</summary>
    public ImagingMode Mode { get; set; }

    /// <summary>When the last picture arrived, by the clock of the run; null before the first.</summary>
    public TimeSpan? LastFrameTime { get; set; }

    /// <summary>Pictures that arrived.</summary>
    public long Frames { get; set; }

    /// <summary>Pictures that were searched.</summary>
    public long Observations { get; set; }

    /// <summary>
    /// The last picture that was searched, the ground that it shows and its reports; empty before the first.
    /// </summary>
    public CameraObservation LastObservation { get; set; }

    /// <summary>
    /// What was measured of the last picture that was good enough to be looked at; null before the first.
    /// </summary>
    public PictureFacts? LastPicture { get; set; }

    /// <summary>Pictures that were lost before they arrived, or had no room.</summary>
    public long FramesDropped { get; set; }

    /// <summary>
    /// Pictures that were not searched, whatever the cause: see <see cref="Pictures"/>.
    /// </summary>
    public long FramesRefused { get; set; }

    /// <summary>Why the last one was refused; null where none was.</summary>
    public string? LastRefusal { get; set; }

    /// <summary>How many pictures of the search were of which quality.</summary>
    public PictureCounts Pictures { get; set; }

    /// <summary>
    /// Part of the pictures of the last 1.5 s that are usable, at least the last four if they are no older than 10 s:
    /// 0 to 1. Only usable pictures count as seen. Null where there are fewer, and without a search.
    /// </summary>
    public double? UsableShare { get; set; }

    /// <summary>What most of the others of these pictures are; usable where there are none.</summary>
    public PictureQuality UnusableCause { get; set; }

    /// <summary>Part of these pictures that are of that cause, 0 to 1.</summary>
    public double UnusableCauseShare { get; set; }

    /// <summary>
    /// Side of a pixel on the ground in the middle of the last picture whose place is known, metres; 0 before the
    /// first.
    /// </summary>
    public double GroundSamplingMetres { get; set; }

    /// <summary>Reports of targets that went out.</summary>
    public long Reports { get; set; }

    /// <summary>
    /// Targets that were detected but not reported: too many in one picture, not on the ground, or no room in the
    /// queue.
    /// </summary>
    public long ReportsDropped { get; set; }

    /// <summary>
    /// How often the detector threw or returned an impossible number of detections; those pictures count as not
    /// searched.
    /// </summary>
    public long DetectorFailures { get; set; }

    /// <summary>
    /// Detections that were not valid, such as outside the picture, of a class that was not asked for, or not a number.
    /// </summary>
    public long DetectionsRefused { get; set; }

    /// <summary>
    /// Detections that were not reported since the border of the picture cuts them (unless
    /// <c>ImageProcessingOptions.ReportsCutTargets</c>).
    /// </summary>
    public long DetectionsCut { get; set; }

    /// <summary>How often the detector took longer than <c>ImageProcessingOptions.DetectorTimeBudget</c>.</summary>
    public long DetectorOverruns { get; set; }

    /// <summary>What was wrong with the detector the last time; null where nothing was.</summary>
    public string? LastDetectorFault { get; set; }

    /// <summary>
    /// The classes of the last command that are not declared, and so not searched for; null where there are none.
    /// </summary>
    public string? UnknownClasses { get; set; }

    /// <summary>Pictures in which the landing marker was found; see <see cref="LandingTargetObservation"/>.</summary>
    public long LandingMarkersFound { get; set; }

    /// <summary>Pictures in which it was seen but is not reported, or could not be looked for.</summary>
    public long LandingMarkersRefused { get; set; }

    /// <summary>Why the last of them; null while there was none.</summary>
    public string? LastLandingMarkerRefusal { get; set; }

    /// <summary>Whether the camera gives no more pictures, because it has no more or failed.</summary>
    public bool HasEnded { get; set; }

    /// <summary>What ended the camera, where it failed, or keeps it from giving pictures now; null without.</summary>
    public string? Fault { get; set; }
}
