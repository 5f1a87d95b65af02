using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting.Html;

/// <summary>What the map of a flight and that of a group have in common.</summary>
internal sealed class MapParts(PageWriter page, MapFrame frame)
{
    /// <summary>What the pictures show of the ground.</summary>
    // A colour of the style sheet behind a mask, so that it fits light and dark.
    public void WriteSeenGround(IReadOnlyList<CameraObservation> observations)
    {
        if (CoverageRaster.Draw(frame, observations) is not { } raster)
            return;
        string[] all = ["x", "0", "y", "0", "width", FlightText.Number(MapFrame.Width), "height",
            FlightText.Number(frame.Height, "0.#")];
        page.Open("mask", "id", "observations")
            .Empty("image", [.. all, "href", raster, "preserveAspectRatio", "none"]).Close();
        page.Empty("rect", [.. all, "class", "seen", "mask", "url(#observations)"]);
    }

    /// <summary>Fence, keep-outs, area and lanes.</summary>
    public void WritePlan(SearchPlan? searchPlan)
    {
        if (searchPlan is not { } plan)
            return;
        if (plan.Fence.Length > 2)
            page.Empty("polygon", "class", "fence", "points", frame.Points(plan.Fence));
        foreach (ImmutableArray<GeodeticPosition> keepOut in plan.KeepOuts.IsDefault ? [] : plan.KeepOuts)
            page.Empty("polygon", "class", "keep-out", "points", frame.Points(keepOut));
        if (plan.Area.Length > 2)
            page.Empty("polygon", "class", "area", "points", frame.Points(plan.Area));
        for (int index = 0; index + 1 < plan.Lanes.Length; index += 2)
        {
            (double x1, double y1) = frame.ToMap(plan.Lanes[index]);
            (double x2, double y2) = frame.ToMap(plan.Lanes[index + 1]);
            page.Empty("line", "class", "lane", "x1", N(x1), "y1", N(y1), "x2", N(x2), "y2", N(y2));
        }
    }

    /// <summary>Tracks, and where the targets really are as far as that is known.</summary>
    public void WriteTargets(TrackList tracks, MissionScore? score)
    {
        foreach (TargetScore target in score?.Targets ?? [])
            WriteTruth(target);
        foreach (TargetTrack track in tracks.Tracks)
            WriteTrack(track, score?.FalseTracks.Contains(track) == true);
    }

    private void WriteTrack(TargetTrack track, bool isFalse)
    {
        (double x, double y) = frame.ToMap(track.Position);
        string kind = track.State switch
        {
            TrackState.Confirmed => isFalse ? "track false" : "track",
            TrackState.Lost => "track lost",
            TrackState.Rejected => "track rejected",
            _ => "track tentative",
        };
        page.Open("g", "class", kind);
        page.Element("title", $"{FlightText.Number(track.Id)}: {TargetClassNames.Name(track.Class)}, "
            + $"{track.State.ToString().ToLowerInvariant()}, {FlightText.Number(track.Reports)} reports");
        page.Empty(
            "ellipse", "class", "ellipse", "cx", "0", "cy", "0",
            "rx", N(track.Covariance.HalfMajorAxis95Metres * frame.UnitsPerMetre),
            "ry", N(track.Covariance.HalfMinorAxis95Metres * frame.UnitsPerMetre),
            "transform", $"translate({N(x)} {N(y)}) "
                + $"rotate({N((Angle.FromRadians(track.Covariance.MajorAxis.Radians).Degrees) - 90)})");
        page.Empty(
            "path", "class", "mark", "d", $"M{N(x)} {N(y - 7)}l7 7l-7 7l-7 -7z", "fill",
            TargetClassNames.Css(track.Class));
        if (track.State != TrackState.Tentative)
            page.Element("text", $"{FlightText.Number(track.Id)}", "x", N(x + 12), "y", N(y - 9), "class", "label");
        page.Close();
    }

    private void WriteTruth(TargetScore target)
    {
        (double x, double y) = frame.ToMap(target.Position);
        string result = FlightText.ResultOf(target);
        page.Open("g", "class", target.IsFound ? "truth" : "truth missed");
        page.Element("title", $"{target.Name}: {TargetClassNames.Name(target.Class)}, {result}");
        if (!target.IsFound)
            page.Empty("circle", "cx", N(x), "cy", N(y), "r", "16");
        page.Empty("path", "d", $"M{N(x - 17)} {N(y)}h34m-17 -17v34");
        if (!target.IsFound)
            page.Element("text", $"{target.Name} {result}", "x", N(x + 20), "y", N(y + 5), "class", "label");
        page.Close();
    }

    /// <summary>The home of the mission.</summary>
    public void WriteHome(SearchPlan? searchPlan)
    {
        if (searchPlan is not { } plan)
            return;
        (double x, double y) = frame.ToMap(plan.Home);
        page.Open("g", "class", "home");
        page.Empty("circle", "cx", N(x), "cy", N(y), "r", "12");
        page.Element("text", "H", "x", N(x), "y", N(y + 5.5), "text-anchor", "middle");
        page.Close();
    }

    /// <summary>How long a length is, and where north is.</summary>
    public void WriteScale()
    {
        double[] lengths = [5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000];
        double metres = lengths.LastOrDefault(l => l * frame.UnitsPerMetre <= 220);
        if (metres <= 0)
            metres = lengths[0];
        double right = MapFrame.Width - 24;
        double left = right - (metres * frame.UnitsPerMetre);
        double y = frame.Height - 22;
        page.Open("g", "class", "scale");
        page.Empty("path", "d", $"M{N(left)} {N(y - 6)}v6h{N(right - left)}v-6");
        page.Element(
            "text", $"{FlightText.Number(metres)} m", "x", N((left + right) / 2), "y", N(y - 8), "text-anchor",
            "middle");
        page.Empty("path", "class", "north", "d", $"M{N(right - 8)} 52v-28l-6 9m6 -9l6 9");
        page.Element("text", "N", "x", N(right - 8), "y", "74", "text-anchor", "middle");
        page.Close();
    }

    /// <summary>What the colours and lines of these parts mean.</summary>
    public void WriteKeys(bool hasSeenGround, SearchPlan? plan, bool hasTruth, string lanes = "lanes")
    {
        if (hasSeenGround)
            WriteKey("key seen", "ground seen, darker where seen more often");
        if (plan is not null)
        {
            WriteKey("key edge", "area to search");
            if (plan.Fence.Length > 2)
                WriteKey("key fence-key", "fence");
            WriteKey("key lane-key", lanes);
        }

        WriteKey("key diamond", "track with its 95 % ellipse");
        if (hasTruth)
            WriteKey("key cross", "where the target really is");
    }

    /// <summary>One line of the legend.</summary>
    public void WriteKey(string kind, string text)
        => page.Open("span", "class", "entry").Element("i", string.Empty, "class", kind).Text(text).Close();

    private static string N(double value) => FlightText.Number(value, "0.#");
}
