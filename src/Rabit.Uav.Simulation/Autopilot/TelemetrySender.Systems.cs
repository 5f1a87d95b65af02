using System;
using Rabit.Mavlink.Messages;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

// What is reported of the vehicle's parts: battery, GPS, home, the autopilot itself.
internal sealed partial class TelemetrySender
{
    private const uint Firmware = 0x0407_0000;   // 4.7.0-dev, which the recorded flight has too
    private const int Satellites = 10;

    private const MavSysStatusSensor Sensors = MavSysStatusSensor.Sensor3dGyro | MavSysStatusSensor.Sensor3dAccel
        | MavSysStatusSensor.Sensor3dMag
        | MavSysStatusSensor.AbsolutePressure | MavSysStatusSensor.Gps | MavSysStatusSensor.AngularRateControl
        | MavSysStatusSensor.AttitudeStabilization
        | MavSysStatusSensor.YawPosition | MavSysStatusSensor.ZAltitudeControl | MavSysStatusSensor.XyPositionControl
        | MavSysStatusSensor.MotorOutputs
        | MavSysStatusSensor.RcReceiver
        | MavSysStatusSensor.Ahrs | MavSysStatusSensor.Battery | MavSysStatusSensor.PrearmCheck;

    private const MavProtocolCapability Capabilities = MavProtocolCapability.ParamFloat
        | MavProtocolCapability.MissionFloat | MavProtocolCapability.MissionInt | MavProtocolCapability.CommandInt
        | MavProtocolCapability.Ftp | MavProtocolCapability.MissionFence | MavProtocolCapability.MissionRally
        | MavProtocolCapability.SetPositionTargetLocalNed | MavProtocolCapability.SetPositionTargetGlobalInt
        | MavProtocolCapability.Mavlink2
        | MavProtocolCapability.ParamEncodeCCast;

    private void SendSysStatus()
    {
        MavSysStatusSensor health = Sensors;
        MavSysStatusSensor enabled = Sensors;
        Failsafes failsafes = controller.Failsafes;
        if (!_state.HasPosition)
            health &= ~(MavSysStatusSensor.Gps | MavSysStatusSensor.XyPositionControl | MavSysStatusSensor.PrearmCheck);
        else if (!controller.HasPosition)
            (enabled, health) = (enabled & ~MavSysStatusSensor.XyPositionControl,
                health & ~MavSysStatusSensor.XyPositionControl);
        if (failsafes.Battery.IsOn)
            health &= ~MavSysStatusSensor.Battery;
        if (failsafes.Radio.IsOn)
            health &= ~MavSysStatusSensor.RcReceiver;
        if (!controller.IsArmed && !controller.IsReadyToArm)
            health &= ~MavSysStatusSensor.PrearmCheck;
        if (failsafes.Fence.IsEnabled)
            enabled |= MavSysStatusSensor.Geofence;
        if (failsafes.Fence.Breached == FenceKinds.None)
            health |= MavSysStatusSensor.Geofence;
        sink.Send(new SysStatus
        {
            OnboardControlSensorsPresent = Sensors | MavSysStatusSensor.Geofence,
            OnboardControlSensorsEnabled = enabled,
            OnboardControlSensorsHealth = health,
            Load = 200,
            VoltageBattery = Millivolts(),
            CurrentBattery = Centiamperes(),
            BatteryRemaining = Percent(),
        });
    }

    private void SendBattery()
    {
        var voltages = default(UInt16Array10);
        voltages[0] = Millivolts();
        for (int cell = 1; cell < voltages.Length; cell++)
            voltages[cell] = ushort.MaxValue;
        sink.Send(new BatteryStatus
        {
            Temperature = short.MaxValue,
            Voltages = voltages,
            CurrentBattery = Centiamperes(),
            CurrentConsumed = Scaled(_state.ConsumedAmpereHours, 1000),
            EnergyConsumed = Scaled(_state.ConsumedJoules, 0.01),
            BatteryRemaining = Percent(),
            ChargeState = controller.Failsafes.Battery.Level switch
            {
                BatteryLevel.Critical => MavBatteryChargeState.Critical,
                BatteryLevel.Low => MavBatteryChargeState.Low,
                _ => MavBatteryChargeState.Ok,
            },
        });
    }

