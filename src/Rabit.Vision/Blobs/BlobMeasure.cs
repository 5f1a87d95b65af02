using System;

namespace Rabit.Vision;

/// <summary>
/// Measures a blob below the size of a pixel: from the colour inside and that of the ground around it follows of each
/// pixel which part of it is covered; area, centre and second moments are sums over those parts.
/// </summary>
/// <example>
/// <code>
/// measure.SetPicture(picture.Pixels, picture.Width, picture.Height, table);
/// if (!measure.TouchesBorder(blob) &amp;&amp; measure.TryMeasure(blob, out BlobShape shape))
///     Console.WriteLine($"{shape.Area} pixels around {shape.CentreX}, {shape.CentreY}");
/// </code>
/// </example>
public sealed class BlobMeasure
{
    // Ground that is a little like the colour is no part of the blob.
    private const double MinCoverage = 0.15;

    // The box is measured with so much around it, where the edge fades out; the ground is sampled beyond.
    private const int Margin = 2;

    private byte[] _pixels = [];
    private byte[] _classes = [];
    private int _width;
    private int _height;

    /// <summary>Sets the picture whose blobs are measured from now on.</summary>
    /// <param name="pixels">Red, green, blue, row by row; read until the next picture is set.</param>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    /// <param name="colours">The classes that its blobs were found with.</param>
    /// <exception cref="ArgumentException">The buffer is too small for the size.</exception>
    public void SetPicture(byte[] pixels, int width, int height, ColourTable colours)
    {
        PixelBuffer.Check(pixels, width, height);
        _classes = (colours ?? throw new ArgumentNullException(nameof(colours))).Classes;
        (_pixels, _width, _height) = (pixels, width, height);
    }

    /// <summary>Whether the border of the picture may cut a part of it off.</summary>
    /// <param name="blob">Of the picture that is set.</param>
    public bool TouchesBorder(in Blob blob)
        => blob.Left < Margin || blob.Top < Margin || blob.Right >= _width - Margin || blob.Bottom >= _height - Margin;

    /// <summary>Measures it; false where it has no contrast to its surroundings.</summary>
    /// <param name="blob">Of the picture that is set.</param>
    /// <param name="shape">What was measured; only its colour if the answer is false.</param>
    public bool TryMeasure(in Blob blob, out BlobShape shape)
    {
        Colour inside = InsideOf(blob);
        Colour around = AroundOf(blob);
        shape = new BlobShape { Red = inside.Red, Green = inside.Green, Blue = inside.Blue };
        (double red, double green, double blue) =
            (inside.Red - around.Red, inside.Green - around.Green, inside.Blue - around.Blue);
        double contrast = (red * red) + (green * green) + (blue * blue);
        if (contrast < 1)
            return false;

        // Divided once instead of for every pixel.
        (red, green, blue) = (red / contrast, green / contrast, blue / contrast);
        double offset = (around.Red * red) + (around.Green * green) + (around.Blue * blue);
        (double sum, double sumX, double sumY, double sumXX, double sumXY, double sumYY) = (0, 0, 0, 0, 0, 0);
        for (int row = Math.Max(0, blob.Top - Margin); row <= Math.Min(_height - 1, blob.Bottom + Margin); row++)
        {
            for (int column = Math.Max(0, blob.Left - Margin);
                column <= Math.Min(_width - 1, blob.Right + Margin);
                column++)
            {
                int at = ((row * _width) + column) * 3;
                double part = Math.Min(
                    1, (_pixels[at] * red) + (_pixels[at + 1] * green) + (_pixels[at + 2] * blue) - offset);
                if (part < MinCoverage)
                    continue;
                (double x, double y) = (column - blob.Left, row - blob.Top);
                sum += part;
                sumX += part * x;
                sumY += part * y;
                sumXX += part * x * x;
                sumXY += part * x * y;
                sumYY += part * y * y;
            }
        }

        if (sum <= 0)
            return false;
        (double meanX, double meanY) = (sumX / sum, sumY / sum);
        shape.Area = sum;
        shape.CentreX = blob.Left + meanX;
        shape.CentreY = blob.Top + meanY;
        shape.MomentXX = (sumXX / sum) - (meanX * meanX);
        shape.MomentXY = (sumXY / sum) - (meanX * meanY);
        shape.MomentYY = (sumYY / sum) - (meanY * meanY);
        return true;
    }

    // The mean of what has its own colour on all four sides, which no ground shines into; of all, where it is too thin
    // for that.
    private Colour InsideOf(in Blob blob)
    {
        Colour inner = default;
        Colour all = default;
        for (int row = blob.Top; row <= blob.Bottom; row++)
        {
            for (int column = blob.Left; column <= blob.Right; column++)
            {
                if (ClassAt(column, row) != blob.Class)
                    continue;
                all.Add(_pixels, ((row * _width) + column) * 3);
                if (ClassAt(column - 1, row) == blob.Class && ClassAt(column + 1, row) == blob.Class
                    && ClassAt(column, row - 1) == blob.Class && ClassAt(column, row + 1) == blob.Class)
                    inner.Add(_pixels, ((row * _width) + column) * 3);
            }
        }

        return (inner.Count > 0 ? inner : all).Mean();
    }

    // A frame one pixel wide, beyond where the edge fades out.
    private Colour AroundOf(in Blob blob)
    {
        Colour around = default;
        int left = Math.Max(0, blob.Left - Margin - 1);
        int right = Math.Min(_width - 1, blob.Right + Margin + 1);
        int top = Math.Max(0, blob.Top - Margin - 1);
        int bottom = Math.Min(_height - 1, blob.Bottom + Margin + 1);
        for (int column = left; column <= right; column++)
        {
            AddGround(column, top, ref around);
            AddGround(column, bottom, ref around);
        }

        for (int row = top + 1; row < bottom; row++)
        {
            AddGround(left, row, ref around);
            AddGround(right, row, ref around);
        }

        return around.Mean();
    }

    private void AddGround(int column, int row, ref Colour around)
    {
        if (ClassAt(column, row) == 0)
            around.Add(_pixels, ((row * _width) + column) * 3);
    }

    private int ClassAt(int column, int row)
    {
        if (column < 0 || row < 0 || column >= _width || row >= _height)
            return 0;
        int at = ((row * _width) + column) * 3;
        return _classes[
            ((_pixels[at] >> ColourTable.Shift) << (2 * ColourTable.Bits))
            | ((_pixels[at + 1] >> ColourTable.Shift) << ColourTable.Bits)
            | (_pixels[at + 2] >> ColourTable.Shift)];
    }

    private struct Colour
    {
        public double Red;
        public double Green;
        public double Blue;
        public int Count;

        public void Add(byte[] pixels, int at)
        {
            Red += pixels[at];
            Green += pixels[at + 1];
            Blue += pixels[at + 2];
            Count++;
        }

        public readonly Colour Mean()
        {
            double count = Math.Max(1, Count);
            return new Colour { Red = Red / count, Green = Green / count, Blue = Blue / count, Count = 1 };
        }
    }
}
