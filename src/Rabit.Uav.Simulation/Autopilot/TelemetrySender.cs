using System;
using Rabit.Mavlink.Messages;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>Sends the messages that report the vehicle's state, in the units of the wire.</summary>
internal sealed partial class TelemetrySender(FlightController controller, WorldFrame frame, ulong uid, IFrameSink sink)
{
    private const double DegE7PerRadian = 1e7 / NedMath.RadiansPerDegree;

    private AutopilotState _state;

    private uint BootMilliseconds => (uint)(_state.BootMicroseconds / 1000);

    /// <summary>Sends MISSION_CURRENT.</summary>
    public Action? ReportMission { get; set; }

    /// <summary>Where home is, metres in the world as the autopilot knows it; null before the first position.</summary>
    public NedVector? Home { get; set; }

    /// <summary>Where local positions count from; null before the first position.</summary>
    public NedVector? Origin { get; set; }

    public static bool IsKnown(int messageId)
        => messageId is Heartbeat.MavlinkId or SysStatus.MavlinkId or SystemTime.MavlinkId
            or GpsRawInt.MavlinkId or Attitude.MavlinkId or LocalPositionNed.MavlinkId or GlobalPositionInt.MavlinkId
            or VfrHud.MavlinkId or BatteryStatus.MavlinkId or AutopilotVersion.MavlinkId or Wind.MavlinkId
            or HomePosition.MavlinkId or ExtendedSysState.MavlinkId or GpsGlobalOrigin.MavlinkId
            or GimbalDeviceAttitudeStatus.MavlinkId or EkfStatusReport.MavlinkId or FenceStatus.MavlinkId
            or PositionTargetLocalNed.MavlinkId or PositionTargetGlobalInt.MavlinkId or ScaledPressure.MavlinkId
            or RcChannels.MavlinkId or MissionCurrent.MavlinkId or AvailableModes.MavlinkId;

    /// <summary>The state that the following messages report.</summary>
    public void Update(in AutopilotState state)
    {
        NedVector last = _state.Position;
        bool hadPosition = _state.HasPosition;
        _state = state;

        // It goes on reporting the place where it lost its position.
        if (!controller.HasPosition && hadPosition)
            (_state.Position, _state.Velocity) = (new NedVector(last.North, last.East, state.Position.Down), default);
    }

    /// <summary>Sends a message by its id; nothing where nothing is known yet.</summary>
    public void Send(int messageId)
    {
        switch (messageId)
        {
            case Heartbeat.MavlinkId: SendHeartbeat(); break;
            case SysStatus.MavlinkId: SendSysStatus(); break;
            case SystemTime.MavlinkId:
                sink.Send(new SystemTime { TimeUnixUsec = _state.UtcMicroseconds, TimeBootMs = BootMilliseconds });
                break;
            case GpsRawInt.MavlinkId: SendGps(); break;
            case Attitude.MavlinkId: SendAttitude(); break;
            case LocalPositionNed.MavlinkId: SendLocalPosition(); break;
            case GlobalPositionInt.MavlinkId: SendGlobalPosition(); break;
            case VfrHud.MavlinkId: SendHud(); break;
            case BatteryStatus.MavlinkId: SendBattery(); break;
            case AutopilotVersion.MavlinkId: SendVersion(); break;
            case Wind.MavlinkId: SendWind(); break;
            case HomePosition.MavlinkId: SendHome(); break;
            case ExtendedSysState.MavlinkId:
                sink.Send(new ExtendedSysState { VtolState = MavVtolState.Mc, LandedState = controller.LandedState });
                break;
            case GpsGlobalOrigin.MavlinkId: SendOrigin(); break;
            case GimbalDeviceAttitudeStatus.MavlinkId: sink.Send(_state.Gimbal.ToMessage(BootMilliseconds)); break;
            case EkfStatusReport.MavlinkId: SendEstimator(); break;
            case FenceStatus.MavlinkId: SendFence(); break;
            case ScaledPressure.MavlinkId: SendPressure(); break;
            case PositionTargetLocalNed.MavlinkId: SendLocalTarget(); break;
            case PositionTargetGlobalInt.MavlinkId: SendGlobalTarget(); break;
            case RcChannels.MavlinkId: SendChannels(); break;
            case MissionCurrent.MavlinkId: ReportMission?.Invoke(); break;
            case AvailableModes.MavlinkId: SendModes(0); break;
        }
    }

    private void SendHeartbeat()
    {
        MavModeFlag mode = MavModeFlag.CustomModeEnabled | MavModeFlag.StabilizeEnabled
            | MavModeFlag.ManualInputEnabled;
        if (CopterModes.IsGuidedFlag(controller.Mode, controller.IsArmed))
            mode |= MavModeFlag.GuidedEnabled;
        if (controller.IsArmed)
            mode |= MavModeFlag.SafetyArmed;
        sink.Send(new Heartbeat
        {
            Type = MavType.Quadrotor,
            Autopilot = MavAutopilot.Ardupilotmega,
            BaseMode = mode,
            CustomMode = (uint)controller.Mode,
            SystemStatus = controller.Status,
            MavlinkVersion = 3,
        });
    }

    private void SendAttitude() => sink.Send(new Attitude
    {
        TimeBootMs = BootMilliseconds,
        Roll = (float)_state.Attitude.Roll.Radians,
        Pitch = (float)_state.Attitude.Pitch.Radians,
        Yaw = (float)_state.Attitude.Yaw.Radians,
        Rollspeed = (float)_state.Rates.RollRadiansPerSecond,
        Pitchspeed = (float)_state.Rates.PitchRadiansPerSecond,
        Yawspeed = (float)_state.Rates.YawRadiansPerSecond,
    });

    // Latitude and longitude are both zero until it knows where it is.
    private void SendGlobalPosition()
    {
        GeodeticPosition place = _state.HasPosition && !_state.HidesPlace ? frame.ToPlace(_state.Position) : default;
        sink.Send(new GlobalPositionInt
        {
            TimeBootMs = BootMilliseconds,
            Lat = DegE7(place.Latitude.Radians),
            Lon = DegE7(place.Longitude.Radians),
            Alt = Scaled(place.AltitudeAmslMetres, 1000),
            RelativeAlt = _state.HasPosition && Home is { } home ? Scaled(home.Down - _state.Position.Down, 1000) : 0,
            Vx = Short(_state.Velocity.North * 100),
            Vy = Short(_state.Velocity.East * 100),
            Vz = Short(_state.Velocity.Down * 100),
            Hdg = (ushort)(Heading() * 100),
        });
    }

    private void SendLocalPosition()
    {
        if (!_state.HasPosition || Origin is not { } origin)
            return;
        NedVector local = _state.Position.Minus(origin);
        sink.Send(new LocalPositionNed
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

    private void SendHud()
    {
        sink.Send(new VfrHud
        {
            Airspeed = (float)_state.AirVelocity.HorizontalLength(),
            Groundspeed = (float)_state.Velocity.HorizontalLength(),
            Heading = (short)Heading(),
            Throttle = (ushort)(controller.Situation.IsLanded ? 0 : 35),
            Alt = (float)(frame.Origin.AltitudeAmslMetres - _state.Position.Down),
            Climb = (float)-_state.Velocity.Down,
        });
    }

    private void SendWind()
    {
        NedVector wind = _state.Velocity.Minus(_state.AirVelocity);
        sink.Send(new Wind
        {
            // Where it comes from.
            Direction = (float)(Math.Atan2(-wind.East, -wind.North) / NedMath.RadiansPerDegree),
            Speed = (float)wind.HorizontalLength(),
        });
    }

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
