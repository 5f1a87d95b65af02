using System;
using System.Globalization;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;

namespace UavConsole;

/// <summary>
/// The words of the screen, beside those of FlightText. Degrees, metres, seconds: here is the edge where radians end.
/// </summary>
internal static class Text
{
    public static string Of(StatusText text)
        => $"{text.Severity.ToString().ToLowerInvariant()}: {FlightText.Printable(text.Text)}";

    public static string Vehicle(in VehicleState vehicle) => vehicle.SystemId == 0
        ? "no autopilot connected yet"
        : $"{FlightText.Autopilot(vehicle.Autopilot)} {vehicle.VehicleType} {vehicle.SystemId}/{vehicle.ComponentId}, "
            + $"{(vehicle.IsConnected ? "connected" : "LOST")}";

    public static string Flight(in VehicleState vehicle) => vehicle.SystemId == 0
        ? "-"
        : $"{vehicle.Mode}, {(vehicle.IsArmed ? "ARMED" : "disarmed")}, {vehicle.SystemStatus}";

    public static string Position(in VehicleState vehicle) => vehicle.PositionTime is null ? "-" : string.Format(
        CultureInfo.InvariantCulture,
        "{0:0.000000} {1:0.000000}, {2:0.0} m AMSL, {3:0.0} m above home",
        Angle.FromRadians(vehicle.Position.Latitude.Radians).Degrees,
        Angle.FromRadians(vehicle.Position.Longitude.Radians).Degrees,
        vehicle.Position.AltitudeAmslMetres,
        vehicle.HeightAboveHomeMetres);

    public static string Velocity(in VehicleState vehicle) => vehicle.PositionTime is null ? "-" : string.Format(
        CultureInfo.InvariantCulture,
        "north {0:0.0} east {1:0.0} down {2:0.0} m/s",
        vehicle.VelocityNed.North,
        vehicle.VelocityNed.East,
        vehicle.VelocityNed.Down);

    public static string Attitude(in VehicleState vehicle) => vehicle.AttitudeTime is null ? "-" : string.Format(
        CultureInfo.InvariantCulture,
        "roll {0:0.0} pitch {1:0.0} yaw {2:0.0} degrees",
        Angle.FromRadians(vehicle.Attitude.Roll.Radians).Degrees,
        Angle.FromRadians(vehicle.Attitude.Pitch.Radians).Degrees,
        Angle.FromRadians(vehicle.Attitude.Yaw.Radians).Degrees);

    public static string Battery(in VehicleState vehicle) => vehicle.BatteryTime is null ? "-" : string.Format(
        CultureInfo.InvariantCulture,
        "{0} {1} {2}",
        OrUnknown(vehicle.BatteryVolts, "0.0 V"),
        OrUnknown(vehicle.BatteryAmperes, "0.0 A"),
        OrUnknown(vehicle.BatteryRemaining * 100, "0'%'"));

    public static string Energy(in EnergyStatus energy) => !energy.IsKnown ? "-" : string.Format(
        CultureInfo.InvariantCulture,
        "{0:0} % left, home takes {1:0} %, {2:0} kept; {3}",
        energy.ChargeLeft * 100,
        energy.ChargeHome * 100,
        energy.Reserve * 100,
        energy.MustReturn ? "has to return" : "returns in " + FlightText.Clock(energy.TimeToReturn));

    public static string Gps(in VehicleState vehicle) => vehicle.GpsTime is null
        ? "-"
        : $"{vehicle.GpsFix}, "
            + $"{(vehicle.Satellites == 255 ? "?" : vehicle.Satellites.ToString(CultureInfo.InvariantCulture))} "
            + "satellites";

    public static string Link(in LinkStatus link) => string.Format(
        CultureInfo.InvariantCulture,
        "{0}: {1} frames in, {2} out, {3} missing, {4} bytes lost, {5} dropped{6}",
        link.State,
        link.FramesIn,
        link.FramesOut,
        link.FramesMissing,
        link.BytesLost,
        link.FramesDroppedIn + link.FramesDroppedOut,
        link.Fault is null ? string.Empty : ", " + link.Fault);

    public static string StatusLine(FlightMonitor monitor)
    {
        VehicleState vehicle = monitor.Vehicle;
        string progress = monitor.Progress is { } p
            ? string.Format(CultureInfo.InvariantCulture, "{0:0}% ", p * 100)
            : string.Empty;
        string links = string.Join("; ", monitor.Links.Select(l => Link(l)));
        return FlightText.TimeStamp(monitor.Now) + progress
            + $"{Vehicle(vehicle)}; {Flight(vehicle)}; {Position(vehicle)}; {links}";
    }

    public static string Mission(FlightMonitor monitor)
    {
        MissionStatus mission = monitor.Record.Mission;
        if (mission.Phase == MissionPhase.WaitingForVehicle)
            return mission.Text ?? "waiting for the vehicle";
        return string.Format(
            CultureInfo.InvariantCulture,
            "{0}, lane {1} of {2}, {3:0.0} % covered, {4} targets, {5:0.0} times real time",
            FlightText.Phase(mission.Phase),
            mission.LanesFlown,
            (mission.Plan?.Lanes.Length ?? 0) / 2,
            mission.Coverage * 100,
            monitor.Record.Tracks.Confirmed.Count(),
            monitor.Pace);
    }

    /// <summary>Exactly so wide: cut off with an ellipsis, or filled with blanks.</summary>
    public static string Fit(string text, int width)
        => text.Length > width ? text.Remove(Math.Max(0, width - 1)) + "…" : text.PadRight(width);

    private static string OrUnknown(double value, string format)
        => double.IsNaN(value) ? "?" : value.ToString(format, CultureInfo.InvariantCulture);
}
