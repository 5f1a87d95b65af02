using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// What a kept picture says of itself: the camera and its pose in the middle of the exposure, as a photo of a drone
/// says it.
/// </summary>
internal static class PictureMetadata
{
    private const string Maker = "Rabit";

    // From the axes of the gimbal (along the optical axis, right, down) to those of the camera.
    private static readonly Rotation GimbalFromCamera = Rotation.FromQuaternion(1, 1, 1, 1);

    /// <param name="camera">Pinhole and lens.</param>
    /// <param name="projection">Of the middle row.</param>
    /// <param name="groundAltitudeMetres">
    /// Above mean sea level, where the middle of the picture shows no ground.
    /// </param>
    /// <param name="takenUtc">The middle of the exposure.</param>
    public static PhotoMetadata Of(
        CameraModel camera, in GroundProjection projection, double groundAltitudeMetres, DateTimeOffset takenUtc)
    {
        (GeodeticPosition position, Rotation nedFromCamera) = projection.CameraPose();
        EulerAngles gimbal = (nedFromCamera * GimbalFromCamera.Inverse).ToEuler();
        double altitude = position.AltitudeAmslMetres;
        double ground = projection.TryProjectToGround(camera.CentreX, camera.CentreY, out GeodeticPosition centre)
            ? centre.AltitudeAmslMetres
            : groundAltitudeMetres;
        return new PhotoMetadata
        {
            Make = Maker,
            TakenLocal = takenUtc.UtcDateTime,
            UtcOffset = TimeSpan.Zero,
            PositionTimeUtc = takenUtc,
            PixelWidth = camera.Width,
            PixelHeight = camera.Height,
            LatitudeDegrees = position.Latitude.Degrees,
            LongitudeDegrees = position.Longitude.Degrees,
            AltitudeAmslMetres = altitude,
            AbsoluteAltitudeMetres = altitude,
            RelativeAltitudeMetres = altitude - ground,
            GimbalRollDegrees = gimbal.Roll.Degrees,
            GimbalPitchDegrees = gimbal.Pitch.Degrees,
            GimbalYawDegrees = gimbal.Yaw.Degrees,
            FocalLengthPixels = Math.Sqrt(camera.FocalX * camera.FocalY),
            FocalLength35MillimetreEquivalentMillimetres =
                36 * Math.Sqrt(camera.FocalX * camera.FocalY) / Math.Max(camera.Width, camera.Height),
            Lens = LensOf(camera),
        };
    }

    // What five numbers cannot say is left out: such a picture says that it is of a pinhole.
    private static PhotoLens? LensOf(CameraModel camera)
        => camera.Lens != LensModel.BrownConrady || camera.K4 != 0 || camera.K5 != 0 || camera.K6 != 0
            ? null
            : new PhotoLens
            {
                FocalX = camera.FocalX,
                FocalY = camera.FocalY,
                CentreOffsetX = camera.CentreX - ((camera.Width - 1) / 2.0),
                CentreOffsetY = camera.CentreY - ((camera.Height - 1) / 2.0),
                K1 = camera.K1,
                K2 = camera.K2,
                P1 = camera.P1,
                P2 = camera.P2,
                K3 = camera.K3,
            };
}
