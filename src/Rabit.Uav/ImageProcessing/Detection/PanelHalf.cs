using System;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Whether a form is one half of a panel of two hues: right beside it lies a patch of like size in the other one, with
/// more colour than the ground around both. <see cref="PanelTargetDetector"/> does not find such a panel where the
/// ground has a hue of it, as dry grass in warm light has that of yellow. Fixed memory; one thread.
/// </summary>
internal sealed class PanelHalf
{
    // Of the closeness to the other colour: pixels at its edge are mixed with the first one.
    private const double MinCloseness = 0.35;

    // Levels: what has less has no hue. The median of ground of the same hue has about half of that of the panel; where
    // hardly any of the ground has that hue, it does not count.
    private const double MinChroma = 30;
    private const double MinChromaByGround = 1.9;
    private const double MinShareOfGround = 0.05;

    // The window, and the ring around it that shows the ground, by the side of a panel of which the form is half.
    private const double Window = 1.2;
    private const double Ring = 1.8;

    // The other colour is not that of the ground.
    private const double MaxShareOfRing = 0.1;

    // Of the two areas, and of the distance of the centres and the spread of the other half by the side of both:
    // nominal are 1, 0.5 and 0.32.
    private const double MaxAreaRatio = 2.2;
    private const double MinDistance = 0.3;
    private const double MaxDistance = 0.8;
    private const double MaxSpread = 0.5;

    // Pixels: of a larger one not every pixel is looked at.
    private const double FineSide = 24;

    // The form may have a little of the ground.
    private const double CentreSigma = 0.08;   // of the side

    private readonly int[] _chroma = new int[256];
    private int _step = 1;
    private double _minChroma;
    private ColourRange _other = new(0, 0, 0);

    /// <summary>Finds the panel.</summary>
    /// <param name="input">The picture, in colours.</param>
    /// <param name="form">What was found.</param>
    /// <param name="colour">Its colour.</param>
    /// <param name="panel">A panel of two colours.</param>
    /// <param name="whole">The panel, where it is one.</param>
    public bool TryComplete(
        in DetectorInput input, in TargetDetection form, ColourRange colour, TargetClass panel,
        out TargetDetection whole)
    {
        whole = default;
        if (OtherOf(panel, colour) is not { } other
            || !input.GroundScale.TryAt(form.CentreX, form.CentreY, out GroundScale scale))
            return false;
        _other = other;
        double pixel = Math.Sqrt(scale.PixelArea);
        double side = form.SideMetres * Math.Sqrt(2) / pixel;
        ReadOnlySpan<byte> pixels = input.Pixels.Span;
        _step = Math.Max(1, (int)(side / FineSide));
        _minChroma = MinChroma;   // IsOther also asks it of the ground
        _minChroma = Math.Max(MinChroma, MinChromaByGround * MedianChromaAround(pixels, input, form, side));
        return TryMeasure(pixels, input, form, side, out Half half)
            && TryJoin(form, half, pixel, panel, out whole);
    }

    // Black and white lie beside many a thing, as trousers beside a jacket. Of two halves the outline is not measured.
    private static ColourRange? OtherOf(TargetClass panel, ColourRange colour)
    {
        if (panel.Shape is not (TargetShape.Any or TargetShape.Rectangle)
            || panel is not { Colour: { } first, SecondColour: { } second }
            || PanelColours.IsNeutral(first) || PanelColours.IsNeutral(second))
            return null;
        return CombinedTargetDetector.AreAlike(first, colour) ? second
            : CombinedTargetDetector.AreAlike(second, colour) ? first : null;
    }

    private static (int From, int To) Span(double centre, double reach, int size)
        => (Math.Max(0, (int)(centre - reach)), Math.Min(size - 1, (int)(centre + reach)));

    private static int ChromaAt(ReadOnlySpan<byte> pixels, int at)
    {
        (byte red, byte green, byte blue) = (pixels[at], pixels[at + 1], pixels[at + 2]);
        return Math.Max(red, Math.Max(green, blue)) - Math.Min(red, Math.Min(green, blue));
    }

