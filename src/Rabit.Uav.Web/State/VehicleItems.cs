using System;
using System.Globalization;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.Web.Collecting;

namespace Rabit.Uav.Web.State;

/// <summary>
/// Vehicle, mission, energy, wind, health and camera as values of the page. Degrees and per cent: the edge where
/// radians end.
/// </summary>
internal sealed class VehicleItems(string prefix)
{
    private const int MaxOthers = 16;

    private int _others;

    public void Write(ItemWriter writer, PageState state, FlightMoment moment)
    {
        WriteVehicle(writer, moment);
        WriteMission(writer, moment.Mission);
        WriteEnergy(writer, moment.Mission.Energy, moment.Vehicle);
        WriteWind(writer, moment.Vehicle);
        WriteHealth(writer, moment.Health);
        WriteCamera(writer, moment.Imaging);
        WriteOthers(writer, state, moment);
    }

    private void WriteVehicle(ItemWriter writer, FlightMoment moment)
    {
        VehicleState vehicle = moment.Vehicle;
        bool hasPlace = vehicle.PositionTime is not null;
        writer.Object(prefix + "/vehicle").Number("t", moment.Time.TotalSeconds, 1)
            .Flag("connected", vehicle.IsConnected).Flag("armed", vehicle.IsArmed)
            .Text("mode", vehicle.Mode, 40).Count("system", vehicle.SystemId)
            .Text("type", vehicle.SystemId == 0 ? null : $"{vehicle.Autopilot} {vehicle.VehicleType}", 60)
            .Number("lat", hasPlace ? vehicle.Position.Latitude.Degrees : double.NaN, 7)
            .Number("lon", hasPlace ? vehicle.Position.Longitude.Degrees : double.NaN, 7)
            .Number("height", hasPlace ? vehicle.HeightAboveHomeMetres : double.NaN, 1)
            .Number("amsl", hasPlace ? vehicle.Position.AltitudeAmslMetres : double.NaN, 1)
            .Number("speed", hasPlace ? vehicle.VelocityNed.HorizontalLength : double.NaN, 1)
            .Number("climb", hasPlace ? -vehicle.VelocityNed.Down : double.NaN, 1)
            .Number("yaw", vehicle.AttitudeTime is null ? double.NaN : Bearing(vehicle.Attitude.Yaw), 0)
            .Text("fix", vehicle.GpsTime is null ? null : vehicle.GpsFix.ToString())
            .Number(
                "satellites", vehicle.GpsTime is null || vehicle.Satellites == 255 ? double.NaN : vehicle.Satellites,
                0);
        if (hasPlace && moment.Mission.Plan is { } plan)
        {
            NedPosition home = LocalNedFrame.IgnoringGeoid(vehicle.Position).ToNed(plan.Home);
            writer.Number("home", Math.Sqrt((home.North * home.North) + (home.East * home.East)), 0)
                .Number("homeBearing", Bearing(Angle.FromRadians(Math.Atan2(home.East, home.North))), 0);
        }

        writer.End();
    }

    private void WriteMission(ItemWriter writer, in MissionStatus mission)
        => writer.Object(prefix + "/mission").Text("phase", PhaseWords.Name(mission.Phase))
            .Text("text", mission.Text).Text("next", PhaseWords.Next(mission))
            .Text("aborted", mission.Aborted).Text("takenOver", mission.TakenOver)
            .Number("since", mission.Since.TotalSeconds, 1)
            .Count("lanesFlown", mission.LanesFlown).Count("lanes", (mission.Plan?.Lanes.Length ?? 0) / 2)
            .Number("coverage", mission.Coverage * 100, 1)
            .Count("revisits", mission.Revisits).Count("confirmed", mission.TracksConfirmed)
            .Text("outcome", mission.Result.Outcome.ToString()).End();

    private void WriteEnergy(ItemWriter writer, in EnergyStatus energy, in VehicleState vehicle)
    {
        bool hasBattery = vehicle.BatteryTime is not null;
        writer.Object(prefix + "/energy")
            .Number("volts", hasBattery ? vehicle.BatteryVolts : double.NaN, 1)
            .Number("amperes", hasBattery ? vehicle.BatteryAmperes : double.NaN, 1)
            .Number("remaining", hasBattery ? vehicle.BatteryRemaining * 100 : double.NaN, 0)
            .Flag("known", energy.IsKnown);
        if (energy.IsKnown)
            writer.Number("left", energy.ChargeLeft * 100, 0).Number("home", energy.ChargeHome * 100, 0)
                .Number("reserve", energy.Reserve * 100, 0).Number("toReturn", energy.TimeToReturn.TotalSeconds, 0)
                .Number("timeHome", energy.TimeHome.TotalSeconds, 0).Flag("mustReturn", energy.MustReturn)
                .Flag("outOfReach", energy.IsHomeOutOfReach);
        writer.End();
    }

    private void WriteWind(ItemWriter writer, in VehicleState vehicle)
    {
        NedVector wind = vehicle.WindVelocityNed;
        bool isKnown = vehicle.WindTime is not null;
        writer.Object(prefix + "/wind").Number("speed", isKnown ? vehicle.WindMetresPerSecond : double.NaN, 1)
            .Number("from", isKnown ? Bearing(Angle.FromRadians(Math.Atan2(-wind.East, -wind.North))) : double.NaN, 0)
            .End();
    }

    private void WriteHealth(ItemWriter writer, in HealthReport health)
        => writer.Object(prefix + "/health").Text("level", health.Level.ToString())
            .Text("text", health.Text, 400)
            .Text("advice", health.Advice == HealthAdvice.None ? null : health.Advice.ToString())
            .Text("adviceText", health.AdviceText).Flag("heartbeat", health.SendsHeartbeat)
            .Number("temperature", health.Computer.Time == default ? double.NaN : health.Computer.TemperatureCelsius, 0)
            .Number("cpu", health.Computer.Time == default ? double.NaN : health.Computer.CpuLoad * 100, 0).End();

    private void WriteCamera(ItemWriter writer, in ImagingStatus imaging)
        => writer.Object(prefix + "/camera").Flag("has", imaging.HasCamera).Count("frames", imaging.Frames)
            .Count("searched", imaging.Observations).Number("usable", (imaging.UsableShare ?? double.NaN) * 100, 0)
            .Count("dropped", imaging.FramesDropped).Text("fault", imaging.Fault).End();

    private void WriteOthers(ItemWriter writer, PageState state, FlightMoment moment)
    {
        int index = 0;
        foreach (OtherVehicle other in moment.Others.Take(MaxOthers))
        {
            writer.Object(OtherKey(index++)).Count("system", other.SystemId)
                .Number("lat", other.Position.Latitude.Degrees, 6).Number("lon", other.Position.Longitude.Degrees, 6)
                .Number("height", other.HeightAboveHomeMetres, 0).Number("yaw", other.Heading.Degrees, 0)
                .Number("t", other.ReceivedAt.TotalSeconds, 1).End();
        }

        for (int gone = index; gone < _others; gone++)
            state.Remove(OtherKey(gone));
        _others = index;
    }

    private string OtherKey(int index) => string.Create(CultureInfo.InvariantCulture, $"{prefix}/other/{index}");

    private static double Bearing(Angle angle)
    {
        double degrees = Math.Round(angle.Degrees) % 360;
        return degrees < 0 ? degrees + 360 : degrees;
    }
}
