using System;
using Rabit.Uav.Geometry;
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
    private readonly Locator _locator;
    private readonly TargetReport[] _reports;
    private int _reportCount;
    private CameraLook _look;

    public PictureSearch(ImageProcessingOptions options, CameraModel camera)
    {
        _camera = camera;
        _detector = new Detector(options);
        _locator = new Locator(camera, options.Mount, options.Errors, options.MinimumDepressionRadians, options.Terrain);
        _reports = new TargetReport[options.MaximumReportsPerPicture];
    }

    /// <summary>The reports of the last picture, the surest first.</summary>
    public ReadOnlySpan<TargetReport> Reports => new(_reports, 0, _reportCount);

    /// <summary>Which ground the last picture showed.</summary>
    public ref readonly CameraLook Look => ref _look;

    /// <summary>Targets of the last picture beyond the most that are reported.</summary>
    public int Cut => _detector.Cut;

    /// <summary>Searches a picture.</summary>
    /// <returns>Why it could not be searched; null if it was.</returns>
    public string? Search(in CameraFrame frame, in Pose pose, in ImagingOrder order, byte systemId)
    {
        _reportCount = 0;
        if (frame.Width != _camera.Width || frame.Height != _camera.Height)
            return WrongSize;
        if (frame.Pixels.IsEmpty || frame.Pixels.Array.Length < frame.Width * frame.Height * 3)
            return NoBuffer;
        _locator.Aim(pose, order);
        if (!TryFindCorners())
            return NotGround;
        if (!_detector.TrySearch(frame.Pixels.Array, frame.Width, frame.Height, order.Colours, _locator))
            return TooManySpots;
        foreach (ref readonly Detection found in _detector.Found)
            Report(found, frame, systemId);
        _look.SourceSystemId = systemId;
        _look.Number = frame.Number;
        _look.Time = frame.MidExposure;
        _look.Reports = _reportCount;
        return null;
    }

    private bool TryFindCorners()
    {
        double right = _camera.Width - 1;
        double bottom = _camera.Height - 1;
        if (!_locator.TryLocate(0, 0, out GeodeticPosition topLeft) || !_locator.TryLocate(right, 0, out GeodeticPosition topRight)
            || !_locator.TryLocate(right, bottom, out GeodeticPosition bottomRight) || !_locator.TryLocate(0, bottom, out GeodeticPosition bottomLeft))
            return false;
        (_look.TopLeft, _look.TopRight, _look.BottomRight, _look.BottomLeft) = (topLeft, topRight, bottomRight, bottomLeft);
        return true;
    }

    private void Report(in Detection found, in CameraFrame frame, byte systemId)
    {
        if (!_locator.TryLocate(found.CentreX, found.CentreY, out GeodeticPosition place)
            || !_locator.TryCovariances(found.CentreX, found.CentreY, out HorizontalCovariance perLook, out HorizontalCovariance common))
            return;
        _reports[_reportCount] = new TargetReport
        {
            SourceSystemId = systemId,
            LookNumber = frame.Number,
            Index = _reportCount,
            Time = frame.MidExposure,
            Position = place,
            Covariance = perLook,
            CommonCovariance = common,
            Colour = found.Colour,
            Score = found.Score,
            SizeMetres = found.SideMetres,
            CentreX = found.CentreX,
            CentreY = found.CentreY,
        };
        _reportCount++;
    }
}
