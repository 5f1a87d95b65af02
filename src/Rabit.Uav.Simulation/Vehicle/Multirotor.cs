using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// How a multirotor moves: it leans to accelerate (tilt = atan(a / g)), its attitude follows with a lag, the air
/// drags it along, the ground stops it. A velocity loop inside, as an autopilot has one, leans against the wind.
/// </summary>
internal sealed class Multirotor
{
    private const double MaxTilt = 30 * NedMath.RadiansPerDegree;
    private const double AttitudeSeconds = 0.15;
    private const double MaxTiltRate = 120 * NedMath.RadiansPerDegree;
    private const double LiftSeconds = 0.1;
    private const double MaxYawRate = 60 * NedMath.RadiansPerDegree;
    private const double YawGain = 2;             // 1/s
    private const double YawRateSeconds = 0.2;
    private const double VelocityGain = 2;        // 1/s
    private const double LeanGain = 0.8;          // 1/s2, of the integral that holds against the wind
    private const double MaxLean = 4;         // m/s2
    private const double Drag = 0.2;              // 1/s: 2 m/s2 at 10 m/s of air
    private const double MaxAirspeed = 18;        // m/s: there it needs 2.6 times the power of hovering
    private const double FallDrag = 0.5;          // 1/s: it falls at 20 m/s at most

    private NedVector _reference;
    private NedVector _lean;
    private double _lift;
    private double _yawRate;
    private double _rollRate;
    private double _pitchRate;

    /// <summary>Metres in the world; the ground is at down 0.</summary>
    public NedVector Position { get; set; }

    /// <summary>m/s over ground.</summary>
    public NedVector Velocity { get; private set; }

    /// <summary>m/s2 over ground, of the last step.</summary>
    public NedVector Acceleration { get; private set; }

    public double Roll { get; private set; }

    public double Pitch { get; private set; }

    /// <summary>Not wrapped.</summary>
    public double Yaw { get; set; }

    /// <summary>Body rates, radians per second.</summary>
    public BodyRates Rates => BodyRates.FromRadiansPerSecond(
        _rollRate - (_yawRate * Trig.Sin(Pitch)),
        (_pitchRate * Trig.Cos(Roll)) + (_yawRate * Trig.Sin(Roll) * Trig.Cos(Pitch)),
        (-_pitchRate * Trig.Sin(Roll)) + (_yawRate * Trig.Cos(Roll) * Trig.Cos(Pitch)));

    public bool IsOnGround => Position.Down >= 0;

    /// <summary>How fast it came down when it last met the ground, m/s.</summary>
    public double TouchdownSpeed { get; private set; }

    /// <summary>One step.</summary>
    public void Step(in MotionCommand command, NedVector wind, double seconds)
    {
        NedVector air = Velocity.Minus(wind);
        if (command.Motors == MotorState.Flying)
            Fly(command, air, seconds);
        else if (!IsOnGround)
            Fall(air, seconds);
        else
            Rest(seconds);
    }

    private void Fly(in MotionCommand command, NedVector air, double seconds)
    {
        NedVector wanted = Steer(command, air, seconds);
        Turn(command, seconds);
        bool leans = !IsOnGround && !command.KeepsLevel;
        if (command.KeepsLevel)
            (_reference, _lean) = (new NedVector(Velocity.North, Velocity.East, _reference.Down), default);
        Lean(leans ? wanted.North : 0, leans ? wanted.East : 0, seconds);

        // Forward and right of the vehicle, from how it stands; the motors hold the weight besides.
        double forward = -NedMath.Gravity * Math.Tan(Pitch);
        double right = NedMath.Gravity * Math.Tan(Roll) / Trig.Cos(Pitch);
        double north = (forward * Trig.Cos(Yaw)) - (right * Trig.Sin(Yaw));
        double east = (forward * Trig.Sin(Yaw)) + (right * Trig.Cos(Yaw));
        _lift += (wanted.Down - _lift) * seconds / LiftSeconds;
        Move(new NedVector(north - (Drag * air.North), east - (Drag * air.East), _lift), seconds);
    }

