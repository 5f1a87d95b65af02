using System;
using System.Collections.Immutable;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.ImageProcessing.Quality;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Searches one picture whose pose is known: which ground it shows, whether it is good enough, what the detector finds
/// in it, where that is. The result stays until the next picture. Allocates nothing for a picture without targets; for
/// one thread.
/// </summary>
internal sealed class PictureSearch : IGroundScaleSource
{
    public const string WrongSize = "the picture is not of the size that the camera is to have";
    public const string NoBuffer = "the picture has no buffer, or one that is too small";
    public const string NotGround = "too little of the picture shows the ground";
    public const string NoClasses = "none of the target classes to search for is declared";

    private readonly CameraModel _camera;
    private readonly DetectorRunner _detector;
    private readonly WantedClasses _wanted;
    private readonly GroundProjector _projector;
    private readonly FrameJudge _judge = new();
    private readonly double _minTargetPixels;
    private readonly PoseHistory _poses;
    private readonly TimeSpan _maxExtrapolation;
    private readonly RowPoses _rows;
    private readonly SearchedPart _part;
    private readonly TargetReport[] _reports;
    private readonly NedVector[] _byOffset = new NedVector[TargetSensitivity.Offsets];
    private GroundProjection _projection;   // of the middle row, while the detector runs
    private double _maxPixelArea;           // of the picture, where all of it is not searched
    private int _reportCount;
    private CameraObservation _observation;

    /// <param name="options">Checked.</param>
    /// <param name="camera">Of the options.</param>
    /// <param name="poses">Where the poses of single rows come from, with a rolling shutter.</param>
    /// <param name="clock">The manager's, for the time that the detector takes.</param>
    public PictureSearch(ImageProcessingOptions options, CameraModel camera, PoseHistory poses, Func<TimeSpan> clock)
    {
        _camera = camera;
        _poses = poses;
        _maxExtrapolation = options.MaxExtrapolation;
        _rows = new RowPoses(camera, poses, _maxExtrapolation);
        _detector = new DetectorRunner(
            options.Detector ?? options.CreateDetector(), options.DetectorTimeBudget,
            options.MaxReportsPerPicture, clock, options.ReportsCutTargets);
        _wanted = new WantedClasses(options.TargetClasses);
        _minTargetPixels = options.EffectiveMinTargetPixels;
        _projector = new GroundProjector(camera, options.Mount, options.Errors, options.MinDepression, options.Terrain);
        _part = new SearchedPart(camera, _projector, _rows);
        _reports = new TargetReport[options.MaxReportsPerPicture];
    }

    /// <summary>The last picture that was searched: which ground it shows, and the reports.</summary>
    public ref readonly CameraObservation Observation => ref _observation;

    /// <summary>Targets of the last picture that were not reported: too many, or not on the ground.</summary>
    public int Dropped => _detector.Dropped + _detector.Found.Length - _reportCount;

    /// <summary>What became of the last picture.</summary>
    public PictureQuality Quality { get; private set; }

    /// <summary>
    /// Whether the last picture could not be used because of a manoeuvre of the vehicle alone: level, a camera that
    /// points forward would show the ground, fine enough; or without the rotation it would be sharp enough.
    /// </summary>
    public bool IsByManoeuvre { get; private set; }

    /// <summary>What was measured of the last picture that was looked at.</summary>
    public PictureFacts? Facts => _judge.Facts;

    /// <summary>How the last picture that shows the ground was taken.</summary>
    public PictureView View { get; private set; }

    /// <summary>What the detector did so far.</summary>
    public DetectorRunner Detector => _detector;

    /// <summary>Classes of the last command that are not declared; null if there are none.</summary>
    public string? UnknownClasses => _wanted.Unknown;

    private double NeededSamplingMetres
        => _minTargetPixels > 0 ? _wanted.MinSideMetres / _minTargetPixels : double.PositiveInfinity;

