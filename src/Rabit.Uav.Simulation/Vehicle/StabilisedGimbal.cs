using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Holds roll and pitch of the camera against the horizon, and the yaw against the vehicle's heading or north. The
/// vehicle's turns drag it along for a moment, and it trembles; both are in what it reports, with the errors of its own
/// sense of the horizon.
/// </summary>
internal sealed class StabilisedGimbal : Gimbal
{
    // A turn of 30 degrees a second drags it by 0.6 degrees.
    private const double LagSeconds = 0.02;
    private const double FollowSeconds = 0.25;   // until two thirds of a change of the heading are followed
    private const double TremorSigma = 0.1 * NedMath.RadiansPerDegree;
    private const double TremorSeconds = 0.2;
    private const double HorizonSigma = 0.2 * NedMath.RadiansPerDegree;   // constant for a flight, at most twice that
    private const double ReportSigma = 0.05 * NedMath.RadiansPerDegree;
    private const double ReportSeconds = 0.1;

    private readonly GimbalFrame _frame;
    private readonly Axis _yaw;
    private readonly Axis _roll;
    private readonly Axis _pitch;
    private double _heading;
    private double _lastHeading;
    private double _northError;

    public StabilisedGimbal(
        long seed, GimbalFrame frame, double heading, double stepSeconds, double pitch = -Math.PI / 2, double yaw = 0)
        : base(pitch, yaw)
    {
        _frame = frame;
        _heading = _lastHeading = heading;
        var random = new SimulationRandom(seed, "gimbal");
        double follow = frame == GimbalFrame.Heading ? FollowSeconds : LagSeconds;
        (_yaw, _roll, _pitch) = (new Axis(random, follow, stepSeconds), new Axis(random, LagSeconds, stepSeconds),
            new Axis(random, LagSeconds, stepSeconds));
    }

    /// <inheritdoc/>
    public override GimbalAngles Angles => new(_frame, Yaw + _yaw.Off, _roll.Off, Pitch + _pitch.Off);

    /// <inheritdoc/>
    public override GimbalAngles Reported => new(
        _frame, Yaw + _yaw.Off + _yaw.ReportError + _northError, _roll.Off + _roll.ReportError,
        Pitch + _pitch.Off + _pitch.ReportError);

    /// <inheritdoc/>
    public override void Step(EulerAngles vehicle, BodyRates rates, Angle yawError, double seconds)
    {
        base.Step(vehicle, rates, yawError, seconds);
        _heading = vehicle.Yaw.Radians;
        bool isNorth = _frame == GimbalFrame.North;
        _northError = isNorth ? yawError.Radians : 0;

        // The vehicle's leaning, about the camera's axes.
        double yaw = isNorth ? Yaw - _heading : Yaw;
        (double sin, double cos) = (Trig.Sin(yaw), Trig.Cos(yaw));
        _roll.Step(seconds * ((rates.RollRadiansPerSecond * cos) + (rates.PitchRadiansPerSecond * sin)));
        _pitch.Step(seconds * ((rates.PitchRadiansPerSecond * cos) - (rates.RollRadiansPerSecond * sin)));

        // Seen from a heading that it follows, it is what stays behind.
        double turn = NedMath.Wrapped(_heading - _lastHeading);
        _yaw.Step(isNorth ? turn : -turn);
        _lastHeading = _heading;
    }

    /// <inheritdoc/>
    protected override double YawOf(double yaw, bool isFromNorth)
        => isFromNorth == (_frame == GimbalFrame.North) ? yaw : isFromNorth ? yaw - _heading : yaw + _heading;

    private sealed class Axis
    {
        private readonly ColouredNoise _tremor;
        private readonly ColouredNoise _report;
        private readonly double _horizon;
        private readonly double _kept;
        private double _dragged;

        public Axis(SimulationRandom random, double lagSeconds, double stepSeconds)
        {
            _tremor = new ColouredNoise(random, TremorSigma, TremorSeconds, stepSeconds);
            _report = new ColouredNoise(random, ReportSigma, ReportSeconds, stepSeconds);
            _horizon = random.ModestNormal(HorizonSigma);
            _kept = Math.Exp(-stepSeconds / lagSeconds);
        }

        /// <summary>How far the camera really is from where it is to be, radians.</summary>
        public double Off => _dragged + _tremor.Value;

        /// <summary>What the report is wrong by, radians.</summary>
        public double ReportError => _horizon + _report.Value;

        public void Step(double turn)
        {
            _dragged = (_kept * _dragged) + turn;
            _tremor.Step();
            _report.Step();
        }
    }
}
