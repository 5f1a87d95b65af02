using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing.Calibration;

/// <summary>
/// Calibration: finds what is wrong in the same way in all observations (mount, attitude, time, height) from many
/// observations of static points whose places are not known, by weighted least squares over biases and points together,
/// with a prior for each bias. For one thread, after a flight or now and then; not in a unit of work.
/// </summary>
public sealed class BiasEstimator
{
    private const int MaxRounds = 15;
    private const int Biases = BiasModel.Biases;

    private readonly BiasModel _model;
    private readonly GroundProjector _projector;
    private readonly BiasOptions _options;
    private readonly double[] _priors;
    private readonly List<BiasObservation> _observations = [];
    private readonly double _groundAmslMetres;
    private int _refused;

    /// <summary>Makes it.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="mount">Its mount, as far as it is known.</param>
    /// <param name="ground">Where the ground is; flat and level.</param>
    /// <param name="options">The priors and the noise; read now.</param>
    /// <exception cref="ArgumentException">Something is out of its range; the text names all.</exception>
    public BiasEstimator(CameraModel camera, CameraMount mount, AmslAltitude ground, BiasOptions options)
    {
        _options = (options ?? throw new ArgumentNullException(nameof(options))).Copy();
        List<string> faults = [.. (camera ?? throw new ArgumentNullException(nameof(camera))).FindFaults(),
            .. (mount ?? throw new ArgumentNullException(nameof(mount))).FindFaults(), .. _options.FindFaults()];
        if (faults.Count > 0)
            throw new ArgumentException("Bias estimation: " + string.Join("; ", faults) + ".", nameof(options));
        _model = new BiasModel(camera, mount);
        _projector = new GroundProjector(camera, mount, new ErrorBudget(), Angle.FromDegrees(5));
        _priors = _options.Sigmas();
        _groundAmslMetres = ground.Metres;
    }

    /// <summary>Takes an observation.</summary>
    /// <param name="observation">The observation.</param>
    /// <returns>False where it is of no use: not a number, or its pixel does not show the ground. Counted.</returns>
    public bool Add(in BiasObservation observation)
    {
        if (!TryStart(observation, out NedPosition ground) || !ground.IsFinite || !observation.VelocityNed.IsFinite)
        {
            _refused++;
            return false;
        }

        _observations.Add(observation);
        return true;
    }

    /// <summary>Estimates the biases from all observations so far; null where there are none.</summary>
    public BiasEstimate? Estimate()
    {
        if (_observations.Count == 0)
            return null;
        var frame = LocalNedFrame.IgnoringGeoid(_observations[0].Position);
        double groundDown = _observations[0].Position.AltitudeAmslMetres - _groundAmslMetres;
        int[] numbers = [.. _observations.Select(o => o.Point).Distinct().OrderBy(p => p)];
        Dictionary<int, int> indexes = numbers.Select((p, i) => (p, i)).ToDictionary(p => p.p, p => p.i);
        int[] pointOf = _observations.Select(o => indexes[o.Point]).ToArray();
        var system = new BiasSystem(_model, _options, _priors, _observations, pointOf, frame, groundDown);
        Start(system, frame, indexes);
        for (int round = 0; round < MaxRounds && system.Step() > 1e-4; round++)
        {
        }

        double[,] covariance = system.Finish(out BiasFit fit);
        var points = new Dictionary<int, BiasPoint>();
        for (int i = 0; i < numbers.Length; i++)
        {
            int at = Biases + (2 * i);
            GeodeticPosition place = frame.ToGeodetic(
                new NedPosition(system.Values[at], system.Values[at + 1], groundDown));
            points[numbers[i]] = new BiasPoint(
                place, new HorizontalCovariance(covariance[at, at], covariance[at, at + 1], covariance[at + 1, at + 1]),
                _observations.Count(o => o.Point == numbers[i]));
        }

        return new BiasEstimate(
            system.Values.Take(Biases).ToArray(), covariance, _priors, points, fit with { Refused = _refused });
    }

    // Each point where its observations see it on average, as if nothing were wrong.
    private void Start(BiasSystem system, in LocalNedFrame frame, Dictionary<int, int> indexes)
    {
        var counts = new int[indexes.Count];
        foreach (BiasObservation observation in _observations)
        {
            int point = indexes[observation.Point];
            TryStart(observation, out NedPosition ground);
            NedPosition vehicle = frame.ToNed(observation.Position);
            int at = Biases + (2 * point);
            counts[point]++;
            system.Values[at] += (vehicle.North + ground.North - system.Values[at]) / counts[point];
            system.Values[at + 1] += (vehicle.East + ground.East - system.Values[at + 1]) / counts[point];
        }
    }

    private bool TryStart(in BiasObservation observation, out NedPosition ground)
    {
        GroundProjection projection = _projector.At(
            new Pose
            {
                Position = observation.Position,
                Attitude = Rotation.FromEuler(observation.Attitude),
                VelocityNed = observation.VelocityNed,
                Rates = observation.Rates,
            },
            new ImagingCommand
            {
                CameraPitch = observation.GimbalPitch,
                CameraYaw = observation.GimbalYaw,
                GroundAltitudeAmslMetres = _groundAmslMetres,
            });
        return projection.TryProjectToGround(observation.Column, observation.Row, out ground);
    }
}
