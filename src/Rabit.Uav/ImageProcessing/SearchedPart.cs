using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Which part of a picture is searched: what shows the ground in pixels that are small enough for the smallest target.
/// That is all of it, or what one straight line leaves of it, as of a camera that looks towards the horizon. Fixed
/// memory; for one thread.
/// </summary>
internal sealed class SearchedPart
{
    // Of the picture; a smaller part is not worth the time that searching takes.
    private const double MinShare = 0.3;

    private const int Corners = 4;   // top left, and on clockwise

    // Of the diagonal of a picture: to a pixel.
    private const int Halvings = 11;

    private readonly CameraModel _camera;
    private readonly GroundProjector _projector;
    private readonly RowPoses _rows;
    private readonly bool[] _isSearched = new bool[Corners];
    private readonly PicturePoint[] _corners = new PicturePoint[Corners];
    private CameraFrame _frame;
    private Pose _pose;
    private ImagingCommand _command;
    private bool _isOnePose;
    private double _maxPixelArea;

    public SearchedPart(CameraModel camera, GroundProjector projector, RowPoses rows)
        => (_camera, _projector, _rows) = (camera, projector, rows);

    /// <summary>Whether it is the whole picture.</summary>
    public bool IsWhole { get; private set; }

    /// <summary>Whether all corners of the picture show the ground.</summary>
    public bool IsGround { get; private set; }

    /// <summary>The middle of the picture, where that is searched, or else the one of the part.</summary>
    public PicturePoint Centre { get; private set; }

    private PicturePoint CentreOfPicture => new(_camera.CentreX, _camera.CentreY);

    /// <summary>Finds it.</summary>
    /// <param name="frame">The picture.</param>
    /// <param name="pose">At the middle of the exposure of the middle row.</param>
    /// <param name="command">Where the camera points.</param>
    /// <param name="maxSamplingMetres">The largest side of a pixel on the ground.</param>
    /// <returns>False where too little of the picture is left.</returns>
    public bool TryFind(in CameraFrame frame, in Pose pose, in ImagingCommand command, double maxSamplingMetres)
    {
        (_frame, _isOnePose) = (frame, false);
        _frame.Pixels = default;   // they may be given back before the next picture
        return TryFindAt(pose, command, maxSamplingMetres);
    }

    /// <summary>The same, were all rows exposed in one pose.</summary>
    public bool TryFind(in Pose pose, in ImagingCommand command, double maxSamplingMetres)
    {
        _isOnePose = true;
        return TryFindAt(pose, command, maxSamplingMetres);
    }

    /// <summary>Where its corners are on the ground.</summary>
    public bool TryLocate(ref CameraObservation observation)
    {
        if (!TryLocate(0, out GeodeticPosition topLeft) || !TryLocate(1, out GeodeticPosition topRight)
            || !TryLocate(2, out GeodeticPosition bottomRight) || !TryLocate(3, out GeodeticPosition bottomLeft))
            return false;
        (observation.TopLeft, observation.TopRight) = (topLeft, topRight);
        (observation.BottomRight, observation.BottomLeft) = (bottomRight, bottomLeft);
        return true;
    }

    private bool TryFindAt(in Pose pose, in ImagingCommand command, double maxSamplingMetres)
    {
        (_pose, _command, _maxPixelArea) = (pose, command, maxSamplingMetres * maxSamplingMetres);
        (IsWhole, IsGround) = (true, true);
        for (int i = 0; i < Corners; i++)
        {
            _corners[i] = CornerOfPicture(i);
            _isSearched[i] = IsSearched(_corners[i], out bool isGround);
            IsWhole &= _isSearched[i];
            IsGround &= isGround;
        }

        Centre = CentreOfPicture;
        bool isCentre = IsSearched(Centre, out _);
        if (IsWhole && isCentre)
            return true;
        IsWhole = false;
        for (int i = 0; i < Corners; i++)
        {
            if (!_isSearched[i] && !TryMove(i, isCentre))
                return false;
        }

        if (!isCentre)
            Centre = MiddleOfCorners();
        return Share() >= MinShare;
    }

    private bool TryLocate(int corner, out GeodeticPosition place)
        => ProjectionOf(_corners[corner].Y).TryProjectToGround(_corners[corner].X, _corners[corner].Y, out place);

    private PicturePoint CornerOfPicture(int corner)
        => new(corner is 1 or 2 ? _camera.Width - 1 : 0, corner >= 2 ? _camera.Height - 1 : 0);

    private GroundProjection ProjectionOf(double row)
        => _projector.At(_isOnePose ? _pose : _rows.PoseOf(_frame, row, _pose), _command);

    private bool IsSearched(PicturePoint at, out bool isGround)
    {
        GroundProjection projection = ProjectionOf(at.Y);
        isGround = projection.TryProjectToGround(at.X, at.Y, out NedPosition _);
        return isGround && (double.IsPositiveInfinity(_maxPixelArea)
            || (projection.TryScale(at.X, at.Y, out GroundScale scale) && scale.PixelArea <= _maxPixelArea));
    }

    // Towards what is searched: along a border of the picture where the line cuts off two corners, else across it.
    private bool TryMove(int corner, bool isCentre)
    {
        int across = corner ^ 1;
        int along = Corners - 1 - corner;
        int opposite = (corner + 2) % Corners;
        if (_isSearched[across] != _isSearched[along])
            Move(corner, CornerOfPicture(_isSearched[across] ? across : along));
        else if (_isSearched[across] && _isSearched[opposite])
            Move(corner, CornerOfPicture(opposite));
        else if (isCentre)
            Move(corner, CentreOfPicture);
        else
            return false;
        return true;
    }

    private void Move(int corner, PicturePoint to)
    {
        PicturePoint from = _corners[corner];
        (double outside, double inside) = (0, 1);
        for (int i = 0; i < Halvings; i++)
        {
            double part = (outside + inside) / 2;
            if (IsSearched(Between(from, to, part), out _))
                inside = part;
            else
                outside = part;
        }

        _corners[corner] = Between(from, to, inside);
    }

    private PicturePoint MiddleOfCorners()
    {
        (double x, double y) = (0, 0);
        foreach (PicturePoint corner in _corners)
            (x, y) = (x + (corner.X / Corners), y + (corner.Y / Corners));
        return new PicturePoint(x, y);
    }

    private double Share()
    {
        (PicturePoint a, PicturePoint b, PicturePoint c, PicturePoint d) =
            (_corners[0], _corners[1], _corners[2], _corners[3]);
        double doubled = ((c.X - a.X) * (d.Y - b.Y)) - ((d.X - b.X) * (c.Y - a.Y));
        return doubled / (2.0 * (_camera.Width - 1) * (_camera.Height - 1));
    }

    private static PicturePoint Between(PicturePoint from, PicturePoint to, double part)
        => new(from.X + (part * (to.X - from.X)), from.Y + (part * (to.Y - from.Y)));
}
