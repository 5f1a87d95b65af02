using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting.Html;

/// <summary>A card for each target: its pictures, its track compared with the truth, and the figures.</summary>
internal sealed class ReportTargets(PageWriter page, FlightSummary data)
{
    private const double PlotRadius = 66;
    private static readonly double[] PlotMetres = [1, 2, 3, 4, 5, 8, 10, 15, 20];

    private readonly ReportPictures _pictures = new(page, data.Record);

    public void Write()
    {
        MissionScore? score = data.Mission?.Score;
        TargetTrack[] shown = data.Record.Tracks.Tracks.Where(t => t.State != TrackState.Tentative).ToArray();
        if (score is null && shown.Length == 0)
            return;
        page.Open("section").Element("h2", "Targets").Element(
            "p", "The number of a target is that of its track: on the map, here, in the log and in the exports.",
            "class", "note");
        page.Open("div", "class", "cards");
        foreach (TargetTrack track in shown.OrderBy(t => t.Id))
        {
            if (score?.Targets.FirstOrDefault(s => s.Track == track) is { } target)
                WriteTarget(target, track);
            else
                WriteTrackAlone(track, isFalse: score?.FalseTracks.Contains(track) == true);
        }

        foreach (TargetScore missed in score?.Targets.Where(t => !t.IsFound) ?? [])
            WriteMissed(missed);
        page.Close().Close();
    }

    private void WriteMissed(TargetScore target)
    {
        page.OpenTargetCard("missed", target.Name, target.Class, FlightText.ResultOf(target));
        page.Element(
            "p",
            target.IsRejected
                ? $"It was seen, and {FlightText.RejectedBy(target)} rejected its track."
                : "There is no confirmed track of this class within 10 m.",
            "class", "note");
        page.Open("dl");
        PlaceFacts("really at", target.Position);
        page.Close().Close();
    }

    private void WriteTarget(TargetScore target, TargetTrack track)
    {
        page.OpenTargetCard("found", FlightText.Number(track.Id), track.Class, "found");
        WritePictures(track, target);
        page.Open("dl");
        Fact("is", target.Name);
        Fact("error", $"{FlightText.Number(target.ErrorMetres, "0.00")} m");
        Fact(
            "95 % ellipse",
            $"{Ellipse(track)} m, "
                + $"{(target.EllipseContainsTruth ? "contains the truth" : "does not contain the truth")}",
            target.EllipseContainsTruth ? string.Empty : "bad");
        TrackFacts(track);
        page.Close().Close();
    }

    private void WriteTrackAlone(TargetTrack track, bool isFalse)
    {
        string state = isFalse ? "false" : track.State.ToString().ToLowerInvariant();
        page.OpenTargetCard(isFalse ? "false" : "found", FlightText.Number(track.Id), track.Class, state);
        WritePictures(track, null);
        page.Open("dl");
        Fact("95 % ellipse", $"{Ellipse(track)} m");
        TrackFacts(track);
        page.Close().Close();
    }

    private void TrackFacts(TargetTrack track)
    {
        PlaceFacts("position", track.Position);
        Fact("reports", $"{FlightText.Number(track.Reports)}, {FlightText.Number(track.Misses)} misses");
        Fact("seen", $"{FlightText.Clock(track.FirstSeen)} to {FlightText.Clock(track.LastSeen)}");
        if (track.Motion != TargetMotion.Standing)
            Fact("speed", $"{FlightText.Number(track.VelocityNed.HorizontalLength, "0.0")} m/s when last seen");
        if (track.Bearing is { } bearing)
            Fact("bearing", FlightText.Bearing(bearing));
        Fact("size", $"{FlightText.Number(track.SizeMetres, "0.0")} m square");
    }

    private void PlaceFacts(string name, GeodeticPosition position)
    {
        Copied(name, TargetPlace.Decimal(position));
        if (TargetPlace.Mgrs(position) is { } mgrs)
            Copied("MGRS", mgrs);
        if (data.Record.Mission.Plan is { } plan)
            Fact("from home", TargetPlace.From(plan.Home, position));
    }

    // Marked as a whole by one click, so that it can be copied without the script too.
    private void Copied(string name, string value)
        => page.Element("dt", name).Open("dd").Element("span", value, "class", "whole")
            .CopyButton(value, $"copy {name}").Close();

    private void Fact(string name, string value, string kind = "")
        => page.Element("dt", name).Element("dd", value, "class", kind);

    private void WritePictures(TargetTrack track, TargetScore? target)
    {
        page.Open("div", "class", "pictures");
        _pictures.WriteBest(track);
        WritePlot(track, target);
        page.Close();
        _pictures.WriteOthers(track);
    }

    // The truth, seen from the track: near enough to see what the map is too small for.
    private void WritePlot(TargetTrack track, TargetScore? target)
    {
        double span = Math.Max(track.Covariance.HalfMajorAxis95Metres, target?.ErrorMetres ?? 0) * 1.25;
        double metres = PlotMetres.FirstOrDefault(m => m >= span);
        if (metres <= 0)
            metres = Math.Max(1, Math.Ceiling(double.IsInfinity(span) || double.IsNaN(span) ? 1 : span));
        double scale = PlotRadius / metres;
        page.Open(
            "svg", "viewBox", "-66 -66 132 132", "class", "plot", "role", "img", "aria-label",
            "Track and truth, north is up");
        page.Empty("path", "class", "axes", "d", "M-66 0H66M0 -66V66");
        for (int ring = 1; ring <= 2; ring++)
            page.Empty("circle", "class", "ring", "cx", "0", "cy", "0", "r", N(PlotRadius * ring / 2 * 0.999));
        page.Empty(
            "ellipse", "class", "ellipse", "cx", "0", "cy", "0",
            "rx", N(track.Covariance.HalfMajorAxis95Metres * scale), "ry",
            N(track.Covariance.HalfMinorAxis95Metres * scale),
            "transform", $"rotate({N((Angle.FromRadians(track.Covariance.MajorAxis.Radians).Degrees) - 90)})");
        if (track.Bearing is { } bearing)
            WriteBearing(bearing);
        page.Empty("path", "class", "mark", "d", "M0 -5l5 5l-5 5l-5 -5z", "fill", TargetClassNames.Css(track.Class));
        if (target is not null)
        {
            (double x, double y) = (-target.ErrorEastMetres * scale, target.ErrorNorthMetres * scale);
            page.Open("g", "class", "truth").Empty("path", "d", $"M{N(x - 6)} {N(y)}h12m-6 -6v12").Close();
        }

        page.Element("text", $"{FlightText.Number(metres)} m", "x", "62", "y", "61", "text-anchor", "end");
        page.Close();
    }

    // A line for each end that may be the front.
    private void WriteBearing(TargetBearing bearing)
    {
        double period = bearing.Period.Degrees;
        var lines = new System.Text.StringBuilder();
        for (double turn = 0; turn < 360; turn += period)
        {
            double angle = Angle.FromDegrees(bearing.Angle.Degrees + turn).Radians;
            lines.Append($"M0 0L{N(PlotRadius * Math.Sin(angle))} {N(-PlotRadius * Math.Cos(angle))}");
        }

        page.Empty("path", "class", "bearing", "d", lines.ToString());
    }

    private static string Ellipse(TargetTrack track)
        => $"{FlightText.Number(track.Covariance.HalfMajorAxis95Metres, "0.0")} × "
            + $"{FlightText.Number(track.Covariance.HalfMinorAxis95Metres, "0.0")}";

    private static string N(double value) => FlightText.Number(value, "0.##");
}
