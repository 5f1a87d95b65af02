using System;
using System.Numerics;

namespace Rabit.Vision;

/// <summary>
/// Measures a patch below the size of a pixel: from its colour and that of the ground right around it follows of each
/// pixel which part of it is covered. For one thread; allocates only when a patch is larger than any before.
/// </summary>
public sealed class PatchMeasure
{
    private const float ClosedCoverage = 2;

    // Levels: what differs less from the ground has no form that could be measured.
    private const double MinContrast = 25;

    // Ground that is a little like the colour is no part of the patch.
    private const double MinCoverage = 0.15;

    // What is so near of the way from the ground to the colour of the patch is more like that.
    private const double LikePatch = 0.5;

    private const int Sectors = PatchSectors.Count;
    private const int FewOfSector = 3;

    private readonly PatchMap _map = new();
    private readonly BitGrid _half = new();   // what is covered by half and more
    private readonly PatchSamples _samples;
    private readonly GroundSlope _slope;
    private readonly GroundLight _groundLight;
    private readonly MeanColour[] _sectors = new MeanColour[Sectors];
    private PicturePoint[] _outline = [];
    private float[] _coverage = [];
    private byte[] _pixels = [];
    private PatchFinder? _finder;
    private PictureLight? _light;
    private MeanColour _ground;
    private MeanColour _inside;
    private bool _isLookedAt;