    /// <summary>Searches a picture.</summary>
    /// <param name="frame">The picture.</param>
    /// <param name="pose">At the middle of the exposure of the middle row.</param>
    /// <param name="command">What to search for, and where the camera points.</param>
    /// <param name="systemId">Whose camera it is.</param>
    /// <returns>Why it could not be searched; null if it was.</returns>
    public string? Search(in CameraFrame frame, in Pose pose, in ImagingCommand command, byte systemId)
    {
        _reportCount = 0;
        (Quality, IsByManoeuvre) = (PictureQuality.NotSearched, false);
        if (frame.Width != _camera.Width || frame.Height != _camera.Height)
            return WrongSize;
        int bytes = frame.Width * frame.Height * DetectorInput.BytesPerPixel(frame.Format);
        if (frame.Pixels.IsEmpty || frame.Pixels.Array.Length < bytes)
            return NoBuffer;
        ImmutableArray<TargetClass> classes = _wanted.Select(command.Classes);
        if (classes.IsEmpty)
            return NoClasses;
        _projector.SetTimeNoise(frame.TimeNoise);
        _projection = _projector.At(pose, command);
        if (RefuseGround(frame, pose, command) is { } notSeen)
            return notSeen;
        Quality = _judge.Judge(frame, View);
        if (Quality != PictureQuality.Usable)
        {
            IsByManoeuvre = Quality switch
            {
                PictureQuality.TooCoarse => IsFineWhenLevel(pose, command),
                PictureQuality.MotionBlurred => IsSharpWithoutRotation(frame, pose, command),
                _ => false,
            };
            return PictureQualityText.RefusalOf(Quality);
        }

        Quality = PictureQuality.NotSearched;
        if (Detect(frame, classes) is { } refusal)
            return refusal;
        Quality = PictureQuality.Usable;
        foreach (ref readonly TargetDetection detection in _detector.Found)
            Report(detection, frame, pose, command, systemId);
        _judge.SetDetections(_detector.Found.Length);
        _observation.SourceSystemId = systemId;
        _observation.Number = frame.Number;
        _observation.Time = pose.Time;
        _observation.Reports = _reportCount == 0 ? [] : ImmutableArray.Create(_reports, 0, _reportCount);
        return null;
    }

    /// <summary>What the last picture that was searched says of itself when it is kept.</summary>
    /// <param name="command">Of that search.</param>
    /// <param name="takenUtc">The middle of its exposure.</param>
    public PhotoMetadata CreateMetadata(in ImagingCommand command, DateTimeOffset takenUtc)
        => PictureMetadata.Of(_camera, _projection, command.GroundAltitudeAmslMetres, takenUtc);

    /// <inheritdoc/>
    public bool TryScale(double column, double row, out GroundScale scale)
        => _projection.TryScale(column, row, out scale) && scale.PixelArea <= _maxPixelArea;

    private string? Detect(in CameraFrame frame, ImmutableArray<TargetClass> classes)
    {
        var input = new DetectorInput(
            new ReadOnlyMemory<byte>(
                frame.Pixels.Array, 0, frame.Width * frame.Height * DetectorInput.BytesPerPixel(frame.Format)),
            frame.Width,
            frame.Height,
            classes,
            new PictureGroundScale(this),
            frame.Format)
        {
            PictureNumber = frame.Number,
            Time = frame.MidExposure,
        };
        return _detector.Run(input);
    }

    // What is seen of the ground, and in which pixels; why that is too little, or null.
    private string? RefuseGround(in CameraFrame frame, in Pose pose, in ImagingCommand command)
    {
        bool isEnough = _part.TryFind(frame, pose, command, NeededSamplingMetres);
        bool isGround = _part.IsGround || isEnough;
        _maxPixelArea = _part.IsWhole ? double.PositiveInfinity : NeededSamplingMetres * NeededSamplingMetres;
        if (TryView(frame, pose, command) && isEnough && _part.TryLocate(ref _observation))
            return null;
        Quality = isGround ? PictureQuality.TooCoarse : PictureQuality.NotGround;
        IsByManoeuvre = IsFineWhenLevel(pose, command);
        return isGround ? PictureQualityText.RefusalOf(Quality) : NotGround;
    }

    private bool TryView(in CameraFrame frame, in Pose pose, in ImagingCommand command)
    {
        (double column, double row) = (_part.Centre.X, _part.Centre.Y);
        if (!_projection.TryProjectToGround(column, row, out GeodeticPosition centre)
            || !_projection.TryScale(column, row, out GroundScale scale)
            || !TrySmear(frame.Exposure, pose, command, centre, out double smear))
            return false;
        View = new PictureView
        {
            Centre = centre,
            GroundSamplingMetres = Math.Sqrt(scale.PixelArea),
            SmearMetres = smear,
            NeededSamplingMetres = NeededSamplingMetres,
        };
        return true;
    }

    private bool IsFineWhenLevel(Pose pose, in ImagingCommand command)
    {
        pose.Attitude = Rotation.FromEuler(new EulerAngles(default, default, pose.Attitude.ToEuler().Yaw));
        return _part.TryFind(pose, command, NeededSamplingMetres);
    }

