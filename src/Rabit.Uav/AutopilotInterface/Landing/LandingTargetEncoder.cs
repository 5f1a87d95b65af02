using System;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// LANDING_TARGET as each autopilot takes it: ArduPilot by angles and distance in the frame of the body, PX4 as a place
/// in its local frame. For one thread.
/// </summary>
/// <remarks>
/// ArduPilot: AC_PrecLand_MAVLink.cpp, where the direction is (-tan(angle_y), tan(angle_x), 1). PX4:
/// mavlink_receiver.cpp, which takes a valid position in MAV_FRAME_LOCAL_NED and refuses any other frame.
/// </remarks>
internal sealed class LandingTargetEncoder
{
    // Over which the velocity is taken to stay the same: at the few metres per second of a landing an error of 1 m/s2
    // is then 12 cm.
    private static readonly TimeSpan MaxExtrapolation = TimeSpan.OfSeconds(0.5);

    private TimeSpan? _time;
    private NedVector _position;
    private NedVector _velocity;

    /// <summary>Where the vehicle is in the autopilot's local frame.</summary>
    /// <param name="position">Of the autopilot.</param>
    /// <param name="time">When that was true, by our clock.</param>
    /// <returns>Whether it is valid.</returns>
    public bool Take(in LocalPositionNed position, TimeSpan time)
    {
        var place = new NedVector(position.X, position.Y, position.Z);
        var velocity = new NedVector(position.Vx, position.Vy, position.Vz);
        if (!place.IsFinite || !velocity.IsFinite)
            return false;
        (_time, _position, _velocity) = (time, place, velocity);
        return true;
    }

    /// <summary>The autopilot has another local frame: what was reported before holds no longer.</summary>
    public void Clear() => _time = null;

    /// <returns>False where that autopilot cannot take it, or not now.</returns>
    public bool TryEncode(in LandingTargetObservation target, MavAutopilot autopilot, out LandingTarget message)
    {
        message = new LandingTarget
        {
            TimeUsec = (ulong)Math.Max(0, target.Time.Ticks / 10),
            TargetNum = 0,
            Type = LandingTargetType.VisionFiducial,
            Distance = (float)target.PositionMetres.Length,
        };
        return autopilot switch
        {
            MavAutopilot.Ardupilotmega => TrySetAngles(target.PositionMetres, ref message),
            MavAutopilot.Px4 => TrySetPlace(target, ref message),
            _ => false,
        };
    }

    // Angles from straight below: what is not below the vehicle has none.
    private static bool TrySetAngles(BodyVector body, ref LandingTarget message)
    {
        if (!(body.Down > 0))
            return false;
        message.Frame = MavFrame.BodyFrd;
        message.AngleX = (float)Math.Atan(body.Right / body.Down);
        message.AngleY = (float)-Math.Atan(body.Forward / body.Down);
        return true;
    }

    private bool TrySetPlace(in LandingTargetObservation target, ref LandingTarget message)
    {
        if (_time is not { } known || (target.Time - known).Duration() > MaxExtrapolation)
            return false;
        NedVector vehicle = _position + ((target.Time - known).ExactSeconds * _velocity);
        NedVector place = vehicle + target.OffsetNedMetres;
        message.Frame = MavFrame.LocalNed;
        (message.X, message.Y, message.Z) = ((float)place.North, (float)place.East, (float)place.Down);
        message.Q = new FloatArray4([1, 0, 0, 0]);
        message.PositionValid = MavBool.True;
        return true;
    }
}