    private static bool IsInWindow(int column, int row, in TargetDetection form, double side)
        => Math.Max(Math.Abs(column - form.CentreX), Math.Abs(row - form.CentreY)) <= Window * side;

    private bool IsOther(ReadOnlySpan<byte> pixels, int at)
        => ChromaAt(pixels, at) >= _minChroma
            && _other.Closeness(pixels[at], pixels[at + 1], pixels[at + 2]) >= MinCloseness;

    // Of the ground that has the other hue.
    private int MedianChromaAround(
        ReadOnlySpan<byte> pixels, in DetectorInput input, in TargetDetection form, double side)
    {
        Array.Clear(_chroma, 0, _chroma.Length);
        (int count, int all) = (0, 0);
        (int left, int right) = Span(form.CentreX, Ring * side, input.Width);
        (int top, int bottom) = Span(form.CentreY, Ring * side, input.Height);
        for (int row = top; row <= bottom; row += _step)
        {
            for (int column = left; column <= right; column += _step)
            {
                if (IsInWindow(column, row, form, side))
                    continue;
                all++;
                int at = ((row * input.Width) + column) * 3;
                if (!IsOther(pixels, at))
                    continue;
                _chroma[ChromaAt(pixels, at)]++;
                count++;
            }
        }

        if (count < MinShareOfGround * all)
            return 0;

        (int sum, int value) = (0, 0);
        while (value < 255 && 2 * (sum += _chroma[value]) < count)
            value++;
        return value;
    }

    // What has the other colour.
    private bool TryMeasure(
        ReadOnlySpan<byte> pixels, in DetectorInput input, in TargetDetection form, double side, out Half half)
    {
        half = default;
        (int ring, int covered, int count) = (0, 0, 0);
        (double sumX, double sumY, double squares) = (0, 0, 0);
        (int left, int right) = Span(form.CentreX, Ring * side, input.Width);
        (int top, int bottom) = Span(form.CentreY, Ring * side, input.Height);
        for (int row = top; row <= bottom; row += _step)
        {
            for (int column = left; column <= right; column += _step)
            {
                bool isInWindow = IsInWindow(column, row, form, side);
                ring += isInWindow ? 0 : 1;
                if (!IsOther(pixels, ((row * input.Width) + column) * 3))
                    continue;
                covered += isInWindow ? 0 : 1;
                if (!isInWindow)
                    continue;
                count++;
                (double x, double y) = (column - form.CentreX, row - form.CentreY);
                (sumX, sumY, squares) = (sumX + x, sumY + y, squares + (x * x) + (y * y));
            }
        }

        if (count == 0 || covered > MaxShareOfRing * ring)
            return false;
        (double meanX, double meanY) = (sumX / count, sumY / count);
        half.Area = count * _step * _step;
        (half.X, half.Y) = (meanX, meanY);
        half.Spread = Math.Sqrt((squares / count) - (meanX * meanX) - (meanY * meanY));
        return true;
    }

    private static bool TryJoin(
        in TargetDetection form, in Half half, double pixel, TargetClass panel, out TargetDetection whole)
    {
        whole = form;
        double area = form.SideMetres * form.SideMetres / (pixel * pixel);
        double side = Math.Sqrt(area + half.Area);
        double distance = Math.Sqrt((half.X * half.X) + (half.Y * half.Y)) / side;
        if (Math.Max(area, half.Area) > MaxAreaRatio * Math.Min(area, half.Area)
            || distance < MinDistance || distance > MaxDistance || half.Spread > MaxSpread * side
            || side * pixel < panel.MinSideMetres || side * pixel > panel.MaxSideMetres)
            return false;
        whole.Class = panel.Name;
        (whole.CentreX, whole.CentreY) = (form.CentreX + (half.X / 2), form.CentreY + (half.Y / 2));
        (whole.WidthPixels, whole.HeightPixels) = (Window * side, Window * side);
        whole.SideMetres = side * pixel;
        whole.Bearing = null;
        whole.Covariance = PixelCovariance.FromSigma(CentreSigma * side);
        return true;
    }

    // The other half; pixels, its centre from that of the form.
    private struct Half
    {
        public double Area;
        public double X;
        public double Y;
        public double Spread;
    }
}
