using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;
using Spectre.Console;

namespace UavConsole;

/// <summary>
/// Beside the map, or without it where the terminal is small: how far the mission is and how the vehicle is, then the
/// targets. What matters most is first: the end is cut off where there is no room.
/// </summary>
internal sealed class MissionPanel(FlightMonitor monitor, int width)
{
    private const int NameWidth = 9;
    private const int WideText = 50;
    private const int BarWidth = 8;

    // The line of the last picture is left out where it would leave room for fewer.
    private const int TargetsBeforePicture = 3;

    // What the operator can do; a stop after a takeover sends nothing.
    private static readonly string[] TakenOverHints =
    [
        "nothing is commanded. To command again", "stop (Ctrl-C), and start with --hold,", "--return or --resume FILE",
    ];

    private bool IsWide => width - NameWidth >= WideText;

    /// <param name="rows">How many lines there are.</param>
    /// <returns>No more lines of markup than that.</returns>
    public IReadOnlyList<string> Draw(int rows)
    {
        FlightRecord record = monitor.Record;
        MissionStatus mission = record.Mission;
        List<string> lines = [.. Mission(record), .. Vehicle(monitor.Vehicle, mission)];
        int roomForTargets = rows - lines.Count - 2;   // but for the picture's line and their own heading
        if (roomForTargets >= Math.Min(TargetsBeforePicture, Listed(record.Tracks).Count())
            && MissionText.LastPicture(record.Imaging, isShort: !IsWide) is { } picture)
            lines.Add(Field("picture", picture, "default"));
        if (mission.Phase == MissionPhase.HandedOver && monitor.Vehicle.IsArmed)
            lines.AddRange(TakenOverHints.Select(h => $"[yellow]{Markup.Escape(Text.Fit(h, width).TrimEnd())}[/]"));
        lines.AddRange(Targets(record.Tracks, Math.Max(0, rows - lines.Count - 1)));
        return [.. lines.Take(rows)];
    }

    private IEnumerable<string> Mission(FlightRecord record)
    {
        MissionStatus mission = record.Mission;
        yield return Field(
            "phase", PhaseText(record),
            mission.Phase is MissionPhase.Failed or MissionPhase.HandedOver ? "red" : "bold");
        yield return Field(
            string.Empty, mission.Aborted is null ? MissionText.Doing(mission) : "given up: " + mission.Aborted,
            mission.Aborted is null ? "grey" : "yellow");
        yield return Field("next", MissionText.Next(mission), "default");
        yield return Field("health", FlightText.Health(monitor.Health), HealthColour(monitor.Health.Level));
        yield return $"[grey]{"covered",-NameWidth}[/]{Bar(mission.Coverage)} "
            + Markup.Escape(Text.Fit(LaneText(mission), Math.Max(1, width - NameWidth - BarWidth - 8)).TrimEnd());
        yield return Field("battery", Text.Battery(monitor.Vehicle), "default");
        yield return Field(
            "energy", IsWide ? Text.Energy(mission.Energy) : MissionText.ShortEnergy(mission.Energy),
            mission.Energy.MustReturn ? "yellow" : "default");
    }

    private IEnumerable<string> Vehicle(VehicleState vehicle, MissionStatus mission)
    {
        yield return Field("vehicle", VehicleText(vehicle), "default");
        yield return Field(string.Empty, string.Format(
            CultureInfo.InvariantCulture, "{0:0.0} m high, {1:0.0} m/s", vehicle.HeightAboveHomeMetres,
            Speed(vehicle)), "default");
        yield return Field("home", MissionText.Home(vehicle, mission.Plan), "default");
        yield return Field("wind", $"{MissionText.Wind(vehicle)}; {MissionText.Satellites(vehicle)}", "default");
        yield return Field("link", MissionText.Links(monitor.Links), "default");
        yield return Field("camera", MissionText.Camera(monitor.Record.Imaging), "default");
    }

    private static string PhaseText(FlightRecord record)
    {
        string text = FlightText.Phase(record.Mission.Phase);
        return record.Authority.State == CommandAuthorityState.TakenAway && record.Authority.TakenBy is { } by
            ? $"{text}: {by}"
            : text;
    }

    private string LaneText(in MissionStatus mission)
    {
        string lanes = $"{FlightText.Number(mission.LanesFlown)} of "
            + $"{FlightText.Number((mission.Plan?.Lanes.Length ?? 0) / 2)} flown";
        return IsWide ? $"{lanes}, {FlightText.Number(mission.Revisits)} revisits" : lanes;
    }

    private static string VehicleText(in VehicleState vehicle)
        => vehicle.SystemId == 0 ? "not connected yet" : $"{vehicle.Mode}, {(vehicle.IsArmed ? "armed" : "disarmed")}";

    private static double Speed(in VehicleState vehicle)
        => Math.Sqrt(
            (vehicle.VelocityNed.North * vehicle.VelocityNed.North)
                + (vehicle.VelocityNed.East * vehicle.VelocityNed.East));

    private static IEnumerable<TargetTrack> Listed(TrackList tracks)
        => tracks.Tracks.Where(t => t.State != TrackState.Tentative);

    // The last ones where there is no room for all.
    private IEnumerable<string> Targets(TrackList tracks, int room)
    {
        TargetTrack[] shown = Listed(tracks).ToArray();
        string leftOut = shown.Length > room ? $", last {FlightText.Number(room)}" : string.Empty;
        yield return Field(
            "targets",
            $"{FlightText.Number(tracks.ConfirmedCount)} confirmed, "
                + $"{FlightText.Number(tracks.Tracks.Length - shown.Length)} tentative{leftOut}",
            "default");
        foreach (TargetTrack track in shown.Skip(shown.Length - room))
        {
            string text = Text.Fit(FlightText.Printable(TargetText(track)), width).TrimEnd();
            yield return $"[{ScreenInk.Style(TargetLetters.Ink(track.Class))}]{Markup.Escape(text)}[/]";
        }
    }

    private string TargetText(TargetTrack track) => string.Format(
        CultureInfo.InvariantCulture,
        IsWide ? "{0,3} {1,-8} {2:0.0000000} {3:0.0000000} ±{4:0.0} m, {5} reports{6}{7}"
            : "{0,3} {1} {2:0.00000} {3:0.00000} ±{4:0.0}{6}{7}",
        track.Id,
        TargetClassNames.Name(track.Class),
        track.Position.Latitude.Degrees,
        track.Position.Longitude.Degrees,
        track.Covariance.HalfMajorAxis95Metres,
        track.Reports,
        track.State switch
        {
            TrackState.Lost => " lost",
            TrackState.Rejected => " rejected",
            _ => string.Empty,
        },
        track.Bearing is not { } bearing ? string.Empty : $" {FlightText.Bearing(bearing)}");

    private string Field(string name, string text, string style)
        => $"[grey]{name,-NameWidth}[/][{style}]"
            + Markup.Escape(Text.Fit(FlightText.Printable(text), Math.Max(1, width - NameWidth)).TrimEnd()) + "[/]";

    private static string Bar(double part)
    {
        double known = double.IsNaN(part) ? 0 : Math.Max(0, Math.Min(1, part));
        int done = (int)Math.Round(known * BarWidth);
        return string.Format(
            CultureInfo.InvariantCulture, "[green]{0}[/][grey]{1}[/] {2:0.0}%", new string('━', done),
            new string('━', BarWidth - done), known * 100);
    }

    private static string HealthColour(HealthLevel level) => level switch
    {
        HealthLevel.Good => "green",
        HealthLevel.Warning => "yellow",
        HealthLevel.Critical => "red",
        _ => "grey",
    };
}
