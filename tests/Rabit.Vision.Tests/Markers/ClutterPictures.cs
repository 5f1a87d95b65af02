using System;

namespace Rabit.Vision.Tests.Markers;

/// <summary>
/// Pictures without markers, of what is taken for one most easily: noise, ground, dark squares on light ones, frames,
/// windows in walls, boards of squares, and writing. The same for the same seed.
/// </summary>
internal sealed class ClutterPictures(int seed, int width, int height)
{
    private const int Kinds = 8;

    private readonly Random _random = new(seed);
    private readonly byte[] _grey = new byte[width * height];
    private readonly int[] _sums = new int[width * height];

    /// <summary>The next picture; the same array each time.</summary>
    public byte[] Next(int number)
    {
        int kind = number % Kinds;
        if (kind == 0)
        {
            _random.NextBytes(_grey);
            return _grey;
        }

        Ground();
        switch (kind)
        {
            case 1:
                break;
            case 2:
                Many(60, () => Rectangle(Level(), Level()));
                break;
            case 3:
                Many(40, Frames);
                break;
            case 4:
                Many(6, Wall);
                break;
            case 5:
                Many(6, () => Board(_random.Next(2, 12), _random.Next(2, 9)));
                break;
            case 6:
                Many(300, Strokes);
                break;
            default:
                Many(30, () => Rectangle(Level(), Level()));
                Many(20, Frames);
                Many(100, Strokes);
                break;
        }

        if (_random.Next(2) == 0)
            Blur();
        AddNoise(_random.Next(0, 12));
        return _grey;
    }

    private static void Many(int count, Action draw)
    {
        for (int i = 0; i < count; i++)
            draw();
    }

    private byte Level() => (byte)_random.Next(256);

    // Smooth in the large, rough in the small: sums of noise over boxes of two sizes.
    private void Ground()
    {
        double offset = _random.Next(60, 180);
        int coarse = _random.Next(8, 40);
        int rough = _random.Next(5, 60);
        int level = 0;
        for (int row = 0; row < height; row++)
        {
            for (int column = 0; column < width; column++)
            {
                if (column % coarse == 0)
                    level = Hash(row / coarse, column / coarse) % 61;
                int value = (int)offset + level - 30 + _random.Next(-rough, rough + 1);
                _grey[(row * width) + column] = (byte)Math.Max(0, Math.Min(255, value));
            }
        }

        Blur();
    }

    private int Hash(int a, int b)
        => (int)(unchecked((((uint)a * 73856093) ^ ((uint)b * 19349663) ^ (uint)seed) * 2654435761) >> 8);

    // Turned by any angle, with an edge of another grey.
    private void Rectangle(byte inner, byte edge)
    {
        double side = 6 + (_random.NextDouble() * 60);
        double other = side * (0.6 + (0.8 * _random.NextDouble()));
        double border = _random.Next(4) * side / 12;
        Turned(side / 2, other / 2, (x, y) => Math.Max(Math.Abs(x) - (side / 2) + border,
            Math.Abs(y) - (other / 2) + border) > 0 ? edge : inner);
    }

    // A black square in a white one, as around a marker, and in it nothing, a patch, or a line.
    private void Frames()
    {
        double side = 10 + (_random.NextDouble() * 50);
        int what = _random.Next(4);
        byte white = (byte)_random.Next(150, 256);
        byte black = (byte)_random.Next(0, 90);
        double hole = side * (0.1 + (0.3 * _random.NextDouble()));
        Turned(side / 2 * 1.35, side / 2 * 1.35, (x, y) =>
        {
            double far = Math.Max(Math.Abs(x), Math.Abs(y));
            if (far > side / 2)
                return white;
            return what switch
            {
                0 => black,
                1 => far < hole ? white : black,
                2 => Math.Abs(x) < hole / 2 && Math.Abs(y) < side * 0.33 ? white : black,
                _ => ((int)(far / (side / 10)) & 1) == 0 ? black : white,
            };
        });
    }

    private void Wall()
    {
        double side = 60 + (_random.NextDouble() * 100);
        double pitch = 8 + (_random.NextDouble() * 20);
        double window = pitch * (0.4 + (0.4 * _random.NextDouble()));
        byte wall = (byte)_random.Next(120, 256);
        byte glass = (byte)_random.Next(0, 100);
        byte bar = (byte)_random.Next(0, 256);
        Turned(side / 2, side / 2, (x, y) =>
        {
            double u = x - (Math.Floor(x / pitch) * pitch);
            double v = y - (Math.Floor(y / pitch) * pitch);
            if (u > window || v > window)
                return wall;
            return Math.Abs(u - (window / 2)) < 1 || Math.Abs(v - (window / 2)) < 1 ? bar : glass;
        });
    }

    private void Board(int cells, int pixels)
    {
        double half = cells * pixels / 2.0;
        byte light = (byte)_random.Next(140, 256);
        byte dark = (byte)_random.Next(0, 100);
        Turned(half + pixels, half + pixels, (x, y) => Math.Max(Math.Abs(x), Math.Abs(y)) > half
            || ((((int)Math.Floor((x + half) / pixels)) + ((int)Math.Floor((y + half) / pixels))) & 1) == 0
                ? light : dark);
    }

    // Strokes in a small box.
    private void Strokes()
    {
        int left = _random.Next(width - 14);
        int top = _random.Next(height - 14);
        byte ink = (byte)_random.Next(0, 80);
        for (int stroke = 0; stroke < 4; stroke++)
        {
            bool isLevel = _random.Next(2) == 0;
            int at = _random.Next(12);
            int length = _random.Next(4, 13);
            for (int i = 0; i < length; i++)
            {
                int column = left + (isLevel ? i : at);
                int row = top + (isLevel ? at : i);
                _grey[(row * width) + column] = ink;
                _grey[(row * width) + column + 1] = ink;
            }
        }
    }

    private void Turned(double halfWidth, double halfHeight, Func<double, double, byte> grey)
    {
        double angle = _random.NextDouble() * Math.PI;
        (double cos, double sin) = (Math.Cos(angle), Math.Sin(angle));
        double centreX = _random.NextDouble() * width;
        double centreY = _random.NextDouble() * height;
        double reach = Math.Sqrt((halfWidth * halfWidth) + (halfHeight * halfHeight));
        for (int row = Math.Max(0, (int)(centreY - reach)); row < Math.Min(height, centreY + reach); row++)
        {
            for (int column = Math.Max(0, (int)(centreX - reach)); column < Math.Min(width, centreX + reach); column++)
            {
                double x = ((column - centreX) * cos) + ((row - centreY) * sin);
                double y = ((row - centreY) * cos) - ((column - centreX) * sin);
                if (Math.Abs(x) <= halfWidth && Math.Abs(y) <= halfHeight)
                    _grey[(row * width) + column] = grey(x, y);
            }
        }
    }

    // Mean of 3 x 3.
    private void Blur()
    {
        for (int i = 1; i < _grey.Length - 1; i++)
            _sums[i] = _grey[i - 1] + _grey[i] + _grey[i + 1];
        for (int i = width; i < _grey.Length - width; i++)
            _grey[i] = (byte)((_sums[i - width] + _sums[i] + _sums[i + width]) / 9);
    }

    private void AddNoise(int amplitude)
    {
        if (amplitude == 0)
            return;
        for (int i = 0; i < _grey.Length; i++)
            _grey[i] = (byte)Math.Max(0, Math.Min(255, _grey[i] + _random.Next(-amplitude, amplitude + 1)));
    }
}
