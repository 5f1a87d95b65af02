using System;

namespace Rabit.Vision;

/// <summary>
/// Measures a patch below the size of a pixel: from its colour and that of the ground right around it follows of each
/// pixel which part of it is covered. For one thread; allocates only when a patch is larger than any before.
/// </summary>
public sealed class PatchMeasure
{
    // The map of a patch has for each pixel how far it is from the patch: its edge may reach a little beyond it, and
    // after that comes the ground around it.
    private const byte EdgeReach = 2;
    private const byte GroundReach = 4;
    private const float ClosedCoverage = 2;

    // Levels: what differs less from the ground has no form that could be measured.
    private const double MinContrast = 25;

    // Ground that is a little like the colour is no part of the patch.
    private const double MinCoverage = 0.15;

    // Of a patch without an inner pixel, those that are covered most show its colour best.
    private const double NearlyFull = 0.8;

    private readonly int[] _red = new int[256];
    private readonly int[] _green = new int[256];
    private readonly int[] _blue = new int[256];
    private byte[] _map = [];
    private float[] _coverage = [];
    private byte[] _pixels = [];
    private PatchFinder? _finder;
    private PictureLight? _light;
    private int _width;
    private int _height;
    private int _left;
    private int _top;
    private int _columns;
    private int _rows;
    private MeanColour _ground;
    private MeanColour _inside;
    private bool _isLookedAt;

    /// <summary>Sets the picture whose patches are measured from now on.</summary>
    /// <param name="pixels">Red, green, blue, row by row; read until the next picture is set.</param>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    /// <param name="finder">What found its patches.</param>
    /// <param name="light">Its light.</param>
    /// <exception cref="ArgumentException">The buffer is too small for the size.</exception>
    public void SetPicture(byte[] pixels, int width, int height, PatchFinder finder, PictureLight light)
    {
        PixelBuffer.Check(pixels, width, height);
        _finder = finder ?? throw new ArgumentNullException(nameof(finder));
        _light = light ?? throw new ArgumentNullException(nameof(light));
        (_pixels, _width, _height) = (pixels, width, height);
    }

    /// <summary>
    /// Looks at one patch, or several as one: their colour, that of the ground around them, and the contrast; what
    /// <see cref="TryMeasure"/> adds takes longer. False where there is no contrast.
    /// </summary>
    /// <param name="parts">At least one, of the picture that is set.</param>
    /// <param name="shape">The colours and the contrast; of the rest only the area, roughly.</param>
    public bool TryLook(ReadOnlySpan<Patch> parts, out PatchShape shape)
    {
        shape = default;
        _isLookedAt = false;
        if (_finder is null || parts.IsEmpty)
            return false;
        DrawMap(parts);
        _ground = GroundOf();
        _inside = InsideOf(_ground);
        (double red, double green, double blue) =
            (_inside.Red - _ground.Red, _inside.Green - _ground.Green, _inside.Blue - _ground.Blue);
        double contrast = (red * red) + (green * green) + (blue * blue);
        if (contrast < MinContrast * MinContrast)
            return false;
        shape.Contrast = Math.Sqrt(contrast);
        (shape.Red, shape.Green, shape.Blue) = Corrected(_inside);
        (shape.GroundRed, shape.GroundGreen, shape.GroundBlue) = Corrected(_ground);
        foreach (ref readonly Patch part in parts)
            shape.Area += part.Pixels;
        _isLookedAt = true;
        return true;
    }

    /// <summary>Measures what was looked at last; false where too little of it is left.</summary>
    /// <param name="shape">What <see cref="TryLook"/> gave; the rest is added.</param>
    public bool TryMeasure(ref PatchShape shape)
    {
        if (!_isLookedAt)
            return false;
        (double red, double green, double blue) =
            (_inside.Red - _ground.Red, _inside.Green - _ground.Green, _inside.Blue - _ground.Blue);
        double contrast = (red * red) + (green * green) + (blue * blue);
        Cover(_ground, red / contrast, green / contrast, blue / contrast);
        return Sum(ref shape) && Judge(ref shape, _inside);
    }

    private (double Red, double Green, double Blue) Corrected(in MeanColour colour)
        => (colour.Red * _light!.RedGain, colour.Green, colour.Blue * _light.BlueGain);