    /// <summary>Makes one; it measures once a picture is set.</summary>
    public PatchMeasure()
        => (_samples, _slope, _groundLight) = (new PatchSamples(_map), new GroundSlope(_map), new GroundLight(_map));

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
        _pixels = pixels;
        _map.SetPicture(width, height);
        _samples.SetPicture(pixels);
    }

    /// <summary>
    /// Looks at one patch, or several as one: their colour, that of the ground around them, and the contrast; what
    /// <see cref="TryMeasure"/> adds takes longer. False where there is no contrast.
    /// </summary>
    /// <param name="parts">At least one, of the picture that is set.</param>
    /// <param name="shape">The colours and the contrast; of the rest only the area, roughly.</param>
    public bool TryLook(ReadOnlySpan<Patch> parts, out PatchShape shape) => TryLook(parts, closesGaps: true, out shape);

    /// <summary>
    /// The same where it is known whether what lies between its pixels, up to a quarter of its side, belongs to it, as
    /// the windows of a car, or is ground or what hides it, as between the arms of a cross.
    /// </summary>
    /// <param name="parts">At least one, of the picture that is set.</param>
    /// <param name="closesGaps">Whether it belongs to it.</param>
    /// <param name="shape">As above.</param>
    public bool TryLook(ReadOnlySpan<Patch> parts, bool closesGaps, out PatchShape shape)
    {
        shape = default;
        _isLookedAt = false;
        if (_finder is null || parts.IsEmpty)
            return false;
        _map.Draw(parts, _finder, closesGaps);
        if (_coverage.Length < _map.Columns * _map.Rows)
            _coverage = new float[_map.Columns * _map.Rows];
        _ground = _samples.Ground();
        _inside = _samples.Inside(_ground, out MeanColour pure);
        (double red, double green, double blue) =
            (pure.Red - _ground.Red, pure.Green - _ground.Green, pure.Blue - _ground.Blue);
        double contrast = (red * red) + (green * green) + (blue * blue);
        if (contrast < MinContrast * MinContrast)
            return false;
        shape.Contrast = Math.Sqrt(contrast);
        (shape.Red, shape.Green, shape.Blue) = Corrected(pure);
        (shape.GroundRed, shape.GroundGreen, shape.GroundBlue) = Corrected(_ground);
        foreach (ref readonly Patch part in parts)
            shape.Area += part.Pixels;
        _isLookedAt = true;
        return true;
    }

    /// <summary>Measures what was looked at last; false where too little of it is left.</summary>
    /// <param name="shape">What TryLook gave; the rest is added.</param>
    public bool TryMeasure(ref PatchShape shape)
    {
        if (!_isLookedAt)
            return false;
        (double red, double green, double blue) =
            (_inside.Red - _ground.Red, _inside.Green - _ground.Green, _inside.Blue - _ground.Blue);
        double contrast = (red * red) + (green * green) + (blue * blue);
        if (contrast < 1)
            return false;
        Cover(_ground, red / contrast, green / contrast, blue / contrast);
        return Sum(ref shape) && Judge(ref shape, _inside);
    }

    /// <summary>
    /// Moves the centre of what was measured last to where it is on ground that is the same all around: other ground on
    /// one side pulls it; says how different that is (<see cref="PatchShape.GroundDifference"/>). Nothing else of it
    /// changes, so that only what may be a target needs it.
    /// </summary>
    /// <param name="shape">What <see cref="TryMeasure"/> gave.</param>
    public void CorrectCentre(ref PatchShape shape)
    {
        (double x, double y) = (shape.CentreX, shape.CentreY);
        _slope.Correct(_coverage, MinCoverage, ref shape);
        _groundLight.Correct(_pixels, _coverage, x, y, ref shape);
    }

    /// <summary>Adds to what was measured last what lies around it (<see cref="PatchShape.OtherBeside"/>).</summary>
    /// <param name="shape">What <see cref="TryMeasure"/> gave.</param>
    public void MeasureSurroundings(ref PatchShape shape)
    {
        SumSectors(shape);
        double least = 1;
        foreach (ref readonly MeanColour sector in _sectors.AsSpan())
        {
            if (sector.Count >= FewOfSector)
                least = Math.Min(least, sector.CosineTo(_ground));
        }

        shape.OtherBeside = Math.Acos(Math.Max(-1, least)) * 180 / Math.PI;
    }

    /// <summary>Adds to what was measured last what its form is like (<see cref="PatchShape.Form"/>).</summary>
    /// <param name="shape">What <see cref="TryMeasure"/> gave, before its centre is corrected.</param>
    /// <param name="blurVariance">Of the picture in each direction, square pixels.</param>
    public void MeasureForm(ref PatchShape shape, double blurVariance)
    {
        FormSums sums = default;
        for (int row = 0; row < _map.Rows; row++)
        {
            for (int word = 0; word < _map.Edge.Words; word++)
            {
                for (ulong bits = _map.Edge[row, word]; bits != 0; bits &= bits - 1)
                {
                    int column = (64 * word) + BitOperations.TrailingZeroCount(bits);
                    double part = Math.Min(1, _coverage[(row * _map.Columns) + column]);
                    if (part >= MinCoverage)
                        sums.Add(_map.Left + column - shape.CentreX, _map.Top + row - shape.CentreY, part);
                }
            }
        }

        shape.Form = sums.MomentsWithout(blurVariance);
    }

    /// <summary>The pixels at the edge of what was measured last, of which it covers half or more.</summary>
    /// <returns>Columns and rows of the picture, until the next call.</returns>
    public ReadOnlySpan<PicturePoint> FindOutline()
    {
        int count = 0;
        for (int row = 1; row < _half.Rows - 1; row++)
        {
            for (int word = 0; word < _half.Words; word++)
            {
                ulong inner = _half.Beside(row, word, 1) & _half.Beside(row, word, -1)
                    & _half[row - 1, word] & _half[row + 1, word];
                for (ulong bits = _half[row, word] & ~inner; bits != 0; bits &= bits - 1)
                {
                    if (count == _outline.Length)
                        Array.Resize(ref _outline, Math.Max(64, 2 * count));
                    int column = (64 * word) + BitOperations.TrailingZeroCount(bits);
                    _outline[count++] = new PicturePoint(_map.Left + column, _map.Top + row);
                }
            }
        }

        return _outline.AsSpan(0, count);
    }

    private (double Red, double Green, double Blue) Corrected(in MeanColour colour)
        => (colour.Red * _light!.RedGain, colour.Green, colour.Blue * _light.BlueGain);

    private void Cover(in MeanColour ground, double red, double green, double blue)
    {
        double offset = (ground.Red * red) + (ground.Green * green) + (ground.Blue * blue);
        for (int row = 0; row < _map.Rows; row++)
        {
            for (int word = 0; word < _map.Edge.Words; word++)
            {
                (int column, ulong closed) = (64 * word, _map.Closed[row, word]);
                ulong bits = (_map.Edge[row, word] | _map.Ground[row, word]) & ~closed;
                for (; bits != 0; bits &= bits - 1)
                {
                    int pixel = _map.PixelAt(column + BitOperations.TrailingZeroCount(bits), row);
                    _coverage[(row * _map.Columns) + column + BitOperations.TrailingZeroCount(bits)] =
                        (float)Math.Min(1.9, (_pixels[pixel] * red) + (_pixels[pixel + 1] * green)
                            + (_pixels[pixel + 2] * blue) - offset);
                }

                for (; closed != 0; closed &= closed - 1)
                {
                    _coverage[(row * _map.Columns) + column + BitOperations.TrailingZeroCount(closed)] =
                        ClosedCoverage;
                }
            }
        }
    }

    private bool Sum(ref PatchShape shape)
    {
        (double sum, double sumX, double sumY, double sumXX, double sumXY, double sumYY) = (0, 0, 0, 0, 0, 0);
        (int left, int right, int top, int bottom) = (int.MaxValue, -1, int.MaxValue, -1);
        shape.CutLength = 0;
        _half.Clear(_map.Columns, _map.Rows);
        for (int row = 0; row < _map.Rows; row++)
        {
            for (int word = 0; word < _map.Edge.Words; word++)
            {
                for (ulong bits = _map.Edge[row, word]; bits != 0; bits &= bits - 1)
                {
                    int column = (64 * word) + BitOperations.TrailingZeroCount(bits);
                    double part = Math.Min(1, _coverage[(row * _map.Columns) + column]);
                    if (part < MinCoverage)
                        continue;
                    sum += part;
                    sumX += part * column;
                    sumY += part * row;
                    sumXX += part * column * column;
                    sumXY += part * column * row;
                    sumYY += part * row * row;
                    if (part < 0.5)
                        continue;
                    _half[row, word] |= bits & (~bits + 1);
                    if (_map.IsAtBorder(column, row))
                        shape.CutLength++;
                    (left, right) = (Math.Min(left, column), Math.Max(right, column));
                    (top, bottom) = (Math.Min(top, row), Math.Max(bottom, row));
                }
            }
        }

        if (right < 0)
            return false;
        (double meanX, double meanY) = (sumX / sum, sumY / sum);
        shape.Area = sum;
        shape.CentreX = _map.Left + meanX;
        shape.CentreY = _map.Top + meanY;
        shape.MomentXX = (sumXX / sum) - (meanX * meanX);
        shape.MomentXY = (sumXY / sum) - (meanX * meanY);
        shape.MomentYY = (sumYY / sum) - (meanY * meanY);
        (shape.Width, shape.Height) = (right - left + 1, bottom - top + 1);
        return true;
    }

    // What goes on beyond the edge, how ragged it is, how even inside, and how even the ground is.
    private bool Judge(ref PatchShape shape, in MeanColour inside)
    {
        JudgeGround(ref shape);
        (int steps, int own, double uneven, double length) = (0, 0, 0, inside.Length());
        for (int row = 0; row < _map.Rows; row++)
        {
            for (int word = 0; word < _map.Edge.Words; word++)
            {
                steps += StepsAt(row, word);
                for (ulong bits = _half[row, word]; bits != 0; bits &= bits - 1)
                {
                    int column = (64 * word) + BitOperations.TrailingZeroCount(bits);
                    double part = _coverage[(row * _map.Columns) + column];
                    if (part < 0.8 || part == ClosedCoverage)
                        continue;
                    own++;
                    uneven += inside.SquareTo(_pixels, _map.PixelAt(column, row), length);
                }
            }
        }

        shape.Outline = steps / (2 * (shape.Width + shape.Height));
        shape.Unevenness = own == 0 ? 0 : Math.Sqrt(uneven / own) / shape.Contrast;
        return own > 0;
    }

    private void JudgeGround(ref PatchShape shape)
    {
        (int like, int around, double noise) = (0, 0, 0);
        for (int row = 0; row < _map.Rows; row++)
        {
            for (int word = 0; word < _map.Ground.Words; word++)
            {
                for (ulong bits = _map.Ground[row, word]; bits != 0; bits &= bits - 1)
                {
                    int column = (64 * word) + BitOperations.TrailingZeroCount(bits);
                    double part = _coverage[(row * _map.Columns) + column];
                    around++;
                    if (part > LikePatch)
                        like++;
                    double off = Math.Min(1, Math.Abs(part));
                    noise += off * off;
                }
            }
        }

        shape.Continuation = around == 0 ? 0 : (double)like / around;
        shape.GroundNoise = around == 0 ? 0 : Math.Sqrt(noise / around);
    }

    private void SumSectors(in PatchShape shape)
    {
        Array.Clear(_sectors, 0, Sectors);
        for (int row = 0; row < _map.Rows; row++)
        {
            for (int word = 0; word < _map.Ground.Words; word++)
            {
                for (ulong bits = _map.Ground[row, word]; bits != 0; bits &= bits - 1)
                {
                    int column = (64 * word) + BitOperations.TrailingZeroCount(bits);
                    if (_coverage[(row * _map.Columns) + column] < LikePatch)
                    {
                        _sectors[PatchSectors.Of(_map.Left + column - shape.CentreX, _map.Top + row - shape.CentreY)]
                            .AddHue(_pixels, _map.PixelAt(column, row));
                    }
                }
            }
        }
    }

    // Sides of pixels of the patch with one beyond that is none. The outermost rows of the map have no pixel of it.
    private int StepsAt(int row, int word)
    {
        ulong half = _half[row, word];
        return half == 0 ? 0
            : BitOperations.PopCount(half & ~_half.Beside(row, word, 1))
            + BitOperations.PopCount(half & ~_half.Beside(row, word, -1))
            + BitOperations.PopCount(half & ~_half[row - 1, word])
            + BitOperations.PopCount(half & ~_half[row + 1, word]);
    }
}
