using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting.Html;

/// <summary>
/// The map of the page: ground that was seen, area, fence, lanes, the path that was flown, targets and tracks.
/// </summary>
internal sealed class ReportMap(PageWriter page, FlightSummary data, MapFrame frame)
{
    private const int MaxPathPoints = 3_000;

    private readonly MapParts _parts = new(page, frame);

    public void Write()
    {
        page.Open("figure", "class", "card map");
        page.Open(
            "svg", "viewBox", $"0 0 {FlightText.Number(MapFrame.Width)} {FlightText.Number(frame.Height, "0.#")}",
            "role", "img", "aria-label", "Map of the flight, north is up", "id", "map");
        _parts.WriteSeenGround(data.Record.Observations);
        _parts.WritePlan(data.Record.Mission.Plan);
        WritePath();
        _parts.WriteTargets(data.Record.Tracks, data.Mission?.Score);
        _parts.WriteHome(data.Record.Mission.Plan);
        page.Empty("circle", "id", "here", "class", "here", "r", "7", "cx", "-50", "cy", "-50");
        _parts.WriteScale();
        page.Close();
        WriteLegend();
        page.Close();
    }

    private void WritePath()
    {
        FlightSample[] samples = data.Record.Samples.Where(s => s.HasPosition).ToArray();
        int stride = Math.Max(1, samples.Length / MaxPathPoints);
        int first = 0;
        for (int index = 1; index <= samples.Length; index++)
        {
            if (index < samples.Length && samples[index].Phase == samples[first].Phase)
                continue;

            // One sample more, so that the pieces touch.
            int end = Math.Min(index, samples.Length - 1);
            IEnumerable<GeodeticPosition> piece = Enumerable.Range(first, end - first + 1)
                .Where(i => i == end || (i - first) % stride == 0)
                .Select(i => samples[i].Position);
            page.Empty(
                "polyline", "class", "path " + PhaseStyle.Class(samples[first].Phase), "points", frame.Points(piece));
            first = index;
        }
    }

    private void WriteLegend()
    {
        page.Open("figcaption", "class", "legend");
        foreach (MissionPhase phase
            in data.Record.Samples.Where(s => s.HasPosition).Select(s => s.Phase).Where(PhaseStyle.IsFlown).Distinct())
            _parts.WriteKey("key line " + PhaseStyle.Class(phase), FlightText.Phase(phase));
        _parts.WriteKeys(
            data.Record.Observations.Count > 0, data.Record.Mission.Plan, data.Mission?.Score is not null);
        page.Close();
    }
}
