using System;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

// What is reported of the vehicle's parts: battery, GPS, estimator, home, camera mount, the autopilot itself.
internal sealed partial class Px4Telemetry
{
    private const uint Firmware = 0x010E_00FF;   // 1.14.0, release
    private const int Satellites = 10;

    // As recorded from a simulated PX4 1.14: enabled on the ground and in the air, and what is healthy.
    private const uint Present = 0x0220_000D;
    private const uint Gps = 0x20;
    private const uint Enabled = 0x0221_000D;
    private const uint Healthy = 0x2220_801F;
    private const uint Prearm = 0x1000_0000;
    private const uint Radio = 0x0001_0000;
    private const uint BatteryBit = 0x0200_0000;
    private const uint Ahrs = 0x0020_0000;

    private const MavProtocolCapability Capabilities = MavProtocolCapability.MissionFloat
        | MavProtocolCapability.MissionInt | MavProtocolCapability.CommandInt
        | MavProtocolCapability.ParamEncodeBytewise | MavProtocolCapability.Ftp
        | MavProtocolCapability.SetPositionTargetLocalNed
        | MavProtocolCapability.SetPositionTargetGlobalInt | MavProtocolCapability.Mavlink2
        | MavProtocolCapability.MissionFence | MavProtocolCapability.MissionRally;

    private void SendSysStatus(int link)
    {
        bool hasSticks = controller.Situation.Sticks.WereReceived;
        uint present = Present | Gps | (hasSticks ? Radio : 0);
        uint health = Healthy | Gps | Prearm;
        if (hasSticks && !controller.Checks.IsManualControlLost)
            health |= Radio;
        if (controller.Checks.Charge != MavBatteryChargeState.Ok)
            health &= ~BatteryBit;
        if (!controller.Situation.HasPosition)
            health &= ~(Gps | Ahrs | Prearm);
        if (controller.Checks.PreventsArming)
            health &= ~Prearm;
        sink.Send(link, new SysStatus
        {
            OnboardControlSensorsPresent = (MavSysStatusSensor)present,
            OnboardControlSensorsEnabled = (MavSysStatusSensor)(Enabled | Gps),
            OnboardControlSensorsHealth = (MavSysStatusSensor)health,
            Load = 80,
            VoltageBattery = Millivolts(),
            CurrentBattery = Centiamperes(),
            BatteryRemaining = Percent(),
        });
    }

    private void SendBattery(int link)
    {
        var voltages = default(UInt16Array10);
        voltages[0] = Millivolts();
        for (int cell = 1; cell < voltages.Length; cell++)
            voltages[cell] = ushort.MaxValue;
        sink.Send(link, new BatteryStatus
        {
            Temperature = short.MaxValue,
            Voltages = voltages,
            CurrentBattery = Centiamperes(),
            CurrentConsumed = Scaled(_state.ConsumedAmpereHours, 1000),
            EnergyConsumed = Scaled(_state.ConsumedJoules, 0.01),
            BatteryRemaining = Percent(),
            ChargeState = controller.Checks.Charge,
        });
    }

    private void SendGps(int link)
    {
        bool hasFix = _state.HasPosition && !_state.HidesFix;
        GeodeticPosition place = hasFix ? frame.ToPlace(_state.Position) : default;
        double course = Math.Atan2(_state.Velocity.East, _state.Velocity.North) / NedMath.RadiansPerDegree;
        sink.Send(link, new GpsRawInt
        {
            TimeUsec = (ulong)_state.BootMicroseconds,
            FixType = hasFix ? GpsFixType.Type3dFix : GpsFixType.NoFix,
            Lat = DegE7(place.Latitude.Radians),
            Lon = DegE7(place.Longitude.Radians),
            Alt = Scaled(place.AltitudeAmslMetres, 1000),
            Eph = hasFix ? (ushort)70 : ushort.MaxValue,
            Epv = hasFix ? (ushort)110 : ushort.MaxValue,
            Vel = (ushort)(_state.Velocity.HorizontalLength() * 100),
            Cog = (ushort)((course < 0 ? course + 360 : course) * 100),
            SatellitesVisible = (byte)(hasFix ? Satellites : 0),
            AltEllipsoid = Scaled(place.AltitudeAmslMetres, 1000),
            HAcc = hasFix ? 900u : 0,
            VAcc = hasFix ? 1780u : 0,
            VelAcc = hasFix ? 250u : 0,
        });
    }

