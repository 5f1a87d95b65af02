using System;
using System.Collections.Generic;
using System.IO;
using System.Net;

namespace VisionBench;

/// <summary>A picture of the page, with boxes and what is said below it.</summary>
internal sealed class PageFigure(string name, string filePath, int width, int height)
{
    private readonly List<string> _boxes = [];
    private readonly List<string> _lines = [];
    private int _found;
    private int _missed;
    private int _false;

    public void AddOther((double Left, double Top, double Width, double Height) box, string title)
        => Box("other", box, title);

    public void AddFound((double Left, double Top, double Width, double Height) box, string title)
    {
        _found++;
        Box("found", box, title);
    }

    public void AddMissed((double Left, double Top, double Width, double Height) box, string what)
    {
        _missed++;
        Box("missed", box, "missed " + what);
        _lines.Add($"<li class=\"missed\">missed {Escape(what)}</li>");
    }

    public void AddFalse((double Left, double Top, double Width, double Height) box, string what)
    {
        _false++;
        Box("alarm", box, "false " + what);
        _lines.Add($"<li class=\"alarm\">false {Escape(what)}</li>");
    }

    /// <exception cref="IOException">The picture cannot be read, or the page not be written.</exception>
    public void Write(TextWriter page)
    {
        page.WriteLine($"<figure data-missed=\"{_missed}\" data-alarms=\"{_false}\">"
            + $"<div class=\"picture\"><img loading=\"lazy\" alt=\"{Escape(name)}\" "
            + $"src=\"{PictureUri.Of(filePath)}\">"
            + $"<svg viewBox=\"-0.5 -0.5 {width} {height}\" preserveAspectRatio=\"none\">");
        foreach (string box in _boxes)
            page.WriteLine(box);
        page.WriteLine($"</svg></div><figcaption><b>{Escape(name)}</b>"
            + (_found + _missed == 0 ? "no target" : $"{_found} of {_found + _missed} found") + "<ul>");
        foreach (string line in _lines)
            page.WriteLine(line);
        page.WriteLine("</ul></figcaption></figure>");
    }

    private void Box(string kind, (double Left, double Top, double Width, double Height) box, string title)
        => _boxes.Add(FormattableString.Invariant(
            $"<rect class=\"{kind}\" x=\"{box.Left:0.0}\" y=\"{box.Top:0.0}\" width=\"{box.Width:0.0}\" height=\"{box.Height:0.0}\">")
            + $"<title>{Escape(title)}</title></rect>");

    private static string Escape(string text) => WebUtility.HtmlEncode(text);
}
