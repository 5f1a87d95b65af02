using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// AUTO.RTL: climb to RTL_RETURN_ALT, less where home is near; fly home; descend to RTL_DESCEND_ALT; wait
/// RTL_LAND_DELAY; land. It reports each part by an EVENT.
/// </summary>
internal sealed class Px4ReturnFlight(Px4Events events, WorldFrame frame) : Px4Flight
{
    private const double HeightReached = 0.8;   // NAV_MC_ALT_RAD
    private const double PlaceReached = 2;      // NAV_ACC_RAD
    private const double StartReached = 1;      // metres
    private const double BackSpeed = 0.4;       // m/s, to where it was when it began; recorded: 0.3 to 0.8
    private const double BrakeAcceleration = 2; // m/s2, as recorded
    private const double ClimbAcceleration = 0.7;   // m/s2, as recorded
    private const double PartOfCruise = 0.9;    // recorded: 3.6 to 4.7 m/s of 5
    private const double TurnAcceleration = 1.5;   // m/s2, while it turns towards home
    private const byte Information = 0x66;

    private readonly Px4LandFlight _landing = new();
    private Part _part;
    private NedVector _place;
    private TimeSpan _landsAt;
    private bool _isClimbing;

    private enum Part
    {
        Climb,
        Home,
        Descend,
        Wait,
        Land,
    }

    public override bool IsLanding => _part == Part.Land;

    public override NedVector? Target => _place;

    public override void Enter(Px4Situation situation)
    {
        NedVector home = situation.Home ?? situation.Position;
        NedVector here = situation.Position;
        double height = Math.Max(situation.Height, ReturnHeight(situation, home));
        _part = Part.Climb;
        _isClimbing = false;
        _place = new NedVector(here.North, here.East, home.Down - height);
        events.Send(Px4Event.ReturnActivated, Information, text: "RTL HOME activated");
        events.Send(Px4Event.ReturnLandsAtHome, Information, text: "RTL: landing at home position.");
        Report(Px4Event.ReturnClimbs, "climb to", home);
    }

    public override void Fly(Px4Situation situation, ref MotionCommand command)
    {
        if (situation.IsLanded)
        {
            command.Motors = MotorState.Idle;
            return;
        }

        Advance(situation, situation.Home ?? situation.Position);
        if (_part == Part.Land)
        {
            _landing.Fly(situation, ref command);
            return;
        }

        double speed = _part == Part.Climb ? BackSpeed : PartOfCruise * situation.CruiseSpeed;
        command.Velocity = VelocityTo(situation, _place, speed);
        if (_part == Part.Climb)
            Climb(situation, ref command);
        if (_part == Part.Descend)
            command.VerticalAcceleration = ClimbAcceleration;
        if (_part != Part.Home)
            return;
        command.HorizontalAcceleration = Math.Min(command.HorizontalAcceleration, TurnAcceleration);
        PointAlong(situation, _place, ref command);
    }

    // First back to where it was when it began: it does not climb before.
    private void Climb(Px4Situation situation, ref MotionCommand command)
    {
        command.HorizontalAcceleration = BrakeAcceleration;
        command.VerticalAcceleration = ClimbAcceleration;
        _isClimbing |= _place.Minus(situation.Position).HorizontalLength() < StartReached
            && situation.Velocity.HorizontalLength() < StartReached;
        if (!_isClimbing)
            command.Velocity = new NedVector(command.Velocity.North, command.Velocity.East, 0);
    }

    // Near home it need not be so high: a cone of RTL_CONE_ANG on both sides.
    private static double ReturnHeight(Px4Situation situation, NedVector home)
    {
        Px4Parameters parameters = situation.Parameters;
        double distance = home.Minus(situation.Position).HorizontalLength();
        if (distance <= parameters.ReturnMinDistance.Value)
            return parameters.DescendHeight.Value;
        double angle = parameters.ReturnCone.Value * NedMath.RadiansPerDegree;
        if (angle <= 0 || angle >= Math.PI / 2)
            return parameters.ReturnHeight.Value;
        double cone = Math.Max(parameters.DescendHeight.Value, distance / Math.Tan(angle));
        return Math.Min(parameters.ReturnHeight.Value, cone);
    }

    private void Advance(Px4Situation situation, NedVector home)
    {
        bool isAtHeight = Math.Abs(_place.Down - situation.Position.Down) < HeightReached;
        bool isThere = _place.Minus(situation.Position).HorizontalLength() < PlaceReached;
        if (_part == Part.Climb && isAtHeight && _isClimbing)
        {
            _part = Part.Home;
            _place = new NedVector(home.North, home.East, _place.Down);
            Report(Px4Event.ReturnFlies, "return at", home);
        }
        else if (_part == Part.Home && isThere)
        {
            _part = Part.Descend;
            double height = Math.Min(home.Down - _place.Down, situation.Parameters.DescendHeight.Value);
            _place = new NedVector(home.North, home.East, home.Down - height);
            Report(Px4Event.ReturnDescends, "descend to", home);
        }
        else if (_part == Part.Descend && isAtHeight)
        {
            _part = Part.Wait;
            double delay = situation.Parameters.LandDelay.Value;
            _landsAt = delay < 0 ? TimeSpan.MaxValue : situation.Time + TimeSpan.OfSeconds(delay);
        }
        else if (_part == Part.Wait && situation.Time >= _landsAt)
        {
            _part = Part.Land;
            _place = home;
            _landing.EnterAt(home);
            events.Send(Px4Event.ReturnLands, Information, text: "RTL: land at destination");
        }
    }

    private void Report(Px4Event id, string what, NedVector home)
    {
        var above = (int)Math.Floor(home.Down - _place.Down);
        var aboveSea = (int)Math.Ceiling(frame.Origin.AltitudeAmslMetres - _place.Down);
        events.Send(
            id, Information, default(Px4EventArguments).UInt32((uint)aboveSea).UInt32((uint)above),
            FormattableString.Invariant($"RTL: {what} {aboveSea} m ({above} m above destination)"));
    }
}
