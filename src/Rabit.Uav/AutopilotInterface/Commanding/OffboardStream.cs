using System;
using Rabit.Geodesy;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// The stream of set-points that PX4's OFFBOARD needs, with position and velocity as feed-forward. A state machine:
/// time, state and reports of the mode come in, set-points go out.
/// </summary>
/// <remarks>
/// Set-points that come again after PX4's failsafe for their loss bring it back to OFFBOARD without any command, even
/// from its return. So nothing is sent without a fresh report of the mode: the stream pauses when the last request that
/// the autopilot acknowledged and answered is older than <see cref="MaxReportAge"/>, whatever the reason (a stall here,
/// a link that is gone one way or both), and goes on when one after the pause shows OFFBOARD. The bound is not above
/// the shortest time after which the failsafe acts (COM_OF_LOSS_T 0.5 s, the least that the pre-flight checklist
/// passes).
/// </remarks>
internal sealed class OffboardStream
{
    /// <summary>20 Hz; OFFBOARD needs more than 2 Hz.</summary>
    public static readonly TimeSpan Period = TimeSpan.FromMilliseconds(50);

    /// <summary>How long it runs before OFFBOARD is asked for: PX4 checks that set-points come.</summary>
    public static readonly TimeSpan LeadTime = TimeSpan.FromSeconds(1);

    /// <summary>How old the last report of the mode may be where reports are asked for.</summary>
    public static readonly TimeSpan MaxReportAge = TimeSpan.OfSeconds(0.5);

    /// <summary>The same where PX4 denies the requests: its heartbeats come once a second.</summary>
    public static readonly TimeSpan MaxHeartbeatAge = TimeSpan.OfSeconds(1.5);

    // Position and velocity count; accelerations and the yaw rate do not.
    private const PositionTargetTypemask PositionAndVelocity = PositionTargetTypemask.AxIgnore
        | PositionTargetTypemask.AyIgnore | PositionTargetTypemask.AzIgnore | PositionTargetTypemask.YawRateIgnore;

    private readonly OffboardTrajectory _trajectory = new();
    private TimeSpan _startedAt;
    private TimeSpan _due;
    private TimeSpan _sentAt;
    private VehicleCommand? _leg;

    public bool IsRunning { get; private set; }

    /// <summary>When the next set-point is due; far away where none is.</summary>
    public TimeSpan NextDue => IsRunning && !IsPaused ? _due : TimeSpan.MaxValue;

    /// <summary>Whether it waits for a fresh report.</summary>
    public bool IsPaused { get; private set; }

    /// <summary>Whether a report has shown OFFBOARD since it was started.</summary>
    public bool IsInOffboard { get; private set; }

    /// <summary>When a report first showed OFFBOARD; far away where none did.</summary>
    public TimeSpan OffboardSince { get; private set; } = TimeSpan.MaxValue;

    /// <summary>The set-point that was sent last; its altitude is not used.</summary>
    public GeodeticPosition Place => _trajectory.Place;

    /// <summary>Its height above home.</summary>
    public double HeightMetres => -_trajectory.Position.Down;

    /// <summary>Starts it where the vehicle is.</summary>
    public void Start(in VehicleState vehicle, TimeSpan now)
    {
        _trajectory.Reset(vehicle);
        _startedAt = _due = _sentAt = now;
        IsRunning = true;
        IsPaused = IsInOffboard = false;
        OffboardSince = TimeSpan.MaxValue;
        _leg = null;
    }

    public void Stop()
    {
        IsRunning = IsPaused = IsInOffboard = false;
        OffboardSince = TimeSpan.MaxValue;
        _leg = null;
    }

    /// <summary>Whether it has run long enough for OFFBOARD to be asked for.</summary>
    public bool HasLead(TimeSpan now) => IsRunning && !IsPaused && now - _startedAt >= LeadTime;

    /// <summary>Sets the target of the leg.</summary>
    /// <param name="command">The command to go there.</param>
    /// <param name="vehicle">The state.</param>
    public void SetTarget(in VehicleCommand command, in VehicleState vehicle)
    {
        if (_leg is null)
            _trajectory.Reset(vehicle);
        _leg = command;
        _trajectory.SetTarget(command);
    }

    /// <summary>Takes a report of a mode that is ours.</summary>
    /// <param name="vehicle">The state after it.</param>
    /// <param name="isModeUnanswered">
    /// Whether a mode command of ours has no answer yet: until then another mode does not end the stream.
    /// </param>
    public void TakeReport(in VehicleState vehicle, bool isModeUnanswered)
    {
        if (!IsRunning)
            return;
        bool isOffboard = vehicle.CustomMode == Px4Modes.Offboard;
        if (IsInOffboard && !isOffboard)
        {
            if (!isModeUnanswered)
                Stop();
            return;
        }

        if (!IsInOffboard && isOffboard)
            OffboardSince = vehicle.LastHeartbeatTime;
        IsInOffboard |= isOffboard;
    }

    /// <summary>Ends a pause: a report after it showed that the mode is still ours.</summary>
    public void Resume(in VehicleState vehicle, TimeSpan now)
    {
        // The leg goes on from where the vehicle is after the pause.
        _trajectory.Reset(vehicle);
        if (_leg is { } leg)
            _trajectory.SetTarget(leg);
        IsPaused = false;
        _startedAt = _due = _sentAt = now;
    }

    /// <summary>Pauses it where the last report of the mode is too old.</summary>
    /// <param name="provenAt">Until when the link is proven both ways; null where it is not.</param>
    /// <param name="maxAge">How long ago that may be.</param>
    /// <param name="now">The time.</param>
    /// <returns>Whether it has paused just now.</returns>
    public bool TryPause(TimeSpan? provenAt, TimeSpan maxAge, TimeSpan now)
    {
        if (!IsRunning || IsPaused || now - provenAt <= maxAge)
            return false;
        IsPaused = true;
        return true;
    }

    public bool TryNext(TimeSpan now, in OwnAddress from, in VehicleState vehicle, out MavlinkFrame frame)
    {
        frame = default;
        if (!IsRunning || IsPaused || now < _due)
            return false;
        _due += Period;
        if (_due <= now)
            _due = now + Period;
        if (_leg is not null)
            _trajectory.Advance((now - _sentAt).ExactSeconds, vehicle);
        else
            _trajectory.Reset(vehicle);
        _sentAt = now;
        frame = Create(now, from, vehicle);
        return true;
    }

    private MavlinkFrame Create(TimeSpan now, in OwnAddress from, in VehicleState vehicle)
    {
        GeodeticPosition place = Place;
        NedVector velocity = _leg is not null ? _trajectory.Velocity : NedVector.Zero;
        var target = new SetPositionTargetGlobalInt
        {
            TimeBootMs = unchecked((uint)(now.Ticks / TimeSpan.TicksPerMillisecond)),
            TargetSystem = vehicle.SystemId,
            TargetComponent = vehicle.ComponentId,
            CoordinateFrame = MavFrame.GlobalRelativeAltInt,
            TypeMask = PositionAndVelocity,
            LatInt = (int)Math.Round(place.Latitude.Degrees * 1e7),
            LonInt = (int)Math.Round(place.Longitude.Degrees * 1e7),
            Alt = (float)HeightMetres,
            Vx = (float)velocity.North,
            Vy = (float)velocity.East,
            Vz = (float)velocity.Down,
            Yaw = (float)_trajectory.YawRadians,
        };
        return MavlinkFrame.Create(target, from.SystemId, from.ComponentId, sequence: 0);
    }
}
