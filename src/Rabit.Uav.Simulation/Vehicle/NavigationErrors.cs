using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// What the autopilot's estimate is wrong by. Position: a constant of about a metre on each axis, a slow walk, a
/// quick noise. Attitude and heading: a constant of some tenths of a degree (how the autopilot sits in the frame,
/// what the iron around the compass does), a quick noise.
/// </summary>
internal sealed class NavigationErrors
{
    // metres, standard deviation on each axis, never more than twice that
    private const double PositionConstant = 1.0;
    private const double WalkSigma = 0.7;          // metres
    private const double WalkSeconds = 1800;
    private const double PositionNoise = 0.3;      // metres
    private const double VelocityNoise = 0.1;      // m/s
    private const double NoiseSeconds = 0.3;
    private const double BarometerSeconds = 600;
    private const double AngleConstant = 0.7 * NedMath.RadiansPerDegree;
    private const double AngleNoise = 0.3 * NedMath.RadiansPerDegree;
    private const double AngleSeconds = 0.1;

    private readonly NedVector _positionConstant;
    private readonly EulerAngles _angleConstant;
    private readonly ColouredNoise[] _walk;
    private readonly ColouredNoise[] _position;
    private readonly ColouredNoise[] _velocity;
    private readonly ColouredNoise[] _angle;
    private readonly ColouredNoise _barometer;

    /// <param name="seed">Of the world.</param>
    /// <param name="step">Seconds.</param>
    /// <param name="barometerDriftMetres">See <see cref="SimulationOptions.BarometerDriftMetres"/>.</param>
    public NavigationErrors(long seed, double step, double barometerDriftMetres = 0)
    {
        var once = new SimulationRandom(seed, "navigation constants");
        _positionConstant = new NedVector(
            once.ModestNormal(PositionConstant), once.ModestNormal(PositionConstant),
            once.ModestNormal(PositionConstant));
        _angleConstant = EulerAngles.FromRadians(
            once.ModestNormal(AngleConstant), once.ModestNormal(AngleConstant), once.ModestNormal(AngleConstant));
        _walk = ThreeOf(new SimulationRandom(seed, "position walk"), WalkSigma, WalkSeconds, step, startsAtZero: true);
        _position = ThreeOf(new SimulationRandom(seed, "position noise"), PositionNoise, NoiseSeconds, step);
        _velocity = ThreeOf(new SimulationRandom(seed, "velocity noise"), VelocityNoise, NoiseSeconds, step);
        _barometer = new ColouredNoise(
            new SimulationRandom(seed, "barometer"), barometerDriftMetres, BarometerSeconds, step, startsAtZero: true);
        _angle = ThreeOf(new SimulationRandom(seed, "attitude noise"), AngleNoise, AngleSeconds, step);
    }

    /// <summary>The part of the position's error that changes slowly: what the vehicle is steered by, metres.</summary>
    public NedVector SteadyPosition
        => _positionConstant.Plus(Of(_walk)).Plus(new NedVector(0, 0, BarometerDown));

    /// <summary>
    /// Of that what the barometer has drifted by, metres down; the satellite receiver is not wrong by it.
    /// </summary>
    public double BarometerDown => _barometer.Value;

    /// <summary>The whole error of the reported position, metres.</summary>
    public NedVector EstimatedPosition => SteadyPosition.Plus(Of(_position));

    /// <summary>The error of the reported velocity, m/s.</summary>
    public NedVector EstimatedVelocity => Of(_velocity);

    /// <summary>The error of the reported attitude.</summary>
    public EulerAngles EstimatedAttitude => EulerAngles.FromRadians(
        _angleConstant.Roll.Radians + _angle[0].Value,
        _angleConstant.Pitch.Radians + _angle[1].Value,
        _angleConstant.Yaw.Radians + _angle[2].Value);

    public void Step()
    {
        _barometer.Step();
        for (int axis = 0; axis < 3; axis++)
        {
            _walk[axis].Step();
            _position[axis].Step();
            _velocity[axis].Step();
            _angle[axis].Step();
        }
    }

    private static NedVector Of(ColouredNoise[] three) => new(three[0].Value, three[1].Value, three[2].Value);

    private static ColouredNoise[] ThreeOf(
        SimulationRandom random, double sigma, double seconds, double step, bool startsAtZero = false)
        => [new(random, sigma, seconds, step, startsAtZero), new(random, sigma, seconds, step, startsAtZero),
            new(random, sigma, seconds, step, startsAtZero)];
}
