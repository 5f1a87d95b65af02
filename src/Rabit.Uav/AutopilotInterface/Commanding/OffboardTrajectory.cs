using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// The set-point that moves along the leg: in OFFBOARD PX4 plans nothing, so that a far target would be a jump. Speeds
/// up, flies with the speed of the command and stops at the target. No I/O, one thread.
/// </summary>
/// <remarks>
/// Accelerations and vertical speeds are within PX4's defaults (MPC_ACC_HOR 3 m/s2, MPC_Z_VEL_MAX_UP 3 m/s,
/// MPC_Z_VEL_MAX_DN 1.5 m/s), so that the vehicle can follow. A set-point that the vehicle cannot follow waits for it.
/// </remarks>
internal sealed class OffboardTrajectory
{
    // Where a command leaves the speed to the autopilot: PX4's cruising speed (MPC_XY_CRUISE).
    private const double DefaultSpeed = 5;

    // All of it: with 2 m/s2 the vehicle stayed behind a car that takes curves at 2.6 m/s2.
    private const double Acceleration = 3;
    private const double ClimbSpeed = 2;
    private const double SinkSpeed = 1;
    private const double VerticalAcceleration = 1;
    private const double YawRateRadians = 45 * Angle.RadiansPerDegree;

    // How far the set-point may be ahead: the lag of PX4's position loop (MPC_XY_P 0.95 1/s) without feed-forward, and
    // gusts.
    private const double MaxLeadSeconds = 1.2;
    private const double MaxLeadMetres = 4;

    private LocalNedFrame _frame;
    private NedPosition _target;
    private double _speed;
    private double _targetYaw;

    /// <summary>The set-point in the frame of the start, heights above home.</summary>
    public NedPosition Position { get; private set; }

    /// <summary>Its velocity: the feed-forward.</summary>
    public NedVector Velocity { get; private set; }

    /// <summary>The heading, clockwise from north, radians.</summary>
    public double YawRadians { get; private set; }

    /// <summary>The set-point as a place; its altitude is not used.</summary>
    public GeodeticPosition Place => _frame.ToGeodetic(new NedPosition(Position.North, Position.East, 0));

    /// <summary>Begins where the vehicle is, with its velocity, and stays there until a target is set.</summary>
    public void Reset(in VehicleState vehicle)
    {
        _frame = LocalNedFrame.IgnoringGeoid(vehicle.Position);
        Position = new NedPosition(0, 0, -vehicle.HeightAboveHomeMetres);
        Velocity = vehicle.VelocityNed;
        YawRadians = vehicle.Attitude.Yaw.IsFinite ? vehicle.Attitude.Yaw.Radians : 0;
        _target = Position;
        _targetYaw = YawRadians;
        _speed = DefaultSpeed;
    }

    /// <summary>Sets the target of the leg.</summary>
    public void SetTarget(in VehicleCommand command)
    {
        NedPosition at = _frame.ToNed(GeodeticPosition.FromRadians(
            command.Latitude.Radians, command.Longitude.Radians, _frame.Origin.AltitudeAmslMetres));
        _target = new NedPosition(at.North, at.East, -command.HeightAboveHomeMetres);
        _speed = double.IsNaN(command.SpeedMetresPerSecond) ? DefaultSpeed : command.SpeedMetresPerSecond;
        if (command.Yaw.IsFinite)
            _targetYaw = command.Yaw.Radians;
    }

    /// <summary>Moves the set-point on.</summary>
    /// <param name="seconds">The time since the last set-point.</param>
    /// <param name="vehicle">Where the vehicle is.</param>
    public void Advance(double seconds, in VehicleState vehicle)
    {
        NedVector toTarget = _target - Position;
        double distance = toTarget.HorizontalLength;
        double speed = IsTooFarAhead(vehicle) ? 0 : Approach(distance, _speed, Acceleration);
        double north = distance > 1e-6 ? toTarget.North * speed / distance : 0;
        double east = distance > 1e-6 ? toTarget.East * speed / distance : 0;
        (north, east) = Limited(
            north - Velocity.North, east - Velocity.East, Acceleration * seconds);
        double maxVertical = toTarget.Down > 0 ? SinkSpeed : ClimbSpeed;
        double down = Math.Sign(toTarget.Down) * Approach(Math.Abs(toTarget.Down), maxVertical, VerticalAcceleration);
        double downChange = Math.Max(
            -VerticalAcceleration * seconds, Math.Min(VerticalAcceleration * seconds, down - Velocity.Down));
        Velocity = new NedVector(Velocity.North + north, Velocity.East + east, Velocity.Down + downChange);
        Position += Velocity * seconds;
        Turn(seconds);
    }

    private bool IsTooFarAhead(in VehicleState vehicle)
    {
        NedPosition at = _frame.ToNed(vehicle.Position);
        double lead = Position.HorizontalDistanceTo(at);
        return lead > MaxLeadMetres + (MaxLeadSeconds * _speed);
    }

    // What can still be stopped within the distance; near the target proportional, so that it does not swing about it.
    private static double Approach(double distance, double speed, double deceleration)
        => Math.Min(speed, Math.Min(distance, Math.Sqrt(2 * 0.7 * deceleration * distance)));

    private static (double North, double East) Limited(double north, double east, double max)
    {
        double length = Math.Sqrt((north * north) + (east * east));
        return length <= max ? (north, east) : (north * max / length, east * max / length);
    }

    private void Turn(double seconds)
    {
        double error = Angle.FromRadians(_targetYaw - YawRadians).Wrapped().Radians;
        double step = YawRateRadians * seconds;
        YawRadians = Angle.FromRadians(YawRadians + Math.Max(-step, Math.Min(step, error))).Wrapped().Radians;
    }
}
