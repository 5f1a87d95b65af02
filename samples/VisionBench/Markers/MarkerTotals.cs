using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace VisionBench;

/// <summary>The figures of the markers of a set, or of a part of it.</summary>
internal sealed class MarkerTotals
{
    private readonly double[] _cornerErrors;

    public MarkerTotals(IEnumerable<MarkerScore> pictures)
    {
        MarkerScore[] all = pictures.ToArray();
        MarkerMatch[] matches = all.SelectMany(p => p.Matches).ToArray();
        (Found, Of) = (matches.Count(m => m.Found is not null), matches.Length);
        Wrong = all.Sum(p => p.Wrong.Count);
        _cornerErrors = matches.SelectMany(m => m.CornerErrors).OrderBy(e => e).ToArray();
    }

    public int Found { get; }

    public int Of { get; }

    public int Wrong { get; }

    /// <summary>Pixels; not a number where none was found.</summary>
    public double CornerRms
        => _cornerErrors.Length == 0 ? double.NaN : Math.Sqrt(_cornerErrors.Average(e => e * e));

    /// <summary>Pixels; not a number where none was found.</summary>
    public double CornerMedian => _cornerErrors.Length == 0 ? double.NaN : _cornerErrors[_cornerErrors.Length / 2];

    /// <summary>The lines of a table: what it is, the value, and that of the reference where there is one.</summary>
    public IEnumerable<(string Name, string Value, string Reference)> Rows(MarkerBaseline? baseline)
    {
        yield return ("markers found", Of == 0 ? "-" : $"{Found}/{Of}", baseline?.Found ?? "");
        yield return ("wrong ids", Wrong.ToString(CultureInfo.InvariantCulture), baseline?.Wrong ?? "");
        yield return ("corner RMS, markers, px", Number(CornerRms), baseline?.CornerRms ?? "");
        yield return ("corner median, markers, px", Number(CornerMedian), "");
    }

    private static string Number(double value)
        => double.IsNaN(value) ? "-" : value.ToString("0.00", CultureInfo.InvariantCulture);
}
