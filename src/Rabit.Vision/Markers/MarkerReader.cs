using System;

namespace Rabit.Vision;

/// <summary>
/// Reads the cells of a quadrilateral that may be a marker: black and white are planes of grey over it, after its black
/// ring and the white around it. For one thread.
/// </summary>
internal sealed class MarkerReader
{
    private const int MaxCells = 8;
    private const double QuietZone = 0.5;

    // Of the cells of the ring and around it, that must be on the right side of the middle grey.
    private const double MinRing = 0.9;
    private const double MinQuiet = 0.8;

    // A cell less this part of the difference to its neighbours: blur mixed them.
    private const double Sharpening = 0.25;

    private readonly double[] _values = new double[MaxCells * MaxCells];
    private readonly double[] _ring = new double[4 * MaxCells];
    private readonly double[] _quiet = new double[4 * MaxCells];

    /// <summary>Reads; false if it is no marker of the dictionary.</summary>
    public bool TryRead(
        in GreyView grey, in MarkerCorners quad, MarkerDictionary dictionary, int minContrast,
        out DetectedMarker marker)
    {
        marker = default;
        PlaneMap map = PlaneMap.ToQuad(quad);
        int cells = dictionary.Cells;
        MarkerLimits limits = dictionary.Limits;
        if (!map.IsInFront)
            return false;
        ReadBorder(grey, map, cells, out GreyPlane black, out GreyPlane white);
        if (!IsBorder(cells, black, white, minContrast, limits))
            return false;
        ReadCells(grey, map, cells, black, white);
        double margin = Sharpen(cells, out ulong code, out double worst);
        if (margin < limits.MinMargin || worst < limits.MinCell
            || !dictionary.TryFind(code, out int id, out int turn, out int distance))
            return false;
        marker.Family = dictionary.Family;
        marker.Id = id;
        marker.CorrectedBits = distance;
        marker.Margin = margin;
        marker.Contrast = white.At(0.5, 0.5) - black.At(0.5, 0.5);
        marker.Corners = quad.From(turn);
        return true;
    }

    private static (double U, double V) OnBorder(int at, int cells, double inwards)
    {
        double along = ((at % cells) + 0.5) / cells;
        inwards /= cells;
        return (at / cells) switch
        {
            0 => (along, inwards),
            1 => (1 - inwards, along),
            2 => (1 - along, 1 - inwards),
            _ => (inwards, 1 - along),
        };
    }

    private static double Read(in GreyView grey, in PlaneMap map, double u, double v)
    {
        PicturePoint point = map.Map(u, v);
        return grey.At(point.X, point.Y);
    }

    private void ReadBorder(in GreyView grey, in PlaneMap map, int cells, out GreyPlane black, out GreyPlane white)
    {
        var blackFit = default(GreyPlane.Sums);
        var whiteFit = default(GreyPlane.Sums);
        for (int at = 0; at < 4 * cells; at++)
        {
            (double u, double v) = OnBorder(at, cells, 0.5);
            blackFit.Add(u, v, _ring[at] = Read(grey, map, u, v));
            (u, v) = OnBorder(at, cells, -QuietZone);
            whiteFit.Add(u, v, _quiet[at] = Read(grey, map, u, v));
        }

        black = blackFit.Solve();
        white = whiteFit.Solve();
    }

    // Black inside and white around it, both even.
    private bool IsBorder(int cells, in GreyPlane black, in GreyPlane white, int minContrast, MarkerLimits limits)
    {
        int count = 4 * cells;
        (int ring, int quiet) = (0, 0);
        (double ringOff, double quietOff) = (0, 0);
        for (int at = 0; at < count; at++)
        {
            (double u, double v) = OnBorder(at, cells, 0.5);
            double range = white.At(u, v) - black.At(u, v);
            if (range < minContrast)
                return false;
            double value = (_ring[at] - black.At(u, v)) / range;
            ring += value < 0.5 ? 1 : 0;
            ringOff += value * value;
            quiet += (_quiet[at] - black.At(u, v)) / range > 0.5 ? 1 : 0;
            (u, v) = OnBorder(at, cells, -QuietZone);
            value = (_quiet[at] - white.At(u, v)) / range;
            quietOff += value * value;
        }

        return ring >= MinRing * count && quiet >= MinQuiet * count
            && ringOff + quietOff <= limits.MaxUnevenness * limits.MaxUnevenness * count;
    }

    // The mean of four places about the middle of each, black 0 and white 1.
    private void ReadCells(in GreyView grey, in PlaneMap map, int cells, in GreyPlane black, in GreyPlane white)
    {
        double size = 1.0 / cells;
        double aside = 0.2 * size;
        for (int at = 0; at < cells * cells; at++)
        {
            double u = ((at % cells) + 0.5) * size;
            double v = ((at / cells) + 0.5) * size;
            double sum = Read(grey, map, u - aside, v - aside) + Read(grey, map, u + aside, v - aside)
                + Read(grey, map, u - aside, v + aside) + Read(grey, map, u + aside, v + aside);
            double low = black.At(u, v);
            _values[at] = ((sum / 4) - low) / (white.At(u, v) - low);
        }
    }

    private double Sharpen(int cells, out ulong code, out double worst)
    {
        double[] values = _values;
        (code, worst) = (0, 1);
        double margin = 0;
        for (int row = 1; row < cells - 1; row++)
        {
            for (int column = 1; column < cells - 1; column++)
            {
                int at = (row * cells) + column;
                double value = values[at] + (Sharpening * ((4 * values[at]) - values[at - 1] - values[at + 1]
                    - values[at - cells] - values[at + cells]));
                code = (code << 1) | (value > 0.5 ? 1u : 0);
                double clear = Math.Min(1, 2 * Math.Abs(value - 0.5));
                margin += clear;
                worst = Math.Min(worst, clear);
            }
        }

        return margin / ((cells - 2) * (cells - 2));
    }
}
