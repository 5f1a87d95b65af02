using System.IO;
using System.Text;

namespace Rabit.Uav.Reporting.Html;

/// <summary>What all pages of reports have in common: style and script inside them, and the tiles of figures.</summary>
internal sealed class ReportShell(PageWriter page)
{
    /// <summary>Up to the begin of the content.</summary>
    public void Begin(string title)
    {
        page.Open("html", "lang", "en", "xmlns", "http://www.w3.org/1999/xhtml");
        page.Open("head").Empty("meta", "charset", "utf-8");
        page.Empty("meta", "name", "viewport", "content", "width=device-width, initial-scale=1");
        page.Empty("meta", "name", "color-scheme", "content", "light dark");
        page.Element("title", title);
        page.Open("style").Raw(Resource("report.css")).Close().Close();
        page.Open("body").Open("main");
    }

    /// <summary>From the end of the content on.</summary>
    /// <param name="points">For the script: an array of arrays of numbers as JSON.</param>
    public void End(string points)
    {
        page.Close();
        page.Open("script", "type", "application/json", "id", "flight").Raw(points).Close();
        page.Open("script").Raw(Resource("report.js")).Close();
        page.Close().Close();
    }

    /// <summary>A figure with its name and a note.</summary>
    public void Tile(string name, string value, string note)
        => page.Open("div", "class", "tile").Element("span", name).Element("b", value).Element("small", note).Close();

    /// <summary>The whole page.</summary>
    public override string ToString() => "<!DOCTYPE html>\n" + page;

    private static string Resource(string name)
    {
        using Stream stream = typeof(ReportShell).Assembly.GetManifestResourceStream(
            "Rabit.Uav.Reporting.Html." + name)!;
        using var reader = new StreamReader(stream, Encoding.UTF8);
        return reader.ReadToEnd();
    }
}
