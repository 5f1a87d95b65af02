using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// The camera of Image Processing, the classes of targets, and the detector. Read once, when the manager is made.
/// </summary>
public sealed class ImageProcessingOptions
{
    // A report's index is a byte between vehicles.
    private const int ReportsLimit = 200;

    // No detector needs more; a larger number is a mistake.
    private const double MaxTargetPixels = 1000;

    /// <summary>The camera's pinhole and lens. Needed where there is a camera.</summary>
    public CameraModel? Camera { get; set; }

    /// <summary>How the camera sits on the vehicle.</summary>
    /// <value>
    /// The default is no misalignment and no distance from the point whose position the autopilot reports.
    /// </value>
    public CameraMount Mount { get; set; } = new();

    /// <summary>The errors of what positions on the ground are computed from.</summary>
    public ErrorBudget Errors { get; set; } = new();

    /// <summary>The classes of targets that there are; a mission names those it is interested in.</summary>
    /// <value>The default is <see cref="TargetClass.Defaults"/>: square panels of five colours.</value>
    public ImmutableArray<TargetClass> TargetClasses { get; set; } = TargetClass.Defaults;

    /// <summary>
    /// The marker on the place to land on: every picture is searched for it, whatever the mission does, and where it is
    /// goes to the autopilot (<see cref="LandingTargetObservation"/>), which lands on it where it is set up for that.
    /// It needs no target class.
    /// </summary>
    /// <value>The default, null, is none.</value>
    public LandingMarkerOptions? LandingMarker { get; set; }

    /// <summary>What finds targets in pictures. It belongs to one manager; its thread is that of the manager.</summary>
    /// <value>
    /// The default, null, is what <see cref="CreateDetector"/> makes: a <see cref="ShapeTargetDetector"/> of those
    /// <see cref="TargetClasses"/> that have one colour, a <see cref="PanelTargetDetector"/> of those of two colours or
    /// of black, a <see cref="MarkerTargetDetector"/> of those that are markers, and a
    /// <see cref="TemplateTargetDetector"/> of those that have a template. Of a thermal camera it is a
    /// <see cref="HotSpotTargetDetector"/>.
    /// </value>
    public ITargetDetector? Detector { get; set; }

    /// <summary>
    /// How long the detector may take for a picture, by the manager's clock; longer ones are counted and reported by
    /// Health.
    /// </summary>
    /// <value>The default is 200 ms: four pictures a second leave 250 ms for each.</value>
    public TimeSpan DetectorTimeBudget { get; set; } = TimeSpan.FromMilliseconds(200);

    /// <summary>
    /// How many pixels the side of the smallest target must have that is searched for: where the pixels of a picture
    /// are larger on the ground it is not searched, and that ground does not count as seen; nor is a picture in which
    /// too little is left, or in which the ground moves further during the exposure. 0: not judged.
    /// </summary>
    /// <value>
    /// The default, null, is 4, what the default detector needs of a panel, and with another <see cref="Detector"/> 0:
    /// what that needs is not known.
    /// </value>
    public double? MinTargetPixels { get; set; }

    /// <summary>
    /// How many targets of one picture are reported, the most confident first; the others are counted. 1 to 200.
    /// </summary>
    /// <value>The default is 16.</value>
    public int MaxReportsPerPicture { get; set; } = 16;

    /// <summary>
    /// Whether targets that the border of the picture cuts are reported too, for an application with single pictures
    /// and not a flight: where their middle would lie by the sizes of their class, with a covariance that has what is
    /// not known of that. Each may be a part of anything that is larger, so their class is less sure. Of classes that
    /// are found by one colour and form; panels of two colours or black and white, markers and templates are not found
    /// where the border cuts them. The size is that of the part that is seen.
    /// </summary>
    /// <value>The default is false: a camera in flight sees them whole a moment later.</value>
    public bool ReportsCutTargets { get; set; }

    /// <summary>How far below the horizon a line of sight must point.</summary>
    /// <value>The default is 5 degrees: nearer to the horizon every error grows without limit.</value>
    public Angle MinDepression { get; set; } = Angle.FromDegrees(5);

