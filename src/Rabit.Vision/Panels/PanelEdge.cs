using System;

namespace Rabit.Vision;

/// <summary>
/// The centroid of a panel below the size of a pixel: those of its edge count by how much of them is covered, which is
/// how far they are from the ground to one of its colours, in linear light. One thread.
/// </summary>
internal sealed class PanelEdge
{
    // Fewer pixels in the middle of a colour say less of it than all of them.
    private const int FewCores = 4;

    private static readonly float[] Linear = LinearLight();

    private readonly ColourMean[] _parts = new ColourMean[3];
    private readonly ColourMean[] _cores = new ColourMean[3];
    private ColourMean _ground;
    private RingReach _reach = new();

    public void Begin(RingReach reach)
    {
        Array.Clear(_parts, 0, _parts.Length);
        Array.Clear(_cores, 0, _cores.Length);
        (_ground, _reach) = (default, reach);
    }

    public void AddPart(byte part, bool isCore, byte[] pixels, int at)
    {
        _parts[part].Add(pixels, at);
        if (isCore)
            _cores[part].Add(pixels, at);
    }

    public void AddGround(byte[] pixels, int at) => _ground.Add(pixels, at);

    /// <summary>Sets centre and area.</summary>
    public void FindCentre(
        ref PanelShape shape, byte[] pixels, int width, int height, int left, int top, int columns, int rows)
    {
        (double red, double green, double blue) = _ground.Value;
        Direction first = DirectionOf(1, red, green, blue);
        Direction second = DirectionOf(2, red, green, blue);
        (double sum, double x, double y) = (0, 0, 0);
        (double bright, double squares, int deep) = (0, 0, 0);
        for (int row = Math.Max(0, top); row < Math.Min(height, top + rows); row++)
        {
            for (int column = Math.Max(0, left); column < Math.Min(width, left + columns); column++)
            {
                byte reach = _reach.Of(((row - top) * columns) + column - left);
                if (reach < RingReach.Beside)
                    continue;
                double covered = 1;
                int at = ((row * width) + column) * 3;
                (double r, double g, double b) = (Linear[pixels[at]], Linear[pixels[at + 1]], Linear[pixels[at + 2]]);
                if (reach == RingReach.Deep)
                {
                    double level = (r + (2 * g) + b) / 4;
                    (bright, squares, deep) = (bright + level, squares + (level * level), deep + 1);
                }
                else
                {
                    (r, g, b) = (r - red, g - green, b - blue);
                    covered = Math.Max(0, Math.Min(1, Math.Max(first.Along(r, g, b), second.Along(r, g, b))));
                }

                (sum, x, y) = (sum + covered, x + (covered * column), y + (covered * row));
            }
        }

        shape.Area = sum;
        double ground = (red + (2 * green) + blue) / 4;
        double mean = deep == 0 ? ground : bright / deep;
        shape.BrightnessByGround = mean / Math.Max(ground, 1e-4);
        shape.Unevenness = deep == 0 ? 1
            : Math.Sqrt(Math.Max(0, (squares / deep) - (mean * mean))) / Math.Max(Math.Abs(mean - ground), 1e-4);
        (shape.CentreX, shape.CentreY) = sum > 0
            ? (x / sum, y / sum)
            : (shape.Left + ((shape.Width - 1) / 2.0), shape.Top + ((shape.Height - 1) / 2.0));
    }

    private Direction DirectionOf(int part, double red, double green, double blue)
    {
        ColourMean mean = _cores[part].Count >= FewCores ? _cores[part] : _parts[part];
        if (mean.Count == 0 || _ground.Count == 0)
            return default;
        (double r, double g, double b) = mean.Value;
        return new Direction(r - red, g - green, b - blue);
    }

    // IEC 61966-2-1.
    private static float[] LinearLight()
    {
        var light = new float[256];
        for (int i = 0; i < 256; i++)
        {
            double part = i / 255.0;
            light[i] = (float)(part <= 0.04045 ? part / 12.92 : Math.Pow((part + 0.055) / 1.055, 2.4));
        }

        return light;
    }

    private struct ColourMean
    {
        private double _red;
        private double _green;
        private double _blue;

        public int Count { get; private set; }

        public readonly (double Red, double Green, double Blue) Value
            => Count == 0 ? default : (_red / Count, _green / Count, _blue / Count);

        public void Add(byte[] pixels, int at)
        {
            _red += Linear[pixels[at]];
            _green += Linear[pixels[at + 1]];
            _blue += Linear[pixels[at + 2]];
            Count++;
        }
    }

    private readonly struct Direction(double red, double green, double blue)
    {
        private readonly double _squared = (red * red) + (green * green) + (blue * blue);

        public double Along(double r, double g, double b)
            => _squared > 0 ? ((red * r) + (green * g) + (blue * b)) / _squared : 0;
    }
}
