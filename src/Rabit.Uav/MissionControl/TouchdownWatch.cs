using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Decides between a landing and a crash by what was reported when the motors stopped: landed state, height and speed
/// of descent of that moment, never older ones. No I/O, one thread.
/// </summary>
internal sealed class TouchdownWatch
{
    // Heights are as noisy as a metre; motors that stop above this are in the air.
    private const double OnGroundHeightMetres = 2;

    // Without a landed state: landing places are that much above or below home.
    private const double LandedHeightMetres = 5;

    // No autopilot descends faster on its own (ArduPilot's WPNAV_SPEED_DN is at most 5 m/s, PX4's MPC_Z_VEL_MAX_DN
    // 4 m/s); what falls is faster after 0.8 s.
    private const double FallMetresPerSecond = 8;

    // Near the ground autopilots land at 0.5 to 1.5 m/s (LAND_SPEED, MPC_LAND_SPEED); below this height 3 m/s is what
    // falls half a metre.
    private const double NearGroundMetres = 5;
    // A fixed wing comes in faster, to its flare (recorded: 3.1 m/s).
    private const double FallNearGroundMetresPerSecond = 3;

    // A vehicle that still flies this long after a fast descent did not fall.
    private static readonly TimeSpan RecoveryTime = TimeSpan.FromSeconds(5);

    // Reports of a second or two apart (EXTENDED_SYS_STATE at 2 Hz, one missed) are of the same moment.
    private static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(2);

    // How long after the stop reports may come that say how: in it what falls from 2 m is fast or down.
    private static readonly TimeSpan DecisionTime = TimeSpan.FromSeconds(1);

    private TimeSpan? _fellAt;
    private TimeSpan? _armedAt;
    private TimeSpan? _stoppedAt;
    private double _fallSpeed;
    private bool _wasOnGround;

    /// <summary>How the motors stopped.</summary>
    public MotorStop Stop { get; private set; }

    /// <summary>
    /// Whether the place where they stopped is known: a position of that moment that the estimator counts on.
    /// </summary>
    public bool IsPlaceKnown { get; private set; }

    /// <summary>How it came to a stop that is no landing, as text.</summary>
    public string Text { get; private set; } = string.Empty;

    /// <summary>Takes the state of a connected vehicle; at each unit of work.</summary>
    public void Update(MissionFlight flight)
    {
        if (!flight.IsConnected)
            return;
        bool isFresh = flight.Vehicle.PositionTime is { } time && flight.Now - time <= MaxAge;
        if (Stop is MotorStop.None or MotorStop.Undecided || flight.Vehicle.IsArmed)
            WatchDescent(flight, isFresh);
        if (flight.Vehicle.IsArmed)
        {
            (_armedAt, _stoppedAt, Stop) = (flight.Now, null, MotorStop.None);
            _wasOnGround = IsReportedOnGround(flight);
        }
        else if (_armedAt is not null && Stop is MotorStop.None or MotorStop.Undecided)
        {
            Decide(flight, isFresh);
        }
    }

    private void WatchDescent(MissionFlight flight, bool isFresh)
    {
        double down = flight.Vehicle.VelocityNed.Down;
        bool falls = isFresh
            && (down > FallMetresPerSecond
                || (down > FallNearGroundMetresPerSecond && flight.HeightMetres < NearGroundMetres
                    && !flight.IsFixedWing));
        if (falls)
            (_fellAt, _fallSpeed) = (flight.Now, down);
        else if (flight.Vehicle.IsArmed && flight.Vehicle.LandedState == MavLandedState.InAir
            && flight.Now - _fellAt > RecoveryTime)
            _fellAt = null;
    }

    private void Decide(MissionFlight flight, bool isFresh)
    {
        bool isFirst = _stoppedAt is null;
        _stoppedAt ??= flight.Now;
        bool isWitnessed = _stoppedAt - _armedAt <= MaxAge;
        bool isUndecided = flight.Now - _stoppedAt < DecisionTime;

        // After a lost connection the heartbeat says that it is disarmed before the position comes; it stands where it
        // landed.
        if (isFirst || (!isWitnessed && !IsPlaceKnown))
            IsPlaceKnown = isFresh && flight.Vehicle.HasValidHorizontalPosition;
        bool waitsForPlace = !isWitnessed && !IsPlaceKnown && isUndecided;
        double landedHeight = IsLandedStateReported(flight) ? OnGroundHeightMetres : LandedHeightMetres;
        bool isHigh = isFresh && flight.HeightMetres > landedHeight;
        Stop = _fellAt is not null ? MotorStop.Fallen
            : _wasOnGround && !waitsForPlace ? MotorStop.Landed
            : isHigh ? (isWitnessed ? MotorStop.Fallen : MotorStop.Unknown)
            : isUndecided ? MotorStop.Undecided
            : isFresh ? MotorStop.Landed
            : MotorStop.Unknown;
        Text = Stop == MotorStop.Unknown ? "the motors stopped, and neither landed state nor height says where"
            : _fellAt is not null ? $"the vehicle fell, at {MissionNumbers.Of(_fallSpeed)} m/s"
            : $"the motors stopped at a height of {MissionNumbers.Of(flight.HeightMetres)} m";
    }

    private static bool IsLandedStateReported(MissionFlight flight)
        => flight.Vehicle.LandedState != MavLandedState.Undefined
            && flight.Vehicle.LandedStateTime is { } time && flight.Now - time <= MaxAge;

    private static bool IsReportedOnGround(MissionFlight flight)
        => flight.Vehicle.LandedState == MavLandedState.OnGround && IsLandedStateReported(flight);
}