    /// <summary>How long a picture waits for a pose of its time.</summary>
    /// <value>
    /// The default is 0.65 s: a camera clock that is half a second fast, or a radio that takes as long, can then still
    /// be found out by where the targets are; without poses, Health reports it within 3 s.
    /// </value>
    public TimeSpan PoseTimeout { get; set; } = TimeSpan.OfSeconds(0.65);

    /// <summary>
    /// How far beyond the newest samples a pose is extrapolated, once a picture has waited long enough; its covariance
    /// grows with that.
    /// </summary>
    /// <value>The default is 100 ms; zero refuses such pictures.</value>
    public TimeSpan MaxExtrapolation { get; set; } = TimeSpan.FromMilliseconds(100);

    /// <summary>Heights of the ground, above mean sea level.</summary>
    /// <value>Null, the default, for ground that is flat and level at the height of the command.</value>
    public TerrainGrid? Terrain { get; set; }

    /// <summary>How far apart two positions, or two attitudes, may be for a pose between them.</summary>
    /// <value>The default is 1 s: at 5 Hz four may be lost on the way.</value>
    public TimeSpan MaxPoseGap { get; set; } = TimeSpan.FromSeconds(1);

    /// <summary>
    /// How many pictures may wait for a pose; a further one drops the oldest. Each of them keeps a buffer of the
    /// camera's pool.
    /// </summary>
    /// <value>The default is 4: two pictures a second for the default of <see cref="PoseTimeout"/>.</value>
    public int FramesWaiting { get; set; } = 4;

    /// <summary>Side of the part of a picture that is kept of each report, pixels.</summary>
    /// <value>The default is 48.</value>
    public int ImageChipSide { get; set; } = 48;

    /// <summary>How many of those are kept, the newest.</summary>
    /// <value>The default is 200: 1.4 MB.</value>
    public int MaxImageChips { get; set; } = 200;

    /// <summary>
    /// How many whole pictures with reports are kept, scaled down, the newest:
    /// <see cref="ImageProcessingManager.FindPictureOverview"/>. 0 to 1000.
    /// </summary>
    /// <value>The default is 12: 2.8 MB.</value>
    public int MaxPictureOverviews { get; set; } = 12;

    /// <summary>How wide they are at most, pixels, 16 to 4096.</summary>
    /// <value>The default is 320.</value>
    public int PictureOverviewWidth { get; set; } = 320;

    /// <summary>Where pictures are kept as files, each with its place and pose.</summary>
    /// <value>The default, null, is nowhere.</value>
    public KeptPictureOptions? KeptPictures { get; set; }

    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    internal ImageProcessingOptions ValidatedCopy(bool hasCamera, string parameter)
    {
        List<string> faults = FindFaults(hasCamera).ToList();
        if (faults.Count > 0)
            throw new ArgumentException("Image Processing: " + string.Join("; ", faults) + ".", parameter);
        ImageProcessingOptions copy = Copy();
        copy.Errors = Errors.Copy();
        copy.LandingMarker = LandingMarker?.Copy();
        copy.KeptPictures = KeptPictures?.Copy();
        return copy;
    }

    internal ImageProcessingOptions Copy() => (ImageProcessingOptions)MemberwiseClone();

    internal double EffectiveMinTargetPixels
        => MinTargetPixels ?? (Detector is null ? ShapeTargetDetector.MinSidePixels : 0);

    /// <summary>
    /// Makes the detector that searches for <see cref="TargetClasses"/> where <see cref="Detector"/> is null: one for
    /// each kind of class that there is. For a detector of your own that adds to it, and for measurements.
    /// </summary>
    /// <returns>A new detector, for one thread; it keeps its memory from picture to picture.</returns>
    /// <exception cref="InvalidOperationException">Options are out of their range; the text names all.</exception>
    public ITargetDetector CreateDetector()
    {
        string[] faults = [.. FindFaults(hasCamera: false)];
        if (faults.Length > 0)
            throw new InvalidOperationException("Image Processing: " + string.Join("; ", faults) + ".");

        return DefaultDetector.Create(TargetClasses);
    }

