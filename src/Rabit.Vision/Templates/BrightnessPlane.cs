using System;

namespace Rabit.Vision;

/// <summary>
/// A picture as the square roots of its brightness, so that edges in the shade count as those in the sun, made smaller
/// by a whole factor; and windows of it, turned and scaled. Memory that is used again; one thread.
/// </summary>
internal sealed class BrightnessPlane
{
    private float[] _values = [];

    public int Width { get; private set; }

    public int Height { get; private set; }

    /// <summary>How many pixels of the picture one of the plane has on a side.</summary>
    public int Factor { get; private set; }

    /// <summary>Takes a picture, or a part of it.</summary>
    /// <param name="pixels">Red, green and blue, row by row.</param>
    /// <param name="width">Columns of the picture.</param>
    /// <param name="height">Rows of the picture.</param>
    /// <param name="factor">Pixels that become one, on a side.</param>
    public void Set(ReadOnlySpan<byte> pixels, int width, int height, int factor)
    {
        (Width, Height, Factor) = (width / factor, height / factor, factor);
        if (_values.Length < Width * Height)
            _values = new float[Width * Height];
        float scale = 1f / (255 * 4 * factor * factor);
        for (int row = 0; row < Height; row++)
        {
            for (int column = 0; column < Width; column++)
            {
                int sum = 0;
                for (int y = row * factor; y < (row + 1) * factor; y++)
                {
                    int at = ((y * width) + (column * factor)) * 3;
                    for (int i = 0; i < factor; i++, at += 3)
                        sum += pixels[at] + (2 * pixels[at + 1]) + pixels[at + 2];
                }

                _values[(row * Width) + column] = (float)Math.Sqrt(sum * scale);
            }
        }
    }

    /// <summary>Samples a window between the pixels; beyond the border, the border goes on.</summary>
    /// <param name="window">Where it lies, in pixels of the picture.</param>
    /// <param name="width">Its columns.</param>
    /// <param name="height">Its rows.</param>
    /// <param name="to">Takes the values, row by row.</param>
    public void Sample(in PlaneWindow window, int width, int height, float[] to)
    {
        // From pixels of the picture to those of the plane, whose centres lie between them.
        double factor = 1.0 / Factor;
        double shift = ((0.5 * factor) - 0.5);
        float stepX = (float)(window.ColumnByColumn * factor);
        float stepY = (float)(window.RowByColumn * factor);
        for (int row = 0; row < height; row++)
        {
            float x = (float)(((window.Column + (window.ColumnByRow * row)) * factor) + shift);
            float y = (float)(((window.Row + (window.RowByRow * row)) * factor) + shift);
            int at = row * width;
            for (int column = 0; column < width; column++, at++)
                to[at] = At(x + (column * stepX), y + (column * stepY));
        }
    }

    private float At(float x, float y)
    {
        x = Math.Max(0, Math.Min(x, Width - 1.001f));
        y = Math.Max(0, Math.Min(y, Height - 1.001f));
        int column = (int)x;
        int row = (int)y;
        float right = x - column;
        float below = y - row;
        int at = (row * Width) + column;
        int next = Height > 1 ? Width : 0;
        int beside = Width > 1 ? 1 : 0;
        float top = _values[at] + (right * (_values[at + beside] - _values[at]));
        float bottom = _values[at + next] + (right * (_values[at + next + beside] - _values[at + next]));
        return top + (below * (bottom - top));
    }
}