    private void DrawMap(ReadOnlySpan<Patch> parts)
    {
        (int left, int top, int right, int bottom) = (int.MaxValue, int.MaxValue, 0, 0);
        foreach (ref readonly Patch part in parts)
        {
            (left, top) = (Math.Min(left, part.Left), Math.Min(top, part.Top));
            (right, bottom) = (Math.Max(right, part.Right), Math.Max(bottom, part.Bottom));
        }

        (_left, _top) = (left - GroundReach, top - GroundReach);
        (_columns, _rows) = (right + GroundReach + 1 - _left, bottom + GroundReach + 1 - _top);
        if (_map.Length < _columns * _rows)
        {
            _map = new byte[_columns * _rows];
            _coverage = new float[_map.Length];
        }

        for (int at = 0; at < _columns * _rows; at++)
            _map[at] = PatchDistances.Far;
        foreach (ref readonly Patch part in parts)
            _finder!.Draw(part, _map, _left, _top, _columns, mark: 0);
        PatchDistances.Close(_map, _columns, _rows, GroundReach);
        PatchDistances.Grow(_map, _columns, _rows);
        LeaveOutside();
    }

    private void LeaveOutside()
    {
        for (int row = 0; row < _rows; row++)
        {
            bool isOutside = row + _top < 0 || row + _top >= _height;
            for (int column = 0; column < _columns; column++)
            {
                if (isOutside || column + _left < 0 || column + _left >= _width)
                    _map[(row * _columns) + column] = PatchDistances.Far;
            }
        }
    }

    // The median, so that a second thing beside it, a shadow or a road's line does not count.
    private MeanColour GroundOf()
    {
        Array.Clear(_red, 0, 256);
        Array.Clear(_green, 0, 256);
        Array.Clear(_blue, 0, 256);
        int count = 0;
        for (int row = 0; row < _rows; row++)
        {
            for (int column = 0; column < _columns; column++)
            {
                if (_map[(row * _columns) + column] is not (> EdgeReach and <= GroundReach))
                    continue;
                int at = PixelAt(column, row);
                _red[_pixels[at]]++;
                _green[_pixels[at + 1]]++;
                _blue[_pixels[at + 2]]++;
                count++;
            }
        }

        return new MeanColour { Red = Median(_red, count), Green = Median(_green, count), Blue = Median(_blue, count) };
    }

    private static int Median(int[] histogram, int all)
    {
        (int sum, int value) = (0, 0);
        while (value < 255 && 2 * (sum += histogram[value]) < all)
            value++;
        return value;
    }

    // The mean of the pixels that have only such around them; where it is too thin for that, of those furthest from
    // the ground.
    private MeanColour InsideOf(in MeanColour ground)
    {
        MeanColour inner = default;
        MeanColour all = default;
        for (int row = 1; row < _rows - 1; row++)
        {
            for (int column = 1; column < _columns - 1; column++)
            {
                int at = (row * _columns) + column;
                if (_map[at] != 0)
                    continue;
                int pixel = PixelAt(column, row);
                all.Add(_pixels, pixel);
                if ((_map[at - 1] | _map[at + 1] | _map[at - _columns] | _map[at + _columns]) == 0)
                    inner.Add(_pixels, pixel);
            }
        }

        if (inner.Count >= 4)
            return inner.Mean();
        MeanColour mean = all.Mean();
        (double red, double green, double blue) =
            (mean.Red - ground.Red, mean.Green - ground.Green, mean.Blue - ground.Blue);
        double most = Strongest(ground, red, green, blue, double.PositiveInfinity, out _);
        Strongest(ground, red, green, blue, NearlyFull * most, out MeanColour best);
        return best.Count > 0 ? best.Mean() : mean;
    }

    private double Strongest(
        in MeanColour ground, double red, double green, double blue, double from, out MeanColour mean)
    {
        double most = 0;
        mean = default;
        for (int row = 0; row < _rows; row++)
        {
            for (int column = 0; column < _columns; column++)
            {
                if (_map[(row * _columns) + column] != 0)
                    continue;
                int at = PixelAt(column, row);
                double along = ((_pixels[at] - ground.Red) * red) + ((_pixels[at + 1] - ground.Green) * green)
                    + ((_pixels[at + 2] - ground.Blue) * blue);
                most = Math.Max(most, along);
                if (along >= from)
                    mean.Add(_pixels, at);
            }
        }

        return most;
    }

