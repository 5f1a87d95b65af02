using System;
using System.Collections.Generic;
using System.Linq;
using VisionBench;

namespace Rabit.Vision.Tests.Markers;

/// <summary>What a detector found in a set of pictures, against the truth.</summary>
internal sealed class MarkerScore
{
    private readonly MarkerDetector _detector = new();
    private readonly List<double> _cornerErrors = [];
    private double _chiSquare;
    private byte[] _grey = [];

    public int Expected { get; private set; }

    public int Found { get; private set; }

    public List<string> Wrong { get; } = [];

    public double CornerRms => Math.Sqrt(_cornerErrors.Sum(e => e * e) / _cornerErrors.Count);

    public double CornerMedian => _cornerErrors.OrderBy(e => e).ElementAt(_cornerErrors.Count / 2);

    /// <summary>Mean square of an error of a coordinate by its stated sigma.</summary>
    public double ChiSquare => _chiSquare / _cornerErrors.Count;

    public override string ToString() => FormattableString.Invariant(
        $"{Found} of {Expected}, {Wrong.Count} wrong; corners: RMS {CornerRms:0.000} px, median {CornerMedian:0.000} px, (error / sigma)^2 {ChiSquare:0.00}");

    /// <summary>Searches one picture.</summary>
    /// <param name="picture">The picture.</param>
    /// <param name="name">What is said of it.</param>
    /// <param name="truths">What is in it; those that do not count may be found or not.</param>
    /// <param name="mayBe">Whether a reading where no truth is may be right all the same.</param>
    public void Add(
        RgbPicture picture, string name, IReadOnlyList<ListedMarker> truths, Func<DetectedMarker, bool>? mayBe = null)
    {
        int size = picture.Width * picture.Height;
        if (_grey.Length < size)
            _grey = new byte[size];
        GreyPixels.FromRgb(picture.Pixels.AsSpan(0, size * 3), _grey);
        List<DetectedMarker> found = [.. _detector.Find(_grey, picture.Width, picture.Height).ToArray()];
        foreach (ListedMarker truth in truths)
        {
            int at = found.FindIndex(m => truth.Is(m));
            Expected += truth.Counts ? 1 : 0;
            if (at < 0)
                continue;
            if (truth.Counts)
                AddFound(found[at], truth);
            found.RemoveAt(at);
        }

        Wrong.AddRange(found.Where(m => mayBe?.Invoke(m) != true)
            .Select(m => $"{name}: {m.Family} {m.Id} at {m.Corners}"));
    }

    private void AddFound(DetectedMarker marker, ListedMarker truth)
    {
        Found++;
        for (int i = 0; i < 4; i++)
        {
            double x = marker.Corners[i].X - truth.Corners[i].X;
            double y = marker.Corners[i].Y - truth.Corners[i].Y;
            double square = (x * x) + (y * y);
            _cornerErrors.Add(Math.Sqrt(square));
            _chiSquare += square / 2 / (marker.CornerSigmaPixels * marker.CornerSigmaPixels);
        }
    }
}
