using System;
using System.Collections.Generic;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation.Tests.Camera;

/// <summary>
/// One panel on the ground and a camera over it, without what the sensor does: where in the picture the panel is seen,
/// from the difference to a picture of the same ground without it.
/// </summary>
internal sealed class Scene
{
    private readonly SimulatedCameraOptions _options;
    private readonly LensRays _lens;
    private readonly GroundPainter _ground;
    private readonly byte[] _without;
    private readonly byte[] _with;

    public Scene(SimulatedCameraOptions? options = null)
    {
        _options = options ?? Pinhole();
        _lens = new LensRays(_options.Camera);
        _ground = new GroundPainter(_lens, new GroundTexture(seed: 3));
        _without = new byte[_options.Camera.Width * _options.Camera.Height * 3];
        _with = new byte[_without.Length];
    }

    /// <summary>The last picture, with the panel.</summary>
    public IReadOnlyList<byte> LastPicture => _with;

    public static double Degrees(double degrees) => degrees * Ground.RadiansPerDegree;

    /// <summary>320 x 240 without distortion, f 265, the optical axis at (160, 120), no lever arm.</summary>
    public static SimulatedCameraOptions Pinhole() => new()
    {
        Camera = new CameraModel
        {
            Width = 320,
            Height = 240,
            FocalX = 265,
            FocalY = 265,
            CentreX = 160,
            CentreY = 120
        },
        LeverArmForwardMetres = 0,
        LeverArmDownMetres = 0,
    };

    /// <summary>Corners of an area on the ground.</summary>
    public static NedPosition[] Corners(params (double North, double East)[] corners)
        => Array.ConvertAll(corners, c => new NedPosition(c.North, c.East, 0));

    /// <summary>A magenta panel of 1 m.</summary>
    public static SimulatedTarget Panel(double north, double east, double heading = 0, double side = 1) => new()
    {
        Class = DefaultTargetClasses.Magenta,
        Position = new NedPosition(north, east, 0),
        Heading = Angle.FromRadians(heading),
        SideMetres = side,
        WidthMetres = side,
        Surface = new SurfaceColour(212, 36, 150),
    };

    /// <summary>
    /// A pose over the origin, angles in degrees; the camera looks straight down if not set otherwise.
    /// </summary>
    public static TruePose Pose(
        double height, double roll = 0, double pitch = 0, double yaw = 0, double cameraPitch = -90,
        double cameraYaw = 0)
        => new()
        {
            Position = new NedPosition(0, 0, -height),
            Attitude = EulerAngles.FromDegrees(roll, pitch, yaw),
            CameraPitch = Angle.FromDegrees(cameraPitch),
            CameraYaw = Angle.FromDegrees(cameraYaw),
        };

    /// <summary>Where the panel is seen, and on how many pixels; pixels 0 if it is not seen.</summary>
    public (double U, double V, double Pixels) Find(in TruePose pose, SimulatedTarget panel)
        => Find(pose, pose, pose, panel);

    /// <summary>The same, where the camera moves.</summary>
    public (double U, double V, double Pixels) Find(
        in TruePose middle, in TruePose early, in TruePose late, SimulatedTarget panel)
    {
        var cameraPose = new CameraPose(middle, _options);
        var from = new CameraPose(early, _options);
        var to = new CameraPose(late, _options);
        _ground.Paint(cameraPose, _without);
        Array.Copy(_without, _with, _with.Length);
        new SheetPainter(_lens, [panel]).Paint(from, to, _with);
        return Centroid(panel);
    }

    // How much of a pixel the panel covers: how far its red, in which a magenta panel and the ground differ most, has
    // gone from one to the other.
    private (double U, double V, double Pixels) Centroid(SimulatedTarget panel)
    {
        (double sumU, double sumV, double sum) = (0, 0, 0);
        int width = _options.Camera.Width;
        for (int at = 0; at < _with.Length; at += 3)
        {
            double covered = (_with[at] - _without[at]) / (double)(panel.Surface.Red - _without[at]);
            (sumU, sumV, sum) =
                (sumU + (covered * (at / 3 % width)), sumV + (covered * (at / 3 / width)), sum + covered);
        }

        return sum > 0 ? (sumU / sum, sumV / sum, sum) : (0, 0, 0);
    }
}
