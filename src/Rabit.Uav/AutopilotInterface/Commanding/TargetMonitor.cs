using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Finds out that another commander gave ArduPilot a target in GUIDED, which changes no mode: the target that the
/// autopilot reports (POSITION_TARGET_LOCAL_NED) is none of ours. No I/O, one thread.
/// </summary>
/// <remarks>
/// The local message, because POSITION_TARGET_GLOBAL_INT of ArduPilot 4.7-dev is wrong. A target of ours is what a
/// DO_REPOSITION said, from the moment in which it was sent: an acknowledgement may be lost, and the next target may
/// come before the answer. A take-off has no such target: ArduPilot reports what it had before, which must not change.
/// The origin of the frame is GPS_GLOBAL_ORIGIN; where that has not come, the first target of ours that is reported
/// shows it.
/// </remarks>
internal sealed class TargetMonitor
{
    // How long a report of the target before may come after an acknowledgement: links may reorder.
    private static readonly TimeSpan LateTime = TimeSpan.OfSeconds(0.6);

    // Below it a target is the same: the message has float metres, ArduPilot rounds to centimetres, and a link of 4 Hz
    // leaves nothing else that differs.
    private const double MaxShiftMetres = 2;

    // Commands that are unanswered at a time, and the one in force.
    private const int MaxTargets = 4;

    private const PositionTargetTypemask Place = PositionTargetTypemask.XIgnore | PositionTargetTypemask.YIgnore
        | PositionTargetTypemask.ZIgnore;
    private const PositionTargetTypemask Velocity = PositionTargetTypemask.VxIgnore | PositionTargetTypemask.VyIgnore
        | PositionTargetTypemask.VzIgnore;

    private readonly ReportedTarget[] _targets = new ReportedTarget[MaxTargets];
    private ArdupilotOrigin? _origin;
    private PositionTargetLocalNed? _before;
    private TimeSpan? _watchedSince;
    private bool _isTakeOff;
    private bool _isOriginLearned;
    private int _count;

    /// <summary>The autopilot reports the origin of its local frame.</summary>
    public void TakeOrigin(in GpsGlobalOrigin message)
    {
        if (message.Latitude != 0 || message.Longitude != 0)
            (_origin, _isOriginLearned) = (ArdupilotOrigin.Of(message), false);
    }

    /// <summary>The autopilot has rebooted: its frame has another origin.</summary>
    public void Restart()
    {
        Stop();
        _origin = null;
    }

    /// <summary>No target of ours is in force: another mode, velocities, or the command was taken away.</summary>
    public void Stop()
    {
        (_count, _watchedSince, _before, _isTakeOff) = (0, null, null, false);
        if (_isOriginLearned)
            _origin = null;
    }

    /// <summary>A target is sent.</summary>
    /// <param name="request">The DO_REPOSITION, with its height above home.</param>
    /// <param name="homeAltitudeAmslMetres">The altitude of home.</param>
    public void Ask(in MavlinkCommand request, double homeAltitudeAmslMetres)
    {
        if (_count == MaxTargets)
            Remove(0);
        _targets[_count++] = new ReportedTarget(request.X, request.Y, homeAltitudeAmslMetres + request.Z);
    }

    /// <summary>The autopilot acknowledged the target that was sent last.</summary>
    public void Acknowledge(TimeSpan time)
    {
        for (int i = 0; i < _count - 1; i++)
            _targets[i].Expires ??= time + LateTime;
        bool isFirst = _watchedSince is null || _isTakeOff;
        _watchedSince = isFirst ? time + LateTime : _watchedSince;
        _isTakeOff = false;
    }

    /// <summary>The autopilot refused the target that was sent last.</summary>
    public void Withdraw()
    {
        if (_count > 0)
            _count--;
    }

    /// <summary>The autopilot acknowledged the take-off: the target that it reports must not change.</summary>
    public void BeginTakeOff(TimeSpan time)
    {
        Stop();
        (_isTakeOff, _watchedSince) = (true, time + LateTime);
    }

    /// <summary>Takes the target that the autopilot reports.</summary>
    /// <param name="target">The target.</param>
    /// <param name="time">When it was received.</param>
    /// <returns>Whether it is another commander's.</returns>
    public bool IsOfAnother(in PositionTargetLocalNed target, TimeSpan time)
    {
        if (_watchedSince is not { } since || time < since)
            return false;
        if (_isTakeOff)
            return HasChanged(target);
        if ((target.TypeMask & (Place | Velocity)) != Velocity)
            return true;
        RemoveExpired(time);
        if (_origin is null)
        {
            Learn(target);
            return false;
        }

        return !IsAsked(target);
    }

    // By the one that is in force: the newest may be on its way.
    private void Learn(in PositionTargetLocalNed target)
    {
        if (_count == 1)
            (_origin, _isOriginLearned) = (ArdupilotOrigin.Of(_targets[0], target), true);
    }

    private void RemoveExpired(TimeSpan time)
    {
        for (int i = _count - 1; i >= 0; i--)
        {
            if (_targets[i].Expires < time)
                Remove(i);
        }
    }

    private bool HasChanged(in PositionTargetLocalNed target)
    {
        // Targets that are on their way count as ours in the take-off, too.
        if (_before is not { } before)
        {
            _before = target;
            return false;
        }

        (double north, double east, double down) = (target.X - before.X, target.Y - before.Y, target.Z - before.Z);
        bool isShifted = (north * north) + (east * east) + (down * down) > MaxShiftMetres * MaxShiftMetres;
        return (isShifted || target.TypeMask != before.TypeMask) && !IsAsked(target);
    }

    private bool IsAsked(in PositionTargetLocalNed target)
    {
        bool isAsked = _count > 0 && _origin is null;
        for (int i = 0; i < _count && !isAsked; i++)
            isAsked = _origin!.Value.DistanceOf(_targets[i], target) <= MaxShiftMetres;
        return isAsked;
    }

    private void Remove(int index)
    {
        _count--;
        for (int i = index; i < _count; i++)
            _targets[i] = _targets[i + 1];
    }
}
