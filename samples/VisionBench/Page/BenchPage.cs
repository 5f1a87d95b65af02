using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Net;
using System.Text;
using Rabit.Uav.ImageProcessing;

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
    {
        _page.WriteLine($"<h2>{Escape(score.Name)}, {score.Frames} pictures</h2>");
        _page.WriteLine("<table><tr><th></th><th>this</th>" + (baseline is null ? "" : "<th>OpenCV</th>") + "</tr>");
        foreach ((string name, string value, string reference) in ScoreRows.Of(score, baseline))
        {
            _page.WriteLine($"<tr><td>{Escape(name)}</td><td>{Escape(value)}</td>"
                + (baseline is null ? "" : $"<td>{Escape(reference)}</td>") + "</tr>");
        }

        _page.WriteLine($"</table><p class=\"lead\">{Escape(note)}</p><div class=\"grid\">");
        foreach (FrameScore frame in frames)
            Write(frame);
        _page.WriteLine("</div>");
    }

    /// <summary>Ends the page.</summary>
    public void Dispose()
    {
        _page.WriteLine($"</main><script>{Resource("page.js")}</script></body></html>");
        _page.Dispose();
    }

    private void Write(FrameScore score)
    {
        ListedFrame frame = score.Frame;
        TargetMatch[] missed = score.Matches.Where(m => m.Found is null).ToArray();
        _page.WriteLine($"<figure data-missed=\"{missed.Length}\" data-alarms=\"{score.FalseAlarms.Count}\">"
            + $"<div class=\"picture\"><img loading=\"lazy\" alt=\"{Escape(frame.Name)}\" "
            + $"src=\"{PictureUri.Of(frame.FilePath)}\">"
            + $"<svg viewBox=\"-0.5 -0.5 {frame.Camera.Width} {frame.Camera.Height}\" preserveAspectRatio=\"none\">");
        foreach (ListedTarget target in frame.Targets.Where(t => !t.Counts))
            Box("other", Around(target), $"does not count: {target.Kind} {target.Size:0.0} px");
        foreach (TargetMatch match in score.Matches)
        {
            if (match.Found is { } found)
                Box("found", Around(found), FormattableString.Invariant(
                    $"{found.Class} {found.Score:0.00}, {match.Error:0.00} px off"));
            else
                Box("missed", Around(match.Target), "missed " + match.Target.Describe());
        }

        foreach (FalseAlarm alarm in score.FalseAlarms)
            Box("alarm", Around(alarm.Detection), "false " + alarm.Describe());
        _page.WriteLine($"</svg></div><figcaption><b>{Escape(frame.Name)}</b>"
            + (score.Matches.Count == 0
                ? "no target"
                : $"{score.Matches.Count - missed.Length} of {score.Matches.Count} found") + "<ul>");
        foreach (TargetMatch match in missed)
            _page.WriteLine($"<li class=\"missed\">missed {Escape(match.Target.Describe())}</li>");
        foreach (FalseAlarm alarm in score.FalseAlarms)
            _page.WriteLine($"<li class=\"alarm\">false {Escape(alarm.Describe())}</li>");
        _page.WriteLine("</ul></figcaption></figure>");
    }

    private void Box(string kind, (double Left, double Top, double Width, double Height) box, string title)
        => _page.WriteLine(FormattableString.Invariant(
            $"<rect class=\"{kind}\" x=\"{box.Left:0.0}\" y=\"{box.Top:0.0}\" width=\"{box.Width:0.0}\" height=\"{box.Height:0.0}\">")
            + $"<title>{Escape(title)}</title></rect>");

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
