using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Finds out that another commander gave ArduPilot a target in GUIDED, which changes no mode: the target that the
/// autopilot reports (POSITION_TARGET_LOCAL_NED) changes without a command of ours. No I/O, one thread.
/// </summary>
/// <remarks>
/// The local message, because POSITION_TARGET_GLOBAL_INT of ArduPilot 4.7-dev is wrong. What is compared is its change
/// alone: the origin of the frame need not be known.
/// </remarks>
internal sealed class TargetMonitor
{
    // A target of ours is reported from the next sample on, after its acknowledgement.
    private static readonly TimeSpan SettlingTime = TimeSpan.FromSeconds(0.6);

    // Below it a target is the same: the message has float metres, and the autopilot rounds to centimetres.
    private const double MaxShiftMetres = 2;

    private PositionTargetLocalNed? _ours;
    private TimeSpan? _settledAt;

    /// <summary>A target of ours was acknowledged: what is reported from now on is ours.</summary>
    public void Begin(TimeSpan time)
    {
        _ours = null;
        _settledAt = time + SettlingTime;
    }

    /// <summary>No target of ours is in force, or one is about to change.</summary>
    public void Stop()
    {
        _ours = null;
        _settledAt = null;
    }

    /// <summary>Takes the target that the autopilot reports.</summary>
    /// <param name="target">The target.</param>
    /// <param name="time">When it was received.</param>
    /// <returns>Whether it is another commander's.</returns>
    public bool IsOfAnother(in PositionTargetLocalNed target, TimeSpan time)
    {
        if (_settledAt is not { } settled || time < settled)
            return false;
        if (_ours is not { } ours)
        {
            _ours = target;
            return false;
        }

        double north = target.X - ours.X;
        double east = target.Y - ours.Y;
        double down = target.Z - ours.Z;
        bool isShifted = (north * north) + (east * east) + (down * down) > MaxShiftMetres * MaxShiftMetres;
        return isShifted || target.TypeMask != ours.TypeMask;
    }
}
