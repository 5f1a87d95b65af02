using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>RTL: climb to RTL_ALT if it is lower, less where home is near; fly home; wait; land.</summary>
internal sealed class ReturnFlight : FlightMode
{
    // RTL_ALT_MIN of ArduCopter: it climbs at least to 2 m.
    private const double MinHeight = 2;
    private const double HeightReached = 0.3;
    private const double HomeReached = 1;

    private readonly LandFlight _landing = new();
    private Part _part;
    private NedVector _start;
    private double _height;
    private TimeSpan _landsAt;

    private enum Part
    {
        Climb,
        Home,
        Wait,
        Land,
    }

    public override bool IsLanding => _part == Part.Land;

    public override bool DisarmsWhenLanded => true;

    /// <summary>What it flies to now; null while it lands.</summary>
    public NedVector? Target { get; private set; }

    public override void Enter(FlightSituation situation)
    {
        _part = Part.Climb;
        _start = situation.StoppingPoint;
        double slope = situation.Parameters.ReturnSlope.Value;
        double lowest = Math.Max(MinHeight, situation.Height);
        double cone = slope >= 0.5
            ? Math.Max(situation.Home.Minus(situation.Position).HorizontalLength() * slope, lowest)
            : double.MaxValue;
        _height = Math.Min(Math.Max(situation.Parameters.ReturnHeightMetres, lowest), cone);
    }

    public override void Fly(FlightSituation situation, ref MotionCommand command)
    {
        if (situation.IsLanded)
        {
            command.Motors = MotorState.Idle;
            return;
        }

        NedVector home = situation.Home;
        var above = new NedVector(home.North, home.East, home.Down - _height);
        Advance(situation, above);
        Target = _part switch
        {
            Part.Climb => new NedVector(_start.North, _start.East, above.Down),
            Part.Land => null,
            _ => above,
        };
        if (_part == Part.Land)
            _landing.Fly(situation, ref command);
        else if (_part == Part.Climb)
            command.Velocity = VelocityTo(situation, new NedVector(_start.North, _start.East, above.Down));
        else
            command.Velocity = VelocityHome(situation, above);
    }

    private void Advance(FlightSituation situation, NedVector above)
    {
        if (_part == Part.Climb && situation.Height > _height - HeightReached)
            _part = Part.Home;
        if (_part == Part.Home && above.Minus(situation.Position).HorizontalLength() < HomeReached)
        {
            _part = Part.Wait;
            _landsAt = situation.Time + TimeSpan.OfMilliseconds(situation.Parameters.ReturnLoiter.Value);
        }

        if (_part == Part.Wait && situation.Time >= _landsAt)
        {
            _part = Part.Land;
            _landing.EnterAt(above);
        }
    }

    private static NedVector VelocityHome(FlightSituation situation, NedVector above)
    {
        ParameterStore parameters = situation.Parameters;
        float speed = parameters.ReturnSpeed.Value > 0 ? parameters.ReturnSpeed.Value : parameters.Speed.Value;
        return VelocityTo(
            situation, above, speed / 100, parameters.SpeedUp.Value / 100, parameters.SpeedDown.Value / 100);
    }
}