    private void SendEstimator(int link)
    {
        const EstimatorStatusFlags Level = EstimatorStatusFlags.Attitude | EstimatorStatusFlags.VelocityVert
            | EstimatorStatusFlags.PosVertAbs;
        const EstimatorStatusFlags Place = EstimatorStatusFlags.VelocityHoriz | EstimatorStatusFlags.PosHorizRel
            | EstimatorStatusFlags.PosHorizAbs | EstimatorStatusFlags.PredPosHorizRel
            | EstimatorStatusFlags.PredPosHorizAbs;
        bool hasPosition = controller.Situation.HasPosition;
        float ratio = (float)_state.EstimatorRatio;
        sink.Send(link, new EstimatorStatus
        {
            TimeUsec = (ulong)_state.BootMicroseconds,
            Flags = hasPosition ? Level | Place : Level,
            VelRatio = ratio,
            PosHorizRatio = ratio,
            PosVertRatio = ratio,
            MagRatio = 0.05f,
            PosHorizAccuracy = hasPosition ? 0.32f : float.NaN,
            PosVertAccuracy = 0.33f,
        });
    }

    // The velocity of the air. PX4 estimates it in flight, a multirotor by its drag (EKF2_DRAG_CTRL), and is silent
    // while it does not; the sum of the two variances, no accuracy.
    private bool TrySendWind(int link)
    {
        if (controller.Situation.IsLanded)
            return false;
        NedVector wind = _state.Velocity.Minus(_state.AirVelocity);
        return Send(link, new WindCov
        {
            TimeUsec = (ulong)_state.BootMicroseconds,
            WindX = (float)wind.North,
            WindY = (float)wind.East,
            VarHoriz = 0.1f,
            WindAlt = (float)(frame.Origin.AltitudeAmslMetres - _state.Position.Down),
        });
    }

    // The sticks are centred.
    private bool TrySendChannels(int link)
    {
        const ushort Centred = 1500;
        return IsRadioReceived && Send(link, new RcChannels
        {
            TimeBootMs = BootMilliseconds,
            Chancount = 4,
            Chan1Raw = Centred,
            Chan2Raw = Centred,
            Chan3Raw = Centred,
            Chan4Raw = Centred,
            Rssi = byte.MaxValue - 1,
        });
    }

    private bool TrySendHome(int link)
    {
        if (controller.Situation.Home is not { } home || Origin is not { } origin)
            return false;
        GeodeticPosition place = frame.ToPlace(home);
        NedVector local = home.Minus(origin);
        var q = default(FloatArray4);
        q[0] = 1;
        return Send(link, new HomePosition
        {
            Latitude = DegE7(place.Latitude.Radians),
            Longitude = DegE7(place.Longitude.Radians),
            Altitude = Scaled(place.AltitudeAmslMetres, 1000),
            X = (float)local.North,
            Y = (float)local.East,
            Z = (float)local.Down,
            Q = q,
            TimeUsec = (ulong)_state.BootMicroseconds,
        });
    }

    private bool TrySendOrigin(int link)
    {
        if (Origin is not { } origin)
            return false;
        GeodeticPosition place = frame.ToPlace(origin);
        return Send(link, new GpsGlobalOrigin
        {
            Latitude = DegE7(place.Latitude.Radians),
            Longitude = DegE7(place.Longitude.Radians),
            Altitude = Scaled(place.AltitudeAmslMetres, 1000),
            TimeUsec = (ulong)_state.BootMicroseconds,
        });
    }

    private AutopilotVersion Version()
        => new() { Capabilities = Capabilities, FlightSwVersion = Firmware, Uid = uid };

    // What is not known has a number of its own in each field.
    private sbyte Percent()
        => double.IsNaN(_state.BatteryRemaining) ? (sbyte)-1 : (sbyte)Math.Round(_state.BatteryRemaining * 100);

    private ushort Millivolts()
        => double.IsNaN(_state.BatteryVolts) ? ushort.MaxValue : (ushort)Math.Round(_state.BatteryVolts * 1000);

    private short Centiamperes()
        => double.IsNaN(_state.BatteryAmperes) ? (short)-1 : Short(_state.BatteryAmperes * 100);
}