    private void Cover(in MeanColour ground, double red, double green, double blue)
    {
        double offset = (ground.Red * red) + (ground.Green * green) + (ground.Blue * blue);
        for (int row = 0; row < _rows; row++)
        {
            for (int column = 0; column < _columns; column++)
            {
                int at = (row * _columns) + column;
                if (_map[at] == PatchDistances.Closed)
                {
                    _map[at] = 1;
                    _coverage[at] = ClosedCoverage;
                    continue;
                }

                if (_map[at] > GroundReach)
                    continue;
                int pixel = PixelAt(column, row);
                _coverage[at] = (float)Math.Min(1.9, (_pixels[pixel] * red) + (_pixels[pixel + 1] * green)
                    + (_pixels[pixel + 2] * blue) - offset);
            }
        }
    }

    private bool Sum(ref PatchShape shape)
    {
        (double sum, double sumX, double sumY, double sumXX, double sumXY, double sumYY) = (0, 0, 0, 0, 0, 0);
        (int left, int right, int top, int bottom) = (int.MaxValue, -1, int.MaxValue, -1);
        for (int row = 0; row < _rows; row++)
        {
            for (int column = 0; column < _columns; column++)
            {
                int at = (row * _columns) + column;
                if (_map[at] > EdgeReach || _coverage[at] < MinCoverage)
                    continue;
                double part = Math.Min(1, _coverage[at]);
                sum += part;
                sumX += part * column;
                sumY += part * row;
                sumXX += part * column * column;
                sumXY += part * column * row;
                sumYY += part * row * row;
                if (part < 0.5)
                    continue;
                (left, right) = (Math.Min(left, column), Math.Max(right, column));
                (top, bottom) = (Math.Min(top, row), Math.Max(bottom, row));
            }
        }

        if (right < 0)
            return false;
        (double meanX, double meanY) = (sumX / sum, sumY / sum);
        shape.Area = sum;
        shape.CentreX = _left + meanX;
        shape.CentreY = _top + meanY;
        shape.MomentXX = (sumXX / sum) - (meanX * meanX);
        shape.MomentXY = (sumXY / sum) - (meanX * meanY);
        shape.MomentYY = (sumYY / sum) - (meanY * meanY);
        (shape.Width, shape.Height) = (right - left + 1, bottom - top + 1);
        shape.TouchesBorder = left + _left <= 0 || top + _top <= 0 || right + _left >= _width - 1
            || bottom + _top >= _height - 1;
        return true;
    }

    // What goes on beyond the edge, how ragged it is, how even inside, and how even the ground is.
    private bool Judge(ref PatchShape shape, in MeanColour inside)
    {
        (int like, int around, int steps, int own) = (0, 0, 0, 0);
        (double noise, double uneven) = (0, 0);
        for (int row = 0; row < _rows; row++)
        {
            for (int column = 0; column < _columns; column++)
            {
                int at = (row * _columns) + column;
                if (_map[at] > GroundReach)
                    continue;
                double part = _coverage[at];
                if (_map[at] > EdgeReach)
                {
                    around++;
                    if (part > 0.5)
                        like++;
                    double off = Math.Min(1, Math.Abs(part));
                    noise += off * off;
                    continue;
                }

                steps += part < 0.5 ? 0 : StepsAt(at, column, row);
                if (part < 0.8)
                    continue;
                if (part == ClosedCoverage)
                    continue;
                own++;
                uneven += inside.SquareTo(_pixels, PixelAt(column, row));
            }
        }

        shape.Continuation = around == 0 ? 0 : (double)like / around;
        shape.GroundNoise = around == 0 ? 0 : Math.Sqrt(noise / around);
        shape.Outline = steps / (2 * (shape.Width + shape.Height));
        shape.Unevenness = own == 0 ? 0 : Math.Sqrt(uneven / own) / shape.Contrast;
        return own > 0;
    }

    // Sides of a pixel of the patch with one beyond that is none.
    private int StepsAt(int at, int column, int row)
    {
        int steps = 0;
        if (column == 0 || _map[at - 1] > EdgeReach || _coverage[at - 1] < 0.5)
            steps++;
        if (column == _columns - 1 || _map[at + 1] > EdgeReach || _coverage[at + 1] < 0.5)
            steps++;
        if (row == 0 || _map[at - _columns] > EdgeReach || _coverage[at - _columns] < 0.5)
            steps++;
        if (row == _rows - 1 || _map[at + _columns] > EdgeReach || _coverage[at + _columns] < 0.5)
            steps++;
        return steps;
    }

    private int PixelAt(int column, int row) => (((row + _top) * _width) + column + _left) * 3;
}
