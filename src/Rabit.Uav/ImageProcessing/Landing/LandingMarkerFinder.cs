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
    /// <param name="command">Where the gimbal points, for one that does not report it.</param>
    /// <param name="observation">Where it is; only with <see cref="LandingMarkerResult.Found"/>.</param>
    public LandingMarkerResult Find(
        in CameraFrame frame, in Pose middle, in ImagingCommand command, out LandingTargetObservation observation)
    {
        observation = default;
        if (frame.Width != _camera.Width || frame.Height != _camera.Height || frame.Pixels.IsEmpty
            || frame.Pixels.Array.Length < frame.Width * frame.Height * 3)
            return LandingMarkerResult.NoPicture;
        GreyPixels.FromRgb(frame.Pixels.Array.AsSpan(0, _grey.Length * 3), _grey);
        var result = LandingMarkerResult.None;
        foreach (DetectedMarker marker in _detector.Find(_grey, frame.Width, frame.Height))
        {
            if (marker.Family != _marker.Family || marker.Id != _marker.Id)
                continue;

            // Which of two is the place to land on cannot be known.
            if (result != LandingMarkerResult.None)
                return LandingMarkerResult.SeenTwice;
            result = Locate(marker, frame, middle, command, out observation)
                ? LandingMarkerResult.Found
                : LandingMarkerResult.NotASquare;
        }

        return result;
    }

    private bool Locate(
        in DetectedMarker marker, in CameraFrame frame, in Pose middle, in ImagingCommand command,
        out LandingTargetObservation observation)
    {
        observation = default;
        Span<PicturePoint> rays = stackalloc PicturePoint[4];
        for (int i = 0; i < rays.Length; i++)
        {
            PicturePoint corner = marker.Corners[i];
            if (!_camera.TryUndistort(corner.X, corner.Y, out double x, out double y))
                return false;
            rays[i] = new PicturePoint(x, y);
        }

        double sigma = marker.CornerSigmaPixels / Math.Sqrt(_camera.FocalX * _camera.FocalY);
        if (!MarkerPoseSolver.TrySolve(rays, _marker.SideMetres, sigma, out MarkerPose marked, out _))
            return false;

        // Two poses may fit alike, but their centres are nearly the same: what is unclear is how it is tilted.
        TimeSpan time = frame.MidExposure + _camera.ReadoutOf(marker.Corners.Centre.Y);
        Pose pose = middle.After((time - middle.Time).TotalSeconds);
        GimbalAttitude gimbal = pose.Gimbal ?? new GimbalAttitude(
            new EulerAngles(Angle.Zero, command.CameraPitch, command.CameraYaw), _mount.GimbalFrame);
        CameraExtrinsics camera = _mount.At(gimbal, pose.Attitude);
        (double forward, double right, double down) = camera.BodyFromCamera.Apply(marked.X, marked.Y, marked.Z);
        BodyVector body = camera.PositionMetres + new BodyVector(forward, right, down);
        if (!body.IsFinite)
            return false;
        observation.Time = time;
        observation.PictureNumber = frame.Number;
        observation.MarkerId = marker.Id;
        observation.PositionMetres = body;
        observation.OffsetNedMetres = pose.Attitude.ToNed(body);
        return true;
    }
}
