using System;

namespace Rabit.Uav.Simulation;

/// <summary>
/// What baseline JPEG takes from a picture: colours at half the resolution, and the coefficients of the cosine
/// transform in steps (ISO/IEC 10918-1, annex A and the tables of annex K, scaled by quality as libjpeg does). Nothing
/// is coded. Only sums and products, so that every runtime gives the same. Allocates nothing for a picture.
/// </summary>
internal sealed class JpegLoss
{
    private const int Side = 8;

    private static readonly byte[] LuminanceSteps =
    [
        16, 11, 10, 16, 24, 40, 51, 61, 12, 12, 14, 19, 26, 58, 60, 55, 14, 13, 16, 24, 40, 57, 69, 56,
        14, 17, 22, 29, 51, 87, 80, 62, 18, 22, 37, 56, 68, 109, 103, 77, 24, 35, 55, 64, 81, 104, 113, 92,
        49, 64, 78, 87, 103, 121, 120, 101, 72, 92, 95, 98, 112, 100, 103, 99,
    ];

    private static readonly byte[] ColourSteps =
    [
        17, 18, 24, 47, 99, 99, 99, 99, 18, 21, 26, 66, 99, 99, 99, 99, 24, 26, 56, 99, 99, 99, 99, 99,
        47, 66, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99,
        99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99,
    ];

    // cos(k pi / 16), written out: runtimes compute a cosine each in its own way.
    private static readonly double[] Cosines =
    [
        1, 0.9807852804032304, 0.9238795325112867, 0.8314696123025452, 0.7071067811865476, 0.5555702330196022,
        0.3826834323650898, 0.19509032201612825, 0,
    ];

    private static readonly double[] Basis = MakeBasis();

    private readonly int _width;
    private readonly int _height;
    private readonly int[] _luminance;
    private readonly int[] _colour;
    private readonly JpegPlane _y;
    private readonly JpegPlane _blue;
    private readonly JpegPlane _red;
    private readonly double[] _block = new double[Side * Side];
    private readonly double[] _turned = new double[Side * Side];

    public JpegLoss(int width, int height, int quality)
    {
        (_width, _height) = (width, height);
        (_luminance, _colour) = (Scaled(LuminanceSteps, quality), Scaled(ColourSteps, quality));
        _y = new JpegPlane(width, height);
        _blue = new JpegPlane((width + 1) / 2, (height + 1) / 2);
        _red = new JpegPlane((width + 1) / 2, (height + 1) / 2);
    }

    public void Apply(byte[] pixels)
    {
        Split(pixels);
        Quantize(_y, _luminance);
        Quantize(_blue, _colour);
        Quantize(_red, _colour);
        Join(pixels);
    }

    private static int[] Scaled(byte[] steps, int quality)
    {
        int scale = quality < 50 ? 5000 / quality : 200 - (2 * quality);
        return Array.ConvertAll(steps, s => Math.Max(1, Math.Min(255, ((s * scale) + 50) / 100)));
    }

    // The orthonormal cosine transform: [frequency, place].
    private static double[] MakeBasis()
    {
        double[] basis = new double[Side * Side];
        for (int k = 0; k < Side; k++)
        {
            for (int n = 0; n < Side; n++)
            {
                int turn = (((2 * n) + 1) * k) % 32;   // 32 is a whole turn
                double cosine = turn <= 8 ? Cosines[turn]
                    : turn <= 16 ? -Cosines[16 - turn]
                    : turn <= 24 ? -Cosines[turn - 16]
                    : Cosines[32 - turn];
                basis[(k * Side) + n] = k == 0 ? Cosines[4] / 2 : cosine / 2;
            }
        }

        return basis;
    }

    // ITU-R BT.601 as in JFIF, without its offset of the colours.
    private void Split(byte[] pixels)
    {
        Array.Clear(_blue.Levels, 0, _blue.Levels.Length);
        Array.Clear(_red.Levels, 0, _red.Levels.Length);
        int at = 0;
        for (int v = 0; v < _height; v++)
        {
            for (int u = 0; u < _width; u++)
            {
                (int r, int g, int b) = (pixels[at], pixels[at + 1], pixels[at + 2]);
                double y = (0.299 * r) + (0.587 * g) + (0.114 * b);
                _y.Levels[(v * _y.Stride) + u] = y - 128;
                int half = ((v / 2) * _blue.Stride) + (u / 2);

                // The last of an odd number of columns or rows has no neighbour, and counts for both.
                double weight = (u == _width - 1 && _width % 2 == 1 ? 0.5 : 0.25)
                    * (v == _height - 1 && _height % 2 == 1 ? 2 : 1);
                _blue.Levels[half] += weight * 0.564 * (b - y);
                _red.Levels[half] += weight * 0.713 * (r - y);
                at += 3;
            }
        }
    }

    private void Quantize(JpegPlane plane, int[] steps)
    {
        plane.Pad();
        for (int top = 0; top < plane.Rows; top += Side)
        {
            for (int left = 0; left < plane.Stride; left += Side)
                Quantize(plane.Levels, (top * plane.Stride) + left, plane.Stride, steps);
        }
    }

    private void Quantize(double[] levels, int first, int stride, int[] steps)
    {
        // Rows, then columns; then the steps; then back.
        for (int row = 0; row < Side; row++)
        {
            for (int k = 0; k < Side; k++)
            {
                double sum = 0;
                for (int n = 0; n < Side; n++)
                    sum += Basis[(k * Side) + n] * levels[first + (row * stride) + n];
                _turned[(k * Side) + row] = sum;
            }
        }

        for (int column = 0; column < Side; column++)
        {
            for (int k = 0; k < Side; k++)
            {
                double sum = 0;
                for (int n = 0; n < Side; n++)
                    sum += Basis[(k * Side) + n] * _turned[(column * Side) + n];
                int step = steps[(k * Side) + column];
                _block[(k * Side) + column] = step * Math.Floor((sum / step) + 0.5);
            }
        }

        for (int row = 0; row < Side; row++)
        {
            for (int n = 0; n < Side; n++)
            {
                double sum = 0;
                for (int k = 0; k < Side; k++)
                    sum += Basis[(k * Side) + n] * _block[(row * Side) + k];
                _turned[(n * Side) + row] = sum;
            }
        }

        for (int column = 0; column < Side; column++)
        {
            for (int n = 0; n < Side; n++)
            {
                double sum = 0;
                for (int k = 0; k < Side; k++)
                    sum += Basis[(k * Side) + n] * _turned[(column * Side) + k];
                levels[first + (n * stride) + column] = sum;
            }
        }
    }

    private void Join(byte[] pixels)
    {
        int at = 0;
        for (int v = 0; v < _height; v++)
        {
            for (int u = 0; u < _width; u++)
            {
                double y = _y.Levels[(v * _y.Stride) + u] + 128;
                int half = ((v / 2) * _blue.Stride) + (u / 2);
                (double blue, double red) = (_blue.Levels[half], _red.Levels[half]);
                pixels[at] = Level(y + (1.402 * red));
                pixels[at + 1] = Level(y - (0.344_136 * blue) - (0.714_136 * red));
                pixels[at + 2] = Level(y + (1.772 * blue));
                at += 3;
            }
        }
    }

    private static byte Level(double value) => (byte)Math.Max(0, Math.Min(255, Math.Floor(value + 0.5)));
}