    // The velocity that is flown moves to the one that is wanted no faster than it may; the loop holds it.
    private NedVector Steer(in MotionCommand command, NedVector air, double seconds)
    {
        NedVector change = command.Velocity.Minus(_reference)
            .LimitedHorizontally(command.HorizontalAcceleration * seconds);
        double reach = command.VerticalAcceleration * seconds;
        change = new NedVector(change.North, change.East, NedMath.Limited(change.Down, -reach, reach));
        _reference = WithinAirspeed(_reference.Plus(change), Velocity.Minus(air));

        NedVector error = _reference.Minus(Velocity);
        NedVector wanted = change.Times(1 / seconds).Plus(error.Times(VelocityGain))
            .LimitedHorizontally(command.HorizontalAcceleration);
        if (!IsOnGround)
            _lean = _lean.Plus(new NedVector(error.North, error.East, 0).Times(LeanGain * seconds))
                .LimitedHorizontally(MaxLean);
        double down = NedMath.Limited(wanted.Down, -2 * command.VerticalAcceleration, 2 * command.VerticalAcceleration);
        return new NedVector(wanted.North + _lean.North, wanted.East + _lean.East, down);
    }

    // Against a strong wind it is slower over ground than it is commanded to be: the part s of the velocity v with
    // |s v - wind| at the limit, so that it keeps its track. It stands where the wind alone is too strong.
    private static NedVector WithinAirspeed(NedVector velocity, NedVector wind)
    {
        if (velocity.Minus(wind).HorizontalLength() <= MaxAirspeed)
            return velocity;
        double square = (velocity.North * velocity.North) + (velocity.East * velocity.East);
        double along = (velocity.North * wind.North) + (velocity.East * wind.East);
        double spare = (MaxAirspeed * MaxAirspeed) - (wind.North * wind.North) - (wind.East * wind.East);
        double part = spare > 0 ? (along + Math.Sqrt((along * along) + (square * spare))) / square : 0;
        return new NedVector(velocity.North * part, velocity.East * part, velocity.Down);
    }

    private void Turn(in MotionCommand command, double seconds)
    {
        double wanted = double.IsNaN(command.Yaw) ? command.YawRate : YawGain * NedMath.Wrapped(command.Yaw - Yaw);
        wanted = NedMath.Limited(wanted, -MaxYawRate, MaxYawRate);
        if (IsOnGround)
            wanted = 0;
        _yawRate += (wanted - _yawRate) * seconds / YawRateSeconds;
        Yaw += _yawRate * seconds;
    }

    // North is ahead of a vehicle that looks north: it puts the nose down to get there, and the right side down to go
    // right.
    private void Lean(double north, double east, double seconds)
    {
        double forward = (north * Trig.Cos(Yaw)) + (east * Trig.Sin(Yaw));
        double right = (east * Trig.Cos(Yaw)) - (north * Trig.Sin(Yaw));
        double pitch = NedMath.Limited(-Math.Atan(forward / NedMath.Gravity), -MaxTilt, MaxTilt);
        double roll = NedMath.Limited(Math.Atan(right * Trig.Cos(pitch) / NedMath.Gravity), -MaxTilt, MaxTilt);
        _pitchRate = NedMath.Limited((pitch - Pitch) / AttitudeSeconds, -MaxTiltRate, MaxTiltRate);
        _rollRate = NedMath.Limited((roll - Roll) / AttitudeSeconds, -MaxTiltRate, MaxTiltRate);
        Pitch += _pitchRate * seconds;
        Roll += _rollRate * seconds;
    }

    private void Fall(NedVector air, double seconds)
    {
        _yawRate = 0;
        Lean(0, 0, seconds);
        Move(
            new NedVector(-FallDrag * air.North, -FallDrag * air.East, NedMath.Gravity - (FallDrag * Velocity.Down)),
            seconds);
        Forget();
    }

    private void Rest(double seconds)
    {
        _yawRate = 0;
        Lean(0, 0, seconds);
        Velocity = default;
        Acceleration = default;
        Forget();
    }

    private void Move(NedVector acceleration, double seconds)
    {
        NedVector before = Velocity;
        NedVector velocity = before.Plus(acceleration.Times(seconds));
        NedVector position = Position.Plus(velocity.Times(seconds));
        if (position.Down >= 0 && velocity.Down >= 0)
        {
            if (!IsOnGround)
                TouchdownSpeed = velocity.Down;
            position = new NedVector(Position.North, Position.East, 0);
            velocity = default;
            _reference = new NedVector(0, 0, _reference.Down);
            _lift = Math.Min(0, _lift);
        }

        Velocity = velocity;
        Position = position;
        Acceleration = velocity.Minus(before).Times(1 / seconds);
    }

    private void Forget()
    {
        _reference = Velocity;
        _lean = default;
        _lift = 0;
    }
}
