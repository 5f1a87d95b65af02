using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Searches one picture whose pose is known: which ground it shows, what looks like a target in it, where that stands. The results stay
/// until the next picture. Fixed memory; for one thread.
/// </summary>
internal sealed class PictureSearch
{
    public const string WrongSize = "the picture is not of the size that the camera is to have";
    public const string NoBuffer = "the picture has no buffer, or one that is too small";
    public const string NotGround = "a corner of the picture does not show the ground";
    public const string TooManySpots = "the picture shows too many coloured spots to be searched";

    private readonly CameraModel _camera;
    private readonly Detector _detector;
    private readonly GroundProjector _projector;
    private readonly PoseHistory _poses;
    private readonly TimeSpan _maxExtrapolation;
    private readonly TargetReport[] _reports;
    private int _reportCount;
    private CameraObservation _look;

    /// <param name="options">Checked.</param>
    /// <param name="camera">Of the options.</param>
    /// <param name="poses">Where the poses of single rows come from, with a rolling shutter.</param>
    public PictureSearch(ImageProcessingOptions options, CameraModel camera, PoseHistory poses)
    {
        _camera = camera;
        _poses = poses;
        _maxExtrapolation = options.MaxExtrapolation;
        _detector = new Detector(options);
        _projector = new GroundProjector(camera, options.Mount, options.Errors, options.MinDepression, options.Terrain);
        _reports = new TargetReport[options.MaxReportsPerPicture];
    }

    /// <summary>The reports of the last picture, the surest first.</summary>
    public ReadOnlySpan<TargetReport> Reports => new(_reports, 0, _reportCount);

    /// <summary>Which ground the last picture showed.</summary>
    public ref readonly CameraObservation Look => ref _look;

    /// <summary>Targets of the last picture beyond the most that are reported.</summary>
    public int Cut => _detector.Cut;

    /// <summary>Searches a picture.</summary>
    /// <param name="frame">The picture.</param>
    /// <param name="pose">At the middle of the exposure of the middle row.</param>
    /// <param name="order">What to look for, and where the camera points.</param>
    /// <param name="systemId">Who looks.</param>
    /// <returns>Why it could not be searched; null if it was.</returns>
    public string? Search(in CameraFrame frame, in Pose pose, in ImagingCommand order, byte systemId)
    {
        _reportCount = 0;
        if (frame.Width != _camera.Width || frame.Height != _camera.Height)
            return WrongSize;
        if (frame.Pixels.IsEmpty || frame.Pixels.Array.Length < frame.Width * frame.Height * 3)
            return NoBuffer;
        if (!TryFindCorners(frame, pose, order))
            return NotGround;
        if (!_detector.TrySearch(frame.Pixels.Array, frame.Width, frame.Height, order.Colours, _projector.At(pose, order)))
            return TooManySpots;
        foreach (ref readonly Detection found in _detector.Found)
            Report(found, frame, pose, order, systemId);
        _look.SourceSystemId = systemId;
        _look.Number = frame.Number;
        _look.Time = pose.Time;
        _look.Reports = _reportCount;
        return null;
    }

    private bool TryFindCorners(in CameraFrame frame, in Pose pose, in ImagingCommand order)
    {
        double right = _camera.Width - 1;
        double bottom = _camera.Height - 1;
        GroundProjection top = _projector.At(PoseOfRow(frame, 0, pose), order);
        if (!top.TryProjectToGround(0, 0, out GeodeticPosition topLeft) || !top.TryProjectToGround(right, 0, out GeodeticPosition topRight))
            return false;
        GroundProjection last = _projector.At(PoseOfRow(frame, bottom, pose), order);
        if (!last.TryProjectToGround(right, bottom, out GeodeticPosition bottomRight) || !last.TryProjectToGround(0, bottom, out GeodeticPosition bottomLeft))
            return false;
        (_look.TopLeft, _look.TopRight, _look.BottomRight, _look.BottomLeft) = (topLeft, topRight, bottomRight, bottomLeft);
        return true;
    }

    private TimeSpan TimeOfRow(in CameraFrame frame, double row) => frame.MidExposure + _camera.ReadoutOf(row);

    // The caller made sure that there are poses around all rows; where they are extrapolated, the last rows may lie a little beyond,
    // and go on from the middle one.
    private Pose PoseOfRow(in CameraFrame frame, double row, in Pose middle)
    {
        Pose pose = middle;
        TimeSpan time = TimeOfRow(frame, row);
        if (_camera.RowReadout > TimeSpan.Zero
            && _poses.Extrapolate(time, _maxExtrapolation, out pose) is not (PoseLookup.Known or PoseLookup.Extrapolated))
        {
            pose = middle.After((time - middle.Time).TotalSeconds);
            pose.ExtrapolatedSeconds = Math.Max(0, middle.ExtrapolatedSeconds + (time - middle.Time).TotalSeconds);
        }

        return pose;
    }

    private void Report(in Detection found, in CameraFrame frame, in Pose middle, in ImagingCommand order, byte systemId)
    {
        GroundProjection projection = _projector.At(PoseOfRow(frame, found.CentreY, middle), order);
        if (!projection.TryProjectToGround(found.CentreX, found.CentreY, out GeodeticPosition place)
            || !projection.TryCovariances(found.CentreX, found.CentreY, out HorizontalCovariance random, out HorizontalCovariance systematic))
            return;
        _reports[_reportCount] = new TargetReport
        {
            SourceSystemId = systemId,
            PictureNumber = frame.Number,
            Index = _reportCount,
            Time = TimeOfRow(frame, found.CentreY),
            Position = place,
            Covariance = random,
            SystematicCovariance = systematic,
            Colour = found.Colour,
            Score = found.Score,
            SizeMetres = found.SideMetres,
            CentreX = found.CentreX,
            CentreY = found.CentreY,
        };
        _reportCount++;
    }
}
