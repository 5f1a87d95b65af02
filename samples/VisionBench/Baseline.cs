using System;
using System.Collections.Generic;
using System.Globalization;

namespace VisionBench;

/// <summary>The figures of the reference, OpenCV's colour chain, for one set.</summary>
internal sealed class Baseline
{
    private readonly Dictionary<string, string> _counts = new(StringComparer.Ordinal);

    /// <summary>Those of markers; null where there are none.</summary>
    public MarkerBaseline? Markers { get; private set; }

    public double FalseAlarmsPerFrame { get; private set; }

    public double ClearPanelRms { get; private set; }

    /// <summary>Null where there is none beside the set.</summary>
    /// <exception cref="FormatException">It cannot be understood; names file and field.</exception>
    public static Baseline? Load(string folder)
    {
        if (BaselineField.OfSet(folder)?.Find("colour") is not { } colour)
            return null;
        var baseline = new Baseline
        {
            Markers = MarkerBaseline.Load(folder),
            FalseAlarmsPerFrame = colour.Of("fa_per_frame").Number(),
            ClearPanelRms = colour.Of("centroid_rms_px_clear_panels_6px_up").Number(),
        };
        foreach (string group in (string[])["by_size", "by_class"])
        {
            foreach ((string name, BaselineField count) in colour.Of(group).All())
                baseline._counts[name] = count.Count();
        }

        return baseline;
    }

    /// <summary>Found and counted of several ranges or kinds together; 0 of 0 where one is not known.</summary>
    public (int Found, int Of) Sum(params string[] whats)
    {
        (int found, int of) = (0, 0);
        foreach (string what in whats)
        {
            string[] parts = Count(what).Split('/');
            if (parts.Length != 2)
                return (0, 0);
            found += int.Parse(parts[0], CultureInfo.InvariantCulture);
            of += int.Parse(parts[1], CultureInfo.InvariantCulture);
        }

        return (found, of);
    }

    /// <summary>As "found/of", for a range of sizes ("4-6", "6-10", "10+") or a kind of target.</summary>
    public string Count(string what) => _counts.TryGetValue(what, out string? count) ? count : "-";
}
