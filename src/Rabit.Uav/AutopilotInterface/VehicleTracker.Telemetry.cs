using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

// Telemetry: the messages that make up the state, from the units of the wire to SI and radians.
internal sealed partial class VehicleTracker
{
    private const double RadiansPerDegE7 = Angle.RadiansPerDegree * 1e-7;
    private const int NorthPoleDegE7 = 900_000_000;
    private const int DateLineDegE7 = 1_800_000_000;
    private const double MillimetresPerMetre = 1000;

    // Nothing that we fly with is outside.
    private const double MinAltitudeMetres = -1000;
    private const double MaxAltitudeMetres = 20_000;

    // A clock that says less is not set, one that says more is wrong: 2000-01-01 and 2100-01-01 UTC in microseconds
    // since 1970.
    private const ulong EarliestUtc = 946_684_800_000_000;
    private const ulong MaxUtc = 4_102_444_800_000_000;

    // No wind at the ground was ever stronger (WMO: 113 m/s, Barrow Island, 1996).
    private const float StrongestWind = 113;

    public VehicleEvents Update(in LinkFrame frame, in GlobalPositionInt message)
        => Begin(frame, out VehicleEvents events) ? Complete(frame, events | Apply(message, frame.Time)) : events;

    public VehicleEvents Update(in LinkFrame frame, in Attitude message)
        => Begin(frame, out VehicleEvents events) ? Complete(frame, events | Apply(message, frame.Time)) : events;

    public VehicleEvents Update(in LinkFrame frame, in SysStatus message)
        => Begin(frame, out VehicleEvents events)
            ? Complete(frame, events | Apply(message, frame.Time))
            : events;

    public VehicleEvents Update(in LinkFrame frame, in BatteryStatus message)
        => Begin(frame, out VehicleEvents events) ? Complete(frame, events | Apply(message, frame.Time)) : events;

    public VehicleEvents Update(in LinkFrame frame, in GpsRawInt message)
        => Begin(frame, out VehicleEvents events) ? Complete(frame, events | Apply(message, frame.Time)) : events;

    public VehicleEvents Update(in LinkFrame frame, in SystemTime message)
        => Begin(frame, out VehicleEvents events) ? Complete(frame, events | Apply(message, frame.Time)) : events;

    public VehicleEvents Update(in LinkFrame frame, in ExtendedSysState message)
        => Begin(frame, out VehicleEvents events) ? Complete(frame, events | Apply(message, frame.Time)) : events;

    public VehicleEvents Update(in LinkFrame frame, in EkfStatusReport message)
        => Begin(frame, out VehicleEvents events)
            ? Complete(frame, events | ApplyEstimator(Converted(message.Flags), frame.Time))
            : events;

    public VehicleEvents Update(in LinkFrame frame, in EstimatorStatus message)
        => Begin(frame, out VehicleEvents events)
            ? Complete(frame, events | ApplyEstimator(message.Flags, frame.Time))
            : events;

    public VehicleEvents Update(in LinkFrame frame, in Wind message)
        => Begin(frame, out VehicleEvents events) ? Complete(frame, events | Apply(message, frame.Time)) : events;

    public VehicleEvents Update(in LinkFrame frame, in WindCov message)
        => Begin(frame, out VehicleEvents events) ? Complete(frame, events | Apply(message, frame.Time)) : events;

    private VehicleEvents Apply(in GlobalPositionInt message, TimeSpan time)
    {
        BootTimeMs = message.TimeBootMs;

        // Both exactly zero is what an autopilot sends that does not know where it is.
        bool isPlace = message.Lat is >= -NorthPoleDegE7 and <= NorthPoleDegE7
            && message.Lon is >= -DateLineDegE7 and <= DateLineDegE7
            && (message.Lat != 0 || message.Lon != 0);
        if (!isPlace)
            return VehicleEvents.Refused;

        _state.PositionTime = time;
        _state.Position = GeodeticPosition.FromRadians(
            message.Lat * RadiansPerDegE7, message.Lon * RadiansPerDegE7, message.Alt / 1000.0);
        _state.HeightAboveHomeMetres = message.RelativeAlt / 1000.0;
        _state.VelocityNed = new NedVector(message.Vx / 100.0, message.Vy / 100.0, message.Vz / 100.0);
        return VehicleEvents.Changed;
    }

    private VehicleEvents Apply(in Attitude message, TimeSpan time)
    {
        BootTimeMs = message.TimeBootMs;
        bool isValid = IsAngle(message.Roll) && IsAngle(message.Pitch) && Math.Abs(message.Pitch) < Math.PI / 2 + 1e-3
            && IsAngle(message.Yaw)
            && IsFinite(message.Rollspeed) && IsFinite(message.Pitchspeed) && IsFinite(message.Yawspeed);
        if (!isValid)
            return VehicleEvents.Refused;

        _state.AttitudeTime = time;
        _state.Attitude = EulerAngles.FromRadians(Wrapped(message.Roll), message.Pitch, Wrapped(message.Yaw));
        _state.Rates = BodyRates.FromRadiansPerSecond(message.Rollspeed, message.Pitchspeed, message.Yawspeed);
        return VehicleEvents.Changed;
    }

