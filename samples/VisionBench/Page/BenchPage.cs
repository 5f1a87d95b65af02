using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Net;
using System.Text;
using Rabit.Uav.ImageProcessing;
using Rabit.Vision;

namespace VisionBench;

/// <summary>
/// A page for a browser: figures beside the reference's, and every picture with what was found, missed and falsely
/// alarmed. One file, which needs no network.
/// </summary>
internal sealed class BenchPage : IDisposable
{
    private const double Margin = 2;

    private readonly StreamWriter _page;

    /// <exception cref="IOException">It cannot be written.</exception>
    public BenchPage(string path, string detector)
    {
        _page = new StreamWriter(File.Create(path), new UTF8Encoding(false));
        _page.WriteLine("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>VisionBench</title>");
        _page.WriteLine("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">");
        _page.WriteLine($"<style>{Resource("page.css")}</style></head><body><main>");
        _page.WriteLine($"<h1>VisionBench</h1><p class=\"lead\">{Escape(detector)}</p>");
        _page.WriteLine("""
            <div class="bar"><span>
            <button type="button" data-show="all" aria-pressed="true">all</button>
            <button type="button" data-show="missed" aria-pressed="false">with misses</button>
            <button type="button" data-show="alarms" aria-pressed="false">with false alarms</button></span>
            <span class="key"><i class="found"></i>found</span><span class="key"><i class="missed"></i>missed</span>
            <span class="key"><i class="alarm"></i>false alarm</span>
            <span class="key"><i class="other"></i>does not count</span></div>
            """);
    }

    /// <summary>Adds a set.</summary>
    /// <exception cref="IOException">A picture cannot be read, or the page not be written.</exception>
    public void Add(SetScore score, Baseline? baseline, IEnumerable<FrameScore> frames, string note)
        => Add(
            $"{score.Name}, {score.Frames} pictures", ScoreRows.Of(score, baseline), baseline is not null, note,
            frames.Select(FigureOf));

    /// <summary>Adds a set of markers alone.</summary>
    /// <exception cref="IOException">A picture cannot be read, or the page not be written.</exception>
    public void Add(
        string title, IEnumerable<(string Name, string Value, string Reference)> rows, bool hasReference,
        IEnumerable<MarkerScore> pictures, string note)
        => Add(title, rows, hasReference, note, pictures.Select(FigureOf));

    private void Add(
        string title, IEnumerable<(string Name, string Value, string Reference)> rows, bool hasReference, string note,
        IEnumerable<PageFigure> figures)
    {
        _page.WriteLine($"<h2>{Escape(title)}</h2>");
        _page.WriteLine("<table><tr><th></th><th>this</th>" + (hasReference ? "<th>OpenCV</th>" : "") + "</tr>");
        foreach ((string name, string value, string reference) in rows)
        {
            _page.WriteLine($"<tr><td>{Escape(name)}</td><td>{Escape(value)}</td>"
                + (hasReference ? $"<td>{Escape(reference)}</td>" : "") + "</tr>");
        }

        _page.WriteLine($"</table><p class=\"lead\">{Escape(note)}</p><div class=\"grid\">");
        foreach (PageFigure figure in figures)
            figure.Write(_page);
        _page.WriteLine("</div>");
    }

    /// <summary>Ends the page.</summary>
    public void Dispose()
    {
        _page.WriteLine($"</main><script>{Resource("page.js")}</script></body></html>");
        _page.Dispose();
    }

    private static PageFigure FigureOf(FrameScore score)
    {
        ListedFrame frame = score.Frame;
        var figure = new PageFigure(frame.Name, frame.FilePath, frame.Camera.Width, frame.Camera.Height);
        foreach (ListedTarget target in frame.Targets.Where(t => !t.Counts && t.Marker?.Counts != true))
            figure.AddOther(Around(target), $"does not count: {target.Kind} {target.Size:0.0} px");
        foreach (TargetMatch match in score.Matches)
        {
            if (match.Found is { } found)
                figure.AddFound(Around(found), FormattableString.Invariant(
                    $"{found.Class} {found.Score:0.00}, {match.Error:0.00} px off"));
            else
                figure.AddMissed(Around(match.Target), match.Target.Describe());
        }

        foreach (FalseAlarm alarm in score.FalseAlarms)
            figure.AddFalse(Around(alarm.Detection), alarm.Describe());
        if (score.Markers is { } markers)
            AddTo(figure, markers);
        return figure;
    }

    private static PageFigure FigureOf(MarkerScore score)
    {
        var figure = new PageFigure(score.Picture.Name, score.Picture.FilePath, score.Width, score.Height);
        foreach (ListedMarker marker in score.Picture.Markers.Where(m => !m.Counts))
            figure.AddOther(Around(marker), "does not count: " + marker.Describe());
        AddTo(figure, score);
        return figure;
    }

    private static void AddTo(PageFigure figure, MarkerScore score)
    {
        foreach (MarkerMatch match in score.Matches)
        {
            if (match.Found is null)
                figure.AddMissed(Around(match.Marker), match.Marker.Describe());
            else
                figure.AddFound(Around(match.Marker), match.Marker.Describe()
                    + FormattableString.Invariant($", corners up to {match.CornerErrors.Max():0.00} px off"));
        }

        foreach (DetectedMarker wrong in score.Wrong)
            figure.AddFalse(Around(wrong), MarkerScore.Describe(wrong));
    }

    private static (double Left, double Top, double Width, double Height) Around(ListedMarker marker)
        => (marker.Left - Margin, marker.Top - Margin, marker.Right - marker.Left + (2 * Margin),
            marker.Bottom - marker.Top + (2 * Margin));

    private static (double Left, double Top, double Width, double Height) Around(in DetectedMarker found)
    {
        MarkerCorners corners = found.Corners;
        PicturePoint[] points = [corners[0], corners[1], corners[2], corners[3]];
        (double left, double top) = (points.Min(p => p.X), points.Min(p => p.Y));
        return (left - Margin, top - Margin, points.Max(p => p.X) - left + (2 * Margin),
            points.Max(p => p.Y) - top + (2 * Margin));
    }

    private static (double Left, double Top, double Width, double Height) Around(ListedTarget target)
        => (target.Left - Margin, target.Top - Margin, target.Right - target.Left + (2 * Margin),
            target.Bottom - target.Top + (2 * Margin));

    private static (double Left, double Top, double Width, double Height) Around(in TargetDetection found)
        => (found.CentreX - (found.WidthPixels / 2) - Margin, found.CentreY - (found.HeightPixels / 2) - Margin,
            found.WidthPixels + (2 * Margin), found.HeightPixels + (2 * Margin));

    private static string Escape(string text) => WebUtility.HtmlEncode(text);

    private static string Resource(string name)
    {
        using Stream stream = typeof(BenchPage).Assembly.GetManifestResourceStream("VisionBench.Page." + name)!;
        using var reader = new StreamReader(stream);
        return reader.ReadToEnd();
    }
}
