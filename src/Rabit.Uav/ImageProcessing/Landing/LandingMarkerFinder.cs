using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Finds the marker of the place to land on in a picture, and where it is from the vehicle, by its four corners and its
/// known side: no height above ground is needed. Allocates nothing after the fullest picture; for one thread.
/// </summary>
internal sealed class LandingMarkerFinder
{
    internal const string NoPicture = "the picture is not of the camera's size";
    internal const string SeenTwice = "the landing marker is twice in the picture";
    internal const string NotASquare = "the corners of the landing marker are none of a square in front of the camera";
    internal const string NoDirection = "where the camera points is not known: the gimbal does not report it, no mission "
        + "points it, and the camera's mount is not fixed";

    private readonly LandingMarkerOptions _marker;
    private readonly CameraModel _camera;
    private readonly CameraMount _mount;
    private readonly MarkerDetector _detector;
    private readonly byte[] _grey;

    /// <param name="marker">Checked.</param>
    /// <param name="camera">Checked.</param>
    /// <param name="mount">Checked.</param>
    public LandingMarkerFinder(LandingMarkerOptions marker, CameraModel camera, CameraMount mount)
    {
        (_marker, _camera, _mount) = (marker, camera, mount);
        _detector = new MarkerDetector(new MarkerDetectorOptions { Families = [marker.Family] });
        _grey = new byte[camera.Width * camera.Height];
    }

    /// <summary>Looks for it.</summary>
    /// <param name="frame">The picture.</param>
    /// <param name="middle">The pose at the exposure of the middle row.</param>
    /// <param name="command">
    /// Where the gimbal points, for one that does not report it; null where it was not pointed.
    /// </param>
    /// <param name="observation">Where it is.</param>
    /// <param name="refusal">Why that is not known although it was seen, or could not be looked for.</param>
    /// <returns>Whether it was found; where not, and there is no refusal, it is not in the picture.</returns>
    public bool TryFind(
        in CameraFrame frame, in Pose middle, in ImagingCommand? command, out LandingTargetObservation observation,
        out string? refusal)
    {
        observation = default;
        if (frame.Width != _camera.Width || frame.Height != _camera.Height || frame.Pixels.IsEmpty
            || frame.Format != PixelFormat.Rgb24
            || frame.Pixels.Array.Length < frame.Width * frame.Height * 3)
        {
            refusal = NoPicture;
            return false;
        }

        GreyPixels.FromRgb(frame.Pixels.Array.AsSpan(0, _grey.Length * 3), _grey);
        DetectedMarker? seen = null;
        foreach (DetectedMarker marker in _detector.Find(_grey, frame.Width, frame.Height))
        {
            if (marker.Family != _marker.Family || marker.Id != _marker.Id)
                continue;

            // Which of two is the place to land on cannot be known.
            if (seen is not null)
            {
                refusal = SeenTwice;
                return false;
            }

            seen = marker;
        }

        refusal = seen is { } found ? Locate(found, frame, middle, command, ref observation) : null;
        return seen is not null && refusal is null;
    }

    // Gives why it cannot be located; null where it can.
    private string? Locate(
        in DetectedMarker marker, in CameraFrame frame, in Pose middle, in ImagingCommand? command,
        ref LandingTargetObservation observation)
    {
        Span<PicturePoint> rays = stackalloc PicturePoint[4];
        for (int i = 0; i < rays.Length; i++)
        {
            PicturePoint corner = marker.Corners[i];
            if (!_camera.TryUndistort(corner.X, corner.Y, out double x, out double y))
                return NotASquare;
            rays[i] = new PicturePoint(x, y);
        }

        double sigma = marker.CornerSigmaPixels / Math.Sqrt(_camera.FocalX * _camera.FocalY);
        if (!MarkerPoseSolver.TrySolve(rays, _marker.SideMetres, sigma, out MarkerPose marked, out _))
            return NotASquare;

        // Two poses may fit alike, but their centres are nearly the same: what is unclear is how it is tilted.
        TimeSpan time = frame.MidExposure + _camera.ReadoutOf(marker.Corners.Centre.Y);
        Pose pose = middle.After((time - middle.Time).ExactSeconds);
        if (!TryDirect(pose, command, out CameraExtrinsics camera))
            return NoDirection;
        (double forward, double right, double down) = camera.BodyFromCamera.Apply(marked.X, marked.Y, marked.Z);
        BodyVector body = camera.PositionMetres + new BodyVector(forward, right, down);
        if (!body.IsFinite)
            return NotASquare;
        observation.Time = time;
        observation.PictureNumber = frame.Number;
        observation.MarkerId = marker.Id;
        observation.PositionMetres = body;
        observation.OffsetNedMetres = pose.Attitude.ToNed(body);
        return null;
    }

    private bool TryDirect(in Pose pose, in ImagingCommand? command, out CameraExtrinsics camera)
    {
        camera = default;
        GimbalAttitude gimbal = default;
        if (pose.Gimbal is { } reported)
            gimbal = reported;
        else if (command is { } pointed)
            gimbal = pointed.Pointing(_mount.GimbalFrame);
        else if (_mount.FixedBodyFromCamera is null)
            return false;
        camera = _mount.At(gimbal, pose.Attitude);
        return true;
    }
}
