using System;
using System.Linq;

namespace Rabit.Uav.Reporting.Html;

/// <summary>The axis of time lines, and what is drawn along it: labels, bands, frames of charts.</summary>
internal sealed class TimeAxis(PageWriter page, double startSeconds, double endSeconds)
{
    /// <summary>Where the start is, in units of the drawing, which is 1000 wide.</summary>
    public const double Left = 150;

    /// <summary>Where the end is.</summary>
    public const double Right = 990;

    /// <summary>The height of a band.</summary>
    public const double BandHeight = 18;

    /// <summary>Where a time is drawn.</summary>
    public double X(double seconds)
        => Left + ((seconds - startSeconds) / (endSeconds - startSeconds) * (Right - Left));

    /// <summary>Its lines, from the top to the bottom of the drawing, with their times.</summary>
    public void Write(double height)
    {
        double[] steps = [5, 10, 20, 30, 60, 120, 300, 600, 1800, 3600, 7200, 36_000];
        double length = endSeconds - startSeconds;
        double step = steps.FirstOrDefault(s => length / s <= 12);
        if (step <= 0)
            step = length / 10;
        page.Open("g", "class", "axis");
        for (double t = Math.Ceiling(startSeconds / step) * step; t <= endSeconds; t += step)
        {
            page.Empty("line", "x1", N(X(t)), "x2", N(X(t)), "y1", "16", "y2", N(height - 4));
            page.Element(
                "text", FlightText.Clock(TimeSpan.FromSeconds(t)), "x", N(X(t)), "y", "11", "text-anchor", "middle");
        }

        page.Close();
    }

    /// <summary>The name of a row, and what its lower and upper edge are; an empty range for a row without.</summary>
    public void WriteLabel(string name, double y, double height, string? range = null, string kind = "name")
    {
        bool hasRange = !string.IsNullOrEmpty(range);
        page.Element(
            "text", name, "x", N(Left - 10), "y", N(y + (height / 2) + (hasRange ? -2 : range is null ? 4 : 2)),
            "text-anchor", "end", "class", kind);
        if (hasRange)
            page.Element(
                "text", range!, "x", N(Left - 10), "y", N(y + (height / 2) + 12), "text-anchor", "end", "class",
                "hint");
    }

    /// <summary>A band of a class of the style sheet, with its text where there is room for it.</summary>
    public void WriteBand(string kind, string text, double y, double from, double to)
    {
        page.Open("g");
        page.Element("title", $"{text}, {FlightText.Clock(TimeSpan.FromSeconds(from))} to "
            + FlightText.Clock(TimeSpan.FromSeconds(to)));
        WriteBand(kind, y, from, to);
        if (X(to) - X(from) > 7.5 * text.Length)
            page.Element(
                "text", text, "x", N((X(from) + X(to)) / 2), "y", N(y + 13), "class", "in-band", "text-anchor",
                "middle");
        page.Close();
    }

    /// <summary>A band without a text.</summary>
    public void WriteBand(string kind, double y, double from, double to, double height = BandHeight)
        => page.Empty(
            "rect", "class", kind, "x", N(X(from)), "y", N(y), "width", N(Math.Max(0.5, X(to) - X(from))), "height",
            N(height));

    /// <summary>The frame of a chart.</summary>
    public void WriteFrame(double y, double height)
        => page.Empty(
            "rect", "class", "frame", "x", N(Left), "y", N(y), "width", N(Right - Left), "height", N(height));

    /// <summary>The upper edge of a chart: a round number that is not below.</summary>
    public static double RoundUp(double value)
    {
        double power = Math.Pow(10, Math.Floor(Math.Log10(value)));
        return new[] { 1, 1.5, 2, 3, 4, 5, 6, 8, 10 }.Select(f => f * power).First(v => v >= value * 0.999);
    }

    private static string N(double value) => FlightText.Number(value, "0.##");
}
