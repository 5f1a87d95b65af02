using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;

namespace Rabit.Benchmarks.Uav;

/// <summary>A camera that looks down from 40 m.</summary>
internal static class NadirView
{
    private static readonly CameraModel Camera = new()
    {
        Width = 640,
        Height = 480,
        FocalX = 530,
        FocalY = 530,
        CentreX = 321.2,
        CentreY = 237.4,
        K1 = -0.06,
        K2 = 0.015,
        P1 = 0.0003,
        P2 = -0.0002,
    };

    public static GroundProjection CreateProjection()
    {
        var projector = new GroundProjector(Camera, new CameraMount(), new ErrorBudget(), Angle.FromDegrees(5));
        return projector.At(
            new Pose
            {
                Position = GeodeticPosition.FromRadians(0.84, 0.15, 485),
                Attitude = Rotation.FromEuler(EulerAngles.FromRadians(0.05, -0.08, 1))
            },
            new ImagingCommand { CameraPitch = Angle.FromDegrees(-90), GroundAltitudeAmslMetres = 445 });
    }
}
