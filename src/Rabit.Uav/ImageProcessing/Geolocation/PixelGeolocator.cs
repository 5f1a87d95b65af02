using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing.Geolocation;

/// <summary>
/// Tells where on the ground single pixels are, from poses as the autopilot tells them and a camera: the chain of Image Processing
/// without its manager. For one thread; fixed memory.
/// </summary>
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
        _options = (options ?? throw new ArgumentNullException(nameof(options))).ValidatedCopy(hasCamera: true, nameof(options));
        _camera = _options.Camera!;
        _projector = new GroundProjector(_camera, _options.Mount, _options.Errors, _options.MinDepressionRadians, _options.Terrain);
        _poses = new PoseHistory(_options.MaxPoseGap);
    }

    /// <summary>Samples that were not used: not a number, of a moment that was there already, or too old.</summary>
    public long RefusedSamples => _poses.Refused;

    /// <summary>Takes a position or an attitude.</summary>
    /// <param name="sample">As the autopilot told it.</param>
    public void Add(in PoseSample sample) => _poses.Add(sample);

    /// <summary>Where a pixel is on the ground.</summary>
    /// <param name="middleOfExposure">Of the first row, by the clock of the poses.</param>
    /// <param name="order">Where the gimbal looks and how high the ground is; its height is not used where there is terrain.</param>
    /// <param name="column">The centre of the top left pixel is 0.</param>
    /// <param name="row">The centre of the top left pixel is 0.</param>
    public GeolocationResult Locate(TimeSpan middleOfExposure, in ImagingCommand order, double column, double row)
    {
        var fix = new GeolocationResult { Time = middleOfExposure };
        if (!(column >= -0.5 && column <= _camera.Width - 0.5 && row >= -0.5 && row <= _camera.Height - 0.5))
            return Refuse(fix, GeolocationError.OutsidePicture);
        fix.Time += _camera.ReadoutOf(row);
        PoseLookup answer = _poses.Extrapolate(fix.Time, _options.MaxExtrapolation, out Pose pose);
        if (answer is not (PoseLookup.Known or PoseLookup.Extrapolated))
            return Refuse(fix, answer switch { PoseLookup.TooOld => GeolocationError.PoseTooOld, PoseLookup.Gap => GeolocationError.PoseGap, _ => GeolocationError.NoPose });
        fix.Extrapolated = TimeSpan.FromTicks((long)(pose.ExtrapolatedSeconds * TimeSpan.TicksPerSecond));
        GroundProjection projection = _projector.At(pose, order);
        GeolocationError refusal = projection.Locate(column, row, out NedVector _);
        if (refusal != GeolocationError.None)
            return Refuse(fix, refusal);
        if (!projection.TryProjectToGround(column, row, out GeodeticPosition place)
            || !projection.TryCovariances(column, row, out HorizontalCovariance random, out HorizontalCovariance systematic))
            return Refuse(fix, GeolocationError.NearHorizon);
        (fix.Position, fix.Covariance, fix.SystematicCovariance) = (place, random, systematic);
        return fix;
    }

    private static GeolocationResult Refuse(GeolocationResult fix, GeolocationError why)
    {
        fix.Refusal = why;
        return fix;
    }
}
