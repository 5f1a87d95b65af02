using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing.Geolocation;

/// <summary>
/// Geolocation of single pixels (direct georeferencing): where on the ground they are, with their covariance, from
/// poses as the autopilot reports them and a camera. The chain of Image Processing without its manager. For one thread;
/// fixed memory.
/// </summary>
/// <example>
/// <code>
/// var geolocator = new PixelGeolocator(new ImageProcessingOptions { Camera = camera, Mount = mount });
/// geolocator.Add(positionSample);
/// geolocator.Add(attitudeSample);
/// var command = new ImagingCommand { CameraPitch = Angle.FromDegrees(-90), GroundAltitudeAmslMetres = 440 };
/// GeolocationResult result = geolocator.Locate(TimeSpan.FromSeconds(10), command, column: 320, row: 240);
/// if (result.Error == GeolocationError.None)
///     Console.WriteLine($"{result.Position}, 95 % within {result.Covariance.HalfMajorAxis95Metres} m");
/// </code>
/// </example>
public sealed class PixelGeolocator
{
    private readonly ImageProcessingOptions _options;
    private readonly CameraModel _camera;
    private readonly GroundProjector _projector;
    private readonly PoseHistory _poses;

    /// <summary>Makes it.</summary>
    /// <param name="options">Camera, mount, errors, terrain and limits; read now.</param>
    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    public PixelGeolocator(ImageProcessingOptions options)
    {
        _options = (options ?? throw new ArgumentNullException(nameof(options)))
            .ValidatedCopy(hasCamera: true, nameof(options));
        _camera = _options.Camera!;
        _projector = new GroundProjector(
            _camera, _options.Mount, _options.Errors, _options.MinDepression, _options.Terrain);
        _poses = new PoseHistory(_options.MaxPoseGap, usesGimbal: _options.Mount.FixedBodyFromCamera is null);
    }

    /// <summary>Samples that were not used: not a number, of a moment that was there already, or too old.</summary>
    public long RefusedSamples => _poses.Refused;

    /// <summary>Takes a position, an attitude or a gimbal's attitude.</summary>
    /// <param name="sample">As the autopilot reported it.</param>
    public void Add(in PoseSample sample) => _poses.Add(sample);

    /// <summary>Where a pixel is on the ground.</summary>
    /// <param name="middleOfExposure">Of the first row, by the clock of the poses.</param>
    /// <param name="command">
    /// Where the gimbal points, unless it reported that itself, and how high the ground is; its height is not used
    /// where there is terrain.
    /// </param>
    /// <param name="column">The centre of the top left pixel is 0.</param>
    /// <param name="row">The centre of the top left pixel is 0.</param>
    public GeolocationResult Locate(TimeSpan middleOfExposure, in ImagingCommand command, double column, double row)
    {
        var result = new GeolocationResult { Time = middleOfExposure };
        if (!(column >= -0.5 && column <= _camera.Width - 0.5 && row >= -0.5 && row <= _camera.Height - 0.5))
            return Refuse(result, GeolocationError.OutsidePicture);
        result.Time += _camera.ReadoutOf(row);
        PoseLookup answer = _poses.Extrapolate(result.Time, _options.MaxExtrapolation, out Pose pose);
        if (answer is not (PoseLookup.Known or PoseLookup.Extrapolated))
            return Refuse(result, ErrorOf(answer));
        result.Extrapolated = TimeSpan.FromTicks((long)(pose.ExtrapolatedSeconds * TimeSpan.TicksPerSecond));
        GroundProjection projection = _projector.At(pose, command);
        GeolocationError error = projection.Locate(column, row, out NedPosition ground);
        if (error != GeolocationError.None)
            return Refuse(result, error);
        if (!projection.TryCovariances(
            column, row, ground, out HorizontalCovariance random, out HorizontalCovariance systematic))
            return Refuse(result, GeolocationError.NearHorizon);
        (result.Position, result.Covariance, result.SystematicCovariance) =
            (projection.ToGeodetic(ground), random, systematic);
        return result;
    }

    private static GeolocationError ErrorOf(PoseLookup answer) => answer switch
    {
        PoseLookup.TooOld => GeolocationError.PoseTooOld,
        PoseLookup.Gap => GeolocationError.PoseGap,
        _ => GeolocationError.NoPose,
    };

    private static GeolocationResult Refuse(GeolocationResult result, GeolocationError why)
    {
        result.Error = why;
        return result;
    }
}