    private VehicleEvents Apply(in SysStatus message, TimeSpan time)
    {
        const MavSysStatusSensor Battery = MavSysStatusSensor.Battery;
        _state.IsBatteryUnhealthy = (message.OnboardControlSensorsPresent & message.OnboardControlSensorsEnabled
            & ~message.OnboardControlSensorsHealth & Battery) != 0;
        return Apply(_battery.Take(message, time));
    }

    // The other batteries are not ours to watch.
    private VehicleEvents Apply(in BatteryStatus message, TimeSpan time)
    {
        if (message.Id != 0)
            return VehicleEvents.None;
        _state.BatteryCells = BatteryTracker.Cells(message);
        _state.BatteryChargeState = message.ChargeState;
        _state.BatteryFaults = message.FaultBitmask;
        return Apply(_battery.Take(message, time));
    }

    private VehicleEvents Apply(in BatteryReading battery)
    {
        _state.BatteryTime = battery.Time;
        _state.BatteryVolts = battery.Volts;
        _state.BatteryAmperes = battery.Amperes;
        _state.BatteryRemaining = battery.Remaining;
        _state.BatteryConsumedAmpereHours = battery.ConsumedAmpereHours;
        return VehicleEvents.Changed;
    }

    private VehicleEvents Apply(in GpsRawInt message, TimeSpan time)
    {
        _state.GpsTime = time;
        _state.GpsFix = message.FixType;
        _state.Satellites = message.SatellitesVisible;
        double altitude = message.Alt / MillimetresPerMetre;
        bool isKnown = message.FixType is >= GpsFixType.Type3dFix and <= GpsFixType.Ppp
            && altitude is >= MinAltitudeMetres and <= MaxAltitudeMetres;
        _state.GnssAltitudeAmslMetres = isKnown ? altitude : null;
        _state.GnssAltitudeSigmaMetres = isKnown && message.VAcc > 0 ? message.VAcc / MillimetresPerMetre : null;
        return VehicleEvents.Changed;
    }

    private VehicleEvents Apply(in SystemTime message, TimeSpan time)
    {
        _state.UtcTime = time;
        _state.GpsUtcMicroseconds = message.TimeUnixUsec is >= EarliestUtc and <= MaxUtc
            ? (long)message.TimeUnixUsec
            : 0;
        BootTimeMs = message.TimeBootMs;
        return VehicleEvents.Changed;
    }

    private VehicleEvents Apply(in ExtendedSysState message, TimeSpan time)
    {
        _state.LandedState = message.LandedState;
        _state.LandedStateTime = time;
        return VehicleEvents.Changed;
    }

    private VehicleEvents ApplyEstimator(EstimatorStatusFlags flags, TimeSpan time)
    {
        _state.EstimatorFlags = flags;
        _state.EstimatorTime = time;
        return VehicleEvents.Changed;
    }

    // Bits 0 to 9 mean the same in both (EKF_STATUS_FLAGS, ESTIMATOR_STATUS_FLAGS), those above do not.
    private static EstimatorStatusFlags Converted(EkfStatusFlags flags)
    {
        if ((flags & EkfStatusFlags.Uninitialized) != 0)
            return 0;
        var same = (EstimatorStatusFlags)((int)flags & 0x3FF);
        return (flags & EkfStatusFlags.GpsGlitching) != 0 ? same | EstimatorStatusFlags.GpsGlitch : same;
    }

    private VehicleEvents Apply(in Wind message, TimeSpan time)
    {
        if (!(message.Speed >= 0) || !(Math.Abs(message.Direction) <= 360))
            return VehicleEvents.Refused;

        // Where it comes from, clockwise from north.
        double from = message.Direction * Angle.RadiansPerDegree;
        return ApplyWind(-message.Speed * Trig.Cos(from), -message.Speed * Trig.Sin(from), time);
    }

    // The velocity of the air. Of its variances one is a square and the other always 0 in PX4, unlike the definition:
    // not used.
    private VehicleEvents Apply(in WindCov message, TimeSpan time) => ApplyWind(message.WindX, message.WindY, time);

    // Exactly nothing is what ArduPilot sends that has no estimate, on the ground and without drag coefficients: it is
    // not known then, and does not say that the air is still.
    private VehicleEvents ApplyWind(double north, double east, TimeSpan time)
    {
        var velocity = new NedVector(north, east, 0);
        double speed = velocity.HorizontalLength;
        if (speed == 0)
            return VehicleEvents.None;
        if (!(speed <= StrongestWind))
            return VehicleEvents.Refused;
        (_state.WindTime, _state.WindVelocityNed) = (time, velocity);
        return VehicleEvents.Changed;
    }

    private static bool IsFinite(float value) => !float.IsNaN(value) && !float.IsInfinity(value);

    // Some autopilots count yaw from 0 to 2 pi; more than one turn is no angle.
    private static bool IsAngle(float radians) => Math.Abs(radians) <= 2 * Math.PI + 1e-3;

    private static double Wrapped(double radians) => Math.IEEERemainder(radians, 2 * Math.PI);
}
