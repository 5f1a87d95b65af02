using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;

namespace Rabit.Uav.ImageProcessing.Calibration;

/// <summary>
/// Finds what is wrong in the same way in all looks (mount, attitude, time, height) from many looks at standing points whose places are not
/// known: weighted least squares over biases and points together, with what was known before. For one thread, after a flight or now and
/// then; not in a unit of work.
/// </summary>
public sealed class BiasEstimator
{
    private const int MaxRounds = 15;
    private const int Biases = BiasModel.Biases;

    private readonly BiasModel _model;
    private readonly GroundProjector _projector;
    private readonly BiasOptions _options;
    private readonly double[] _priors;
    private readonly List<BiasLook> _looks = [];
    private readonly double _groundAmslMetres;
    private int _refused;

    /// <summary>Makes it.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="mount">Its mount, as it is believed to be.</param>
    /// <param name="ground">Where the ground is; flat and level.</param>
    /// <param name="options">What is known before; read now.</param>
    /// <exception cref="ArgumentException">Something is out of its range; the text names all.</exception>
    public BiasEstimator(CameraModel camera, CameraMount mount, AmslAltitude ground, BiasOptions options)
    {
        _options = (options ?? throw new ArgumentNullException(nameof(options))).Copy();
        List<string> faults = [.. (camera ?? throw new ArgumentNullException(nameof(camera))).FindFaults(),
            .. (mount ?? throw new ArgumentNullException(nameof(mount))).FindFaults(), .. _options.FindFaults()];
        if (faults.Count > 0)
            throw new ArgumentException("Bias estimation: " + string.Join("; ", faults) + ".", nameof(options));
        _model = new BiasModel(camera, mount);
        _projector = new GroundProjector(camera, mount, new ErrorBudget(), Math.PI / 36);
        _priors = _options.Sigmas();
        _groundAmslMetres = ground.Metres;
    }

    /// <summary>Takes a look.</summary>
    /// <param name="look">The look.</param>
    /// <returns>False where it is of no use: not a number, or its pixel does not show the ground. Counted.</returns>
    public bool Add(in BiasLook look)
    {
        if (!TryStart(look, out NedVector ground) || double.IsNaN(ground.North + ground.East + look.VelocityNed.North + look.VelocityNed.East + look.VelocityNed.Down))
        {
            _refused++;
            return false;
        }

        _looks.Add(look);
        return true;
    }

    /// <summary>Reckons the biases from all looks so far; null where there are none.</summary>
    public BiasEstimate? Estimate()
    {
        if (_looks.Count == 0)
            return null;
        var frame = LocalNedFrame.IgnoringGeoid(_looks[0].Position);
        double groundDown = _looks[0].Position.AltitudeAmslMetres - _groundAmslMetres;
        int[] numbers = [.. _looks.Select(l => l.Point).Distinct().OrderBy(p => p)];
        Dictionary<int, int> indexes = numbers.Select((p, i) => (p, i)).ToDictionary(p => p.p, p => p.i);
        var system = new BiasSystem(_model, _options, _priors, _looks, _looks.Select(l => indexes[l.Point]).ToArray(), frame, groundDown);
        Start(system, frame, indexes);
        for (int round = 0; round < MaxRounds && system.Step() > 1e-4; round++)
        {
        }

        double[,] covariance = system.Finish(out BiasFit fit);
        var points = new Dictionary<int, BiasPoint>();
        for (int i = 0; i < numbers.Length; i++)
        {
            int at = Biases + (2 * i);
            GeodeticPosition place = frame.ToGeodetic(new NedVector(system.Values[at], system.Values[at + 1], groundDown));
            points[numbers[i]] = new BiasPoint(
                place, new HorizontalCovariance(covariance[at, at], covariance[at, at + 1], covariance[at + 1, at + 1]), _looks.Count(l => l.Point == numbers[i]));
        }

        return new BiasEstimate(system.Values.Take(Biases).ToArray(), covariance, _priors, points, new BiasFit(fit.Looks, _refused, fit.ResidualPixels, fit.NormalisedSquare));
    }

    // Each point where its looks see it on average, as if nothing were wrong.
    private void Start(BiasSystem system, in LocalNedFrame frame, Dictionary<int, int> indexes)
    {
        var counts = new int[indexes.Count];
        foreach (BiasLook look in _looks)
        {
            int point = indexes[look.Point];
            TryStart(look, out NedVector ground);
            NedVector vehicle = frame.ToNed(look.Position);
            int at = Biases + (2 * point);
            counts[point]++;
            system.Values[at] += (vehicle.North + ground.North - system.Values[at]) / counts[point];
            system.Values[at + 1] += (vehicle.East + ground.East - system.Values[at + 1]) / counts[point];
        }
    }

    private bool TryStart(in BiasLook look, out NedVector ground)
    {
        GroundProjection projection = _projector.At(
            new Pose { Position = look.Position, Attitude = Rotation.FromEuler(look.Attitude), VelocityNed = look.VelocityNed, Rates = look.Rates },
            new Messages.ImagingCommand { CameraPitchRadians = look.GimbalPitchRadians, CameraYawRadians = look.GimbalYawRadians, GroundAltitudeAmslMetres = _groundAmslMetres });
        return projection.TryProjectToGround(look.Column, look.Row, out ground);
    }
}