    private void SendGps()
    {
        bool hasFix = _state.HasPosition && _state.HasGps && !_state.HidesFix;
        GeodeticPosition place = hasFix
            ? frame.ToPlace(_state.Position.Plus(
                new NedVector(_state.GpsErrorNorth, 0, -_state.BarometerErrorDown)))
            : default;
        double course = Math.Atan2(_state.Velocity.East, _state.Velocity.North) / NedMath.RadiansPerDegree;
        sink.Send(new GpsRawInt
        {
            TimeUsec = (ulong)_state.BootMicroseconds,
            FixType = hasFix ? GpsFixType.Type3dFix : GpsFixType.NoFix,
            Lat = DegE7(place.Latitude.Radians),
            Lon = DegE7(place.Longitude.Radians),
            Alt = Scaled(place.AltitudeAmslMetres, 1000),
            Eph = hasFix ? (ushort)121 : ushort.MaxValue,
            Epv = hasFix ? (ushort)200 : ushort.MaxValue,
            Vel = (ushort)(_state.Velocity.HorizontalLength() * 100),
            Cog = (ushort)((course < 0 ? course + 360 : course) * 100),
            SatellitesVisible = (byte)(hasFix ? Satellites : 0),
            AltEllipsoid = Scaled(place.AltitudeAmslMetres, 1000),
            HAcc = hasFix ? 1500u : 0,
            VAcc = hasFix ? 1500u : 0,
            VelAcc = hasFix ? 200u : 0,
        });
    }

    private void SendHome()
    {
        if (Home is not { } home || Origin is not { } origin)
            return;
        GeodeticPosition place = frame.ToPlace(home);
        NedVector local = home.Minus(origin);
        sink.Send(new HomePosition
        {
            Latitude = DegE7(place.Latitude.Radians),
            Longitude = DegE7(place.Longitude.Radians),
            Altitude = Scaled(place.AltitudeAmslMetres, 1000),
            X = (float)local.North,
            Y = (float)local.East,
            Z = (float)local.Down,
            Q = NotKnown(),
            TimeUsec = (ulong)_state.BootMicroseconds,
        });
    }

    private void SendOrigin()
    {
        if (Origin is not { } origin)
            return;
        GeodeticPosition place = frame.ToPlace(origin);
        sink.Send(new GpsGlobalOrigin
        {
            Latitude = DegE7(place.Latitude.Radians),
            Longitude = DegE7(place.Longitude.Radians),
            Altitude = Scaled(place.AltitudeAmslMetres, 1000),
            TimeUsec = (ulong)_state.BootMicroseconds,
        });
    }

    private void SendVersion()
        => sink.Send(new AutopilotVersion { Capabilities = Capabilities, FlightSwVersion = Firmware, Uid = uid });

    // What is not known has a number of its own in each field.
    private sbyte Percent()
        => double.IsNaN(_state.BatteryRemaining) ? (sbyte)-1 : (sbyte)Math.Round(_state.BatteryRemaining * 100);

    private ushort Millivolts()
        => double.IsNaN(_state.BatteryVolts) ? ushort.MaxValue : (ushort)Math.Round(_state.BatteryVolts * 1000);

    private short Centiamperes()
        => double.IsNaN(_state.BatteryAmperes) ? (short)-1 : Short(_state.BatteryAmperes * 100);

    private static FloatArray4 NotKnown()
    {
        var q = default(FloatArray4);
        for (int index = 0; index < q.Length; index++)
            q[index] = float.NaN;
        return q;
    }
}
