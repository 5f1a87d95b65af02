using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.Reporting.Html;

/// <summary>A card for each target: its image chip, its track compared with the truth, and the figures.</summary>
internal sealed class ReportTargets(PageWriter page, FlightSummary data)
{
    private const double PlotRadius = 66;
    private static readonly double[] PlotMetres = [1, 2, 3, 4, 5, 8, 10, 15, 20];

    public void Write()
    {
        MissionScore? score = data.Mission?.Score;
        TargetTrack[] shown = data.Record.Tracks.Tracks.Where(t => t.State != TrackState.Tentative).ToArray();
        if (score is null && shown.Length == 0)
            return;
        page.Open("section").Element("h2", "Targets").Open("div", "class", "cards");
        foreach (TargetScore target in score?.Targets ?? [])
            WriteTarget(target);
        foreach (TargetTrack track in shown.Where(t => score?.Targets.Any(s => s.Track == t) != true))
            WriteTrackAlone(track, isFalse: score?.FalseTracks.Contains(track) == true);
        page.Close().Close();
    }

    private void WriteTarget(TargetScore target)
    {
        Begin(target.IsFound ? "found" : "missed", target.Name, target.Class, target.IsFound ? "found" : "missed");
        if (target.Track is not { } track)
        {
            page.Element("p", "There is no confirmed track of this class within 10 m.", "class", "note");
            page.Open("dl");
            Fact("really at", $"{FlightText.Degrees(target.Position.Latitude.Radians)}, "
                + $"{FlightText.Degrees(target.Position.Longitude.Radians)}");
            page.Close().Close();
            return;
        }

        WritePictures(track, target);
        page.Open("dl");
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
        Begin(isFalse ? "false" : "found", $"track {FlightText.Number(track.Id)}", track.Class, state);
        WritePictures(track, null);
        page.Open("dl");
        Fact("95 % ellipse", $"{Ellipse(track)} m");
        TrackFacts(track);
        page.Close().Close();
    }

    private void Begin(string kind, string name, TargetClassName targetClass, string state)
    {
        page.Open("article", "class", "card target " + kind).Open("h3");
        page.Element("i", string.Empty, "class", "swatch", "style", "background:" + TargetClassNames.Css(targetClass));
        page.Text(name + " ").Element("small", TargetClassNames.Name(targetClass))
            .Element("b", state, "class", "state").Close();
    }

    private void TrackFacts(TargetTrack track)
    {
        Fact("track", $"{FlightText.Number(track.Id)}: {FlightText.Number(track.Reports)} reports, "
            + $"{FlightText.Number(track.Misses)} misses");
        Fact("position", $"{FlightText.Degrees(track.Position.Latitude.Radians)}, "
            + $"{FlightText.Degrees(track.Position.Longitude.Radians)}");
        Fact("seen", $"{FlightText.Clock(track.FirstSeen)} to {FlightText.Clock(track.LastSeen)}");
        Fact("size", $"{FlightText.Number(track.SizeMetres, "0.0")} m square");
    }

    private void Fact(string name, string value, string kind = "")
        => page.Element("dt", name).Element("dd", value, "class", kind);

    private void WritePictures(TargetTrack track, TargetScore? target)
    {
        page.Open("div", "class", "pictures");
        ImageChip? picture = data.Record.Pictures.FirstOrDefault(
            c => c.PictureNumber == track.BestPictureNumber && c.ReportIndex == track.BestReportIndex);
        if (picture is null)
            page.Element("span", "no picture", "class", "none");
        else
            page.Empty(
                "img", "src", DataUri.Of(new RgbPicture(picture.Width, picture.Height, picture.CopyPixels())), "alt",
                $"What the camera saw of track {FlightText.Number(track.Id)}, picture "
                    + $"{FlightText.Number(picture.PictureNumber)}");
        WritePlot(track, target);
        page.Close();
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
        page.Empty("path", "class", "mark", "d", "M0 -5l5 5l-5 5l-5 -5z", "fill", TargetClassNames.Css(track.Class));
        if (target is not null)
        {
            (double x, double y) = (-target.ErrorEastMetres * scale, target.ErrorNorthMetres * scale);
            page.Open("g", "class", "truth").Empty("path", "d", $"M{N(x - 6)} {N(y)}h12m-6 -6v12").Close();
        }

        page.Element("text", $"{FlightText.Number(metres)} m", "x", "62", "y", "61", "text-anchor", "end");
        page.Close();
    }

    private static string Ellipse(TargetTrack track)
        => $"{FlightText.Number(track.Covariance.HalfMajorAxis95Metres, "0.0")} × "
            + $"{FlightText.Number(track.Covariance.HalfMinorAxis95Metres, "0.0")}";

    private static string N(double value) => FlightText.Number(value, "0.##");
}
