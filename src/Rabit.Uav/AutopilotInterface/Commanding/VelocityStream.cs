using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Repeats the velocity that Mission Control commands, five times a second: ArduPilot forgets it after 3 s
/// (GUID_TIMEOUT). Mission Control must repeat it too: after 1.5 s without one the stream stops. A state machine: time
/// comes in, set-points go out.
/// </summary>
internal sealed class VelocityStream
{
    public static readonly TimeSpan Period = TimeSpan.FromMilliseconds(200);

    /// <summary>After what time without a repetition it ends.</summary>
    public static readonly TimeSpan DeadManTimeout = TimeSpan.OfSeconds(1.5);

    private const PositionTargetTypemask VelocityOnly = PositionTargetTypemask.XIgnore | PositionTargetTypemask.YIgnore
        | PositionTargetTypemask.ZIgnore | PositionTargetTypemask.AxIgnore | PositionTargetTypemask.AyIgnore
        | PositionTargetTypemask.AzIgnore
        | PositionTargetTypemask.YawRateIgnore;

    private VehicleCommand _command;
    private TimeSpan _repeatedAt;
    private TimeSpan _due;

    public bool IsRunning { get; private set; }

    /// <summary>Takes a velocity, the first or the next one. It is sent at once.</summary>
    /// <param name="command">The command.</param>
    /// <param name="givenAt">When Mission Control gave it.</param>
    /// <param name="now">The time.</param>
    public void Start(in VehicleCommand command, TimeSpan givenAt, TimeSpan now)
    {
        _command = command;
        _repeatedAt = givenAt;
        _due = now;
        IsRunning = true;
    }

    public void Stop() => IsRunning = false;

    public bool IsDead(TimeSpan now) => IsRunning && now - _repeatedAt > DeadManTimeout;

    public bool TryNext(TimeSpan now, in OwnAddress from, in VehicleState to, out MavlinkFrame frame)
    {
        frame = default;
        if (!IsRunning || now < _due)
            return false;
        _due += Period;
        if (_due <= now)
            _due = now + Period;

        bool hasYaw = !double.IsNaN(_command.Yaw.Radians);
        var target = new SetPositionTargetLocalNed
        {
            TimeBootMs = unchecked((uint)(now.Ticks / TimeSpan.TicksPerMillisecond)),
            TargetSystem = to.SystemId,
            TargetComponent = to.ComponentId,
            CoordinateFrame = MavFrame.LocalNed,
            TypeMask = hasYaw ? VelocityOnly : VelocityOnly | PositionTargetTypemask.YawIgnore,
            Vx = (float)_command.VelocityNed.North,
            Vy = (float)_command.VelocityNed.East,
            Vz = (float)_command.VelocityNed.Down,
            Yaw = hasYaw ? (float)_command.Yaw.Radians : 0,
        };
        frame = MavlinkFrame.Create(target, from.SystemId, from.ComponentId, sequence: 0);
        return true;
    }
}