    internal IEnumerable<string> FindFaults(bool hasCamera)
        => FindFaultsOfValues(hasCamera).Concat(FindFaultsInParts());

    private IEnumerable<string> FindFaultsOfValues(bool hasCamera)
    {
        if (Mount is null || Errors is null)
            yield return "the mount and the errors may not be null";
        if (hasCamera && Camera is null)
            yield return $"there is a camera, but {nameof(Camera)} does not say what it is like";
        if (DetectorTimeBudget <= TimeSpan.Zero)
            yield return $"{nameof(DetectorTimeBudget)} is {DetectorTimeBudget}; it must be above zero";
        if (MinTargetPixels is { } pixels && !(pixels >= 0 && pixels <= MaxTargetPixels))
        {
            yield return FormattableString.Invariant(
                $"{nameof(MinTargetPixels)} is {pixels}; it must be 0 to {MaxTargetPixels}");
        }

        if (MaxReportsPerPicture is < 1 or > ReportsLimit)
            yield return $"{nameof(MaxReportsPerPicture)} is {MaxReportsPerPicture}; it must be 1 to {ReportsLimit}";
        if (!(MinDepression.Degrees > 0 && MinDepression.Degrees < 90))
            yield return FormattableString.Invariant(
                $"{nameof(MinDepression)} is {MinDepression}; it must be between 0 and 90°");
        if (PoseTimeout < TimeSpan.Zero)
            yield return $"{nameof(PoseTimeout)} is {PoseTimeout}; it must not be negative";
        if (MaxExtrapolation < TimeSpan.Zero || MaxExtrapolation > TimeSpan.FromSeconds(1))
            yield return $"{nameof(MaxExtrapolation)} is {MaxExtrapolation}; it must be from zero to a second";
        if (MaxPoseGap <= TimeSpan.Zero)
            yield return $"{nameof(MaxPoseGap)} is {MaxPoseGap}; it must be above zero";
        if (FramesWaiting < 1)
            yield return $"{nameof(FramesWaiting)} is {FramesWaiting}; it must be at least 1";
        if (ImageChipSide < 1 || MaxImageChips < 0)
            yield return $"{nameof(ImageChipSide)} is {ImageChipSide} and {nameof(MaxImageChips)} {MaxImageChips}; "
                + "they must be at least 1 and 0";
        if (MaxPictureOverviews is < 0 or > 1000 || PictureOverviewWidth is < 16 or > 4096)
        {
            yield return $"{nameof(MaxPictureOverviews)} is {MaxPictureOverviews} and {nameof(PictureOverviewWidth)} "
                + $"{PictureOverviewWidth}; they must be 0 to 1000 and 16 to 4096";
        }
    }

    // A detector of the user's may find anything in any picture.
    private IEnumerable<string> FindClassesOfAnotherCamera()
    {
        if (Camera is null || Detector is not null || TargetClasses.IsDefault)
            yield break;
        bool isThermal = Camera.Format == PixelFormat.Grey16;
        if (isThermal && !TargetClasses.Any(c => c?.HotSpot is not null))
            yield return "the camera is a thermal one, and no target class is a hot spot";
        foreach (TargetClass one in TargetClasses.Where(c => c?.HotSpot is not null && !isThermal))
            yield return $"target class {one.Name} is a hot spot, and the camera is no thermal one (16 bits of grey)";
        if (isThermal && KeptPictures is not null)
            yield return "the camera is a thermal one, whose pictures are not kept";
        if (isThermal && LandingMarker is not null)
            yield return "the camera is a thermal one, which sees no landing marker";
    }

    private IEnumerable<string> FindFaultsInParts()
        => (Camera?.FindFaults() ?? [])
            .Concat(FindClassesOfAnotherCamera())
            .Concat(Mount?.FindFaults() ?? [])
            .Concat(Errors?.FindFaults() ?? [])
            .Concat(LandingMarker?.FindFaults() ?? [])
            .Concat(KeptPictures?.FindFaults() ?? [])
            .Concat(TargetClass.FindFaults(TargetClasses))
            .Concat(Detector is null && !TargetClasses.IsDefault ? DefaultDetector.FindFaults(TargetClasses) : []);
}