    // The rotation smears it, and without it it would be sharp enough. Where the pose shows no smear, it is the camera.
    private bool IsSharpWithoutRotation(in CameraFrame frame, Pose pose, in ImagingCommand command)
    {
        PictureView view = View;
        if (!view.IsSmeared)
            return false;
        pose.Rates = default;
        if (!TrySmear(frame.Exposure, pose, command, view.Centre, out double smear))
            return false;
        view.SmearMetres = smear;
        return !view.IsSmeared;
    }

    // The ground in the middle of what is searched moves by the speed and by the rotation, which may cancel (over a
    // point that the vehicle flies past) and has no part about the optical axis (turning above a point).
    private bool TrySmear(
        TimeSpan exposure, in Pose pose, in ImagingCommand command, GeodeticPosition centre, out double metres)
    {
        GroundProjection end = _projector.At(pose.After(exposure.ExactSeconds), command);
        bool isGround = end.TryProjectToGround(_part.Centre.X, _part.Centre.Y, out GeodeticPosition later);
        metres = isGround
            ? LocalNedFrame.IgnoringGeoid(centre).ToNed(later).HorizontalDistanceTo(NedPosition.Origin)
            : double.PositiveInfinity;
        return isGround;
    }

    private void Report(
        in TargetDetection detection, in CameraFrame frame, in Pose middle, in ImagingCommand command, byte systemId)
    {
        (double column, double row) = (detection.CentreX, detection.CentreY);
        GroundProjection projection = _projector.At(_rows.PoseOf(frame, row, middle), command);
        if (!projection.TryProjectToGround(column, row, out GeodeticPosition place)
            || !projection.TryCovariances(
                column, row, detection.Covariance,
                out HorizontalCovariance random, out HorizontalCovariance systematic))
            return;
        FindPlacesByOffset(detection, _rows.TimeOf(frame, row), place, command);
        if (!TrySide(detection, projection, out double side))
            return;
        _reports[_reportCount] = new TargetReport
        {
            SourceSystemId = systemId,
            PictureNumber = frame.Number,
            Index = _reportCount,
            Time = _rows.TimeOf(frame, row),
            Position = place,
            Covariance = random,
            SystematicCovariance = systematic,
            Sensitivity = projection.CreateSensitivity(ImmutableArray.Create(_byOffset)),
            Class = detection.Class,
            MarkerId = detection.MarkerId,
            Score = detection.Score,
            SizeMetres = side,
            CentreX = column,
            CentreY = row,
            WidthPixels = detection.WidthPixels,
            HeightPixels = detection.HeightPixels,
        };
        if (detection.Bearing is { } bearing && _projection.TryScale(column, row, out GroundScale scale))
            _reports[_reportCount].Bearing = projection.BearingOf(column, row, bearing, scale);
        _reportCount++;
    }

    // Where it would be if the time of the picture were wrong: with the poses of other times. The ground is taken to be
    // level around it.
    private void FindPlacesByOffset(
        in TargetDetection detection, TimeSpan time, GeodeticPosition place, in ImagingCommand command)
    {
        var frame = LocalNedFrame.IgnoringGeoid(place);
        for (int i = 0; i < TargetSensitivity.Offsets; i++)
        {
            double seconds = TargetSensitivity.OffsetOf(i);
            TimeSpan exposed = time - TimeSpan.FromTicks((long)Math.Round(seconds * TimeSpan.TicksPerSecond));
            _byOffset[i] = new NedVector(double.NaN, double.NaN, 0);
            if (_poses.Extrapolate(exposed, _maxExtrapolation, out Pose pose)
                    is not (PoseLookup.Known or PoseLookup.Extrapolated)
                || !_projector.At(pose, command).TryProjectToLevel(
                    detection.CentreX, detection.CentreY, place.AltitudeAmslMetres, out GeodeticPosition other))
                continue;
            NedPosition moved = frame.ToNed(other);
            _byOffset[i] = new NedVector(moved.North, moved.East, 0);
        }
    }

    private static bool TrySide(in TargetDetection detection, in GroundProjection projection, out double side)
    {
        side = detection.SideMetres;
        if (side > 0)
            return true;
        if (!projection.TryScale(detection.CentreX, detection.CentreY, out GroundScale scale))
            return false;
        side = Math.Sqrt(detection.WidthPixels * detection.HeightPixels * scale.PixelArea);
        return true;
    }
}
