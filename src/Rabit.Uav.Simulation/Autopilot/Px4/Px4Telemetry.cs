using System;
using Rabit.Geodesy;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>Sends the messages that report the vehicle's state, in the units of the wire.</summary>
internal sealed partial class Px4Telemetry(
    Px4Controller controller, Px4Links links, WorldFrame frame, ulong uid, ILinkSink sink)
{
    private const double DegE7PerRadian = 1e7 / NedMath.RadiansPerDegree;

    private AutopilotState _state;

    private uint BootMilliseconds => (uint)(_state.BootMicroseconds / 1000);

    /// <summary>Sends MISSION_CURRENT.</summary>
    public Action<int>? ReportMission { get; set; }

    /// <summary>Whether a remote control is connected and in use.</summary>
    public bool IsRadioReceived { get; set; }

    /// <summary>Where local positions count from; null before the first position.</summary>
    public NedVector? Origin { get; private set; }

    /// <summary>Whether it can be asked for, at intervals or once.</summary>
    public static bool IsKnown(int messageId)
        => messageId is Heartbeat.MavlinkId or SysStatus.MavlinkId or SystemTime.MavlinkId or GpsRawInt.MavlinkId
            or Attitude.MavlinkId or LocalPositionNed.MavlinkId or GlobalPositionInt.MavlinkId or VfrHud.MavlinkId
            or PositionTargetLocalNed.MavlinkId or PositionTargetGlobalInt.MavlinkId or Altitude.MavlinkId
            or BatteryStatus.MavlinkId or AutopilotVersion.MavlinkId or HomePosition.MavlinkId
            or ExtendedSysState.MavlinkId or EstimatorStatus.MavlinkId or GpsGlobalOrigin.MavlinkId
            or Timesync.MavlinkId or GimbalDeviceAttitudeStatus.MavlinkId or WindCov.MavlinkId
            or ScaledPressure.MavlinkId or RcChannels.MavlinkId or MissionCurrent.MavlinkId;

    /// <summary>The state that the following messages report.</summary>
    public void Update(in AutopilotState state)
    {
        _state = state;
        if (state.HasPosition)
            Origin ??= controller.Situation.Home;
    }

    /// <summary>Sends a message over all links.</summary>
    public void SendAll(int messageId)
    {
        for (int link = 0; link < links.Count; link++)
            TrySend(messageId, link);
    }

    /// <summary>Sends a message; false where there is nothing to say.</summary>
    public bool TrySend(int messageId, int link)
    {
        switch (messageId)
        {
            case Heartbeat.MavlinkId: SendHeartbeat(link); return true;
            case SysStatus.MavlinkId: SendSysStatus(link); return true;
            case SystemTime.MavlinkId:
                return Send(link, new SystemTime
                {
                    TimeUnixUsec = _state.UtcMicroseconds,
                    TimeBootMs = BootMilliseconds,
                });
            case GpsRawInt.MavlinkId: SendGps(link); return true;
            case Attitude.MavlinkId: SendAttitude(link); return true;
            case LocalPositionNed.MavlinkId: return TrySendLocalPosition(link);
            case GlobalPositionInt.MavlinkId: return TrySendGlobalPosition(link);
            case VfrHud.MavlinkId: SendHud(link); return true;
            case PositionTargetLocalNed.MavlinkId: SendLocalTarget(link); return true;
            case PositionTargetGlobalInt.MavlinkId: return TrySendGlobalTarget(link);
            case Altitude.MavlinkId: SendAltitude(link); return true;
            case BatteryStatus.MavlinkId: SendBattery(link); return true;
            case AutopilotVersion.MavlinkId: return Send(link, Version());
            case HomePosition.MavlinkId: return TrySendHome(link);
            case ExtendedSysState.MavlinkId:
                return Send(link, new ExtendedSysState
                {
                    LandedState = controller.LandedState,
                });
            case EstimatorStatus.MavlinkId: SendEstimator(link); return true;
            case GpsGlobalOrigin.MavlinkId: return TrySendOrigin(link);
            case Timesync.MavlinkId: return Send(link, new Timesync { Ts1 = _state.BootMicroseconds * 1000 });
            case GimbalDeviceAttitudeStatus.MavlinkId:
                return Send(link, _state.Gimbal.ToMessage(BootMilliseconds));
            case WindCov.MavlinkId: return TrySendWind(link);
            case RcChannels.MavlinkId: return TrySendChannels(link);
            case MissionCurrent.MavlinkId: ReportMission?.Invoke(link); return true;
            case ScaledPressure.MavlinkId:
                return Send(link, new ScaledPressure
                {
                    TimeBootMs = BootMilliseconds,
                    PressAbs = (float)StandardAtmosphere.PressureAt(
                        frame.Origin.AltitudeAmslMetres - _state.TrueDown),
                });
            default: return false;
        }
    }

    private bool Send<T>(int link, in T message)
        where T : struct, IMavlinkMessage
    {
        sink.Send(link, message);
        return true;
    }

    private void SendHeartbeat(int link) => sink.Send(link, new Heartbeat
    {
        Type = MavType.Quadrotor,
        Autopilot = MavAutopilot.Px4,
        BaseMode = Px4ModeNames.BaseMode(controller.Mode, controller.IsArmed),
        CustomMode = (uint)controller.Mode,
        SystemStatus = controller.Status,
        MavlinkVersion = 3,
    });

    private void SendAttitude(int link) => sink.Send(link, new Attitude
    {
        TimeBootMs = BootMilliseconds,
        Roll = (float)_state.Attitude.Roll.Radians,
        Pitch = (float)_state.Attitude.Pitch.Radians,
        Yaw = (float)_state.Attitude.Yaw.Radians,
        Rollspeed = (float)_state.Rates.RollRadiansPerSecond,
        Pitchspeed = (float)_state.Rates.PitchRadiansPerSecond,
        Yawspeed = (float)_state.Rates.YawRadiansPerSecond,
    });

    // Recorded: none while the position is not valid.
    private bool TrySendGlobalPosition(int link)
    {
        if (!_state.HasPosition)
            return false;
        GeodeticPosition place = _state.HidesPlace ? default : frame.ToPlace(_state.Position);
        return Send(link, new GlobalPositionInt
        {
            TimeBootMs = BootMilliseconds,
            Lat = DegE7(place.Latitude.Radians),
            Lon = DegE7(place.Longitude.Radians),
            Alt = Scaled(place.AltitudeAmslMetres, 1000),
            RelativeAlt = controller.Situation.Home is { } home
                ? Scaled(home.Down - _state.Position.Down, 1000)
                : 0,
            Vx = Short(_state.Velocity.North * 100),
            Vy = Short(_state.Velocity.East * 100),
            Vz = Short(_state.Velocity.Down * 100),
            Hdg = (ushort)(Heading() * 100),
        });
    }

    private bool TrySendLocalPosition(int link)
    {
        if (!_state.HasPosition || Origin is not { } origin)
            return false;
        NedVector local = _state.Position.Minus(origin);
        return Send(link, new LocalPositionNed
        {
            TimeBootMs = BootMilliseconds,
            X = (float)local.North,
            Y = (float)local.East,
            Z = (float)local.Down,
            Vx = (float)_state.Velocity.North,
            Vy = (float)_state.Velocity.East,
            Vz = (float)_state.Velocity.Down,
        });
    }

    private void SendHud(int link) => sink.Send(link, new VfrHud
    {
        Airspeed = (float)_state.AirVelocity.HorizontalLength(),
        Groundspeed = (float)_state.Velocity.HorizontalLength(),
        Heading = (short)Heading(),
        Throttle = (ushort)(controller.Situation.IsLanded ? 0 : 50),
        Alt = (float)(frame.Origin.AltitudeAmslMetres - _state.Position.Down),
        Climb = (float)-_state.Velocity.Down,
    });

    private void SendAltitude(int link) => sink.Send(link, new Altitude
    {
        TimeUsec = (ulong)_state.BootMicroseconds,
        AltitudeMonotonic = (float)(frame.Origin.AltitudeAmslMetres - _state.Position.Down),
        AltitudeAmsl = (float)(frame.Origin.AltitudeAmslMetres - _state.Position.Down),
        AltitudeLocal = (float)((Origin ?? default).Down - _state.Position.Down),
        AltitudeRelative = (float)((controller.Situation.Home ?? default).Down - _state.Position.Down),
        AltitudeTerrain = float.NaN,
        BottomClearance = float.NaN,
    });

    private double Heading()
    {
        double degrees = _state.Attitude.Yaw.Degrees;
        return degrees < 0 ? degrees + 360 : degrees;
    }

    private static int DegE7(double radians) => (int)Math.Round(radians * DegE7PerRadian);

    private static int Scaled(double value, double scale) => (int)Math.Round(value * scale);

    private static short Short(double value)
        => (short)NedMath.Limited(Math.Round(value), short.MinValue, short.MaxValue);
}
