using System;
using System.Numerics;

namespace Rabit.Vision;

/// <summary>
/// What light and dark ground at different sides do to the centre of a patch. A lens mixes light, and levels are about
/// its square root: a pixel that is half covered seems more than that beside what is dark, as the crown of a tree that
/// hides a part, and less beside what is light. So the edge lies too far out on the dark side, by up to a pixel.
/// </summary>
internal sealed class GroundLight(PatchMap map)
{
    // Pixels by which the centre moves for what the ground is more like the patch, and darker against its contrast, on
    // one side: fitted to panels in drawn pictures that are hidden in part, with blur and JPEG.
    private const double ByLikeness = 1.9;
    private const double ByLight = 1.5;

    // Pixels: texture gives a direction too. What is less is most likely that.
    private const double TextureShift = 0.1;

    private const int MinGround = 12;

    private readonly PatchMap _map = map;

    /// <summary>Moves the centre back to where it is, and says how much the ground differs from side to side.</summary>
    /// <param name="pixels">Of the picture.</param>
    /// <param name="coverage">What part of each pixel is covered, in the cells of the map.</param>
    /// <param name="centreColumn">The centre, in columns of the picture, as it was measured first.</param>
    /// <param name="centreRow">The centre, in rows.</param>
    /// <param name="shape">What is corrected.</param>
    public void Correct(
        byte[] pixels, float[] coverage, double centreColumn, double centreRow, ref PatchShape shape)
    {
        (OneSide alike, OneSide red, OneSide green, OneSide blue) = (default, default, default, default);
        (double sumX, double sumY, int count) = (0, 0, 0);
        for (int row = 0; row < _map.Rows; row++)
        {
            double down = _map.Top + row - centreRow;
            for (int word = 0; word < _map.Ground.Words; word++)
            {
                for (ulong bits = _map.Ground[row, word]; bits != 0; bits &= bits - 1)
                {
                    int column = (64 * word) + BitOperations.TrailingZeroCount(bits);
                    double across = _map.Left + column - centreColumn;
                    double distance = Math.Sqrt((across * across) + (down * down) + 1e-9);
                    (double x, double y) = (across / distance, down / distance);
                    (sumX, sumY, count) = (sumX + x, sumY + y, count + 1);
                    int at = _map.PixelAt(column, row);
                    alike.Add(Math.Max(-1, Math.Min(1, coverage[(row * _map.Columns) + column])), x, y);
                    red.Add(pixels[at], x, y);
                    green.Add(pixels[at + 1], x, y);
                    blue.Add(pixels[at + 2], x, y);
                }
            }
        }

        if (count < MinGround)
            return;
        (double alikeX, double alikeY) = alike.Mean(sumX, sumY, count);
        (double redX, double redY) = red.Mean(sumX, sumY, count);
        (double greenX, double greenY) = green.Mean(sumX, sumY, count);
        (double blueX, double blueY) = blue.Mean(sumX, sumY, count);
        shape.GroundDifference = Math.Sqrt(
            (redX * redX) + (redY * redY) + (greenX * greenX) + (greenY * greenY) + (blueX * blueX) + (blueY * blueY))
            / shape.Contrast;
        double light = ByLight / shape.Contrast;
        double offX = (ByLikeness * alikeX) - (light * LightOf(redX, greenX, blueX));
        double offY = (ByLikeness * alikeY) - (light * LightOf(redY, greenY, blueY));
        double square = ((offX * offX) + (offY * offY)) / (TextureShift * TextureShift);
        double known = square * square / ((square * square) + 1);
        shape.CentreX -= known * offX;
        shape.CentreY -= known * offY;
    }

    // Brightness as ITU-R BT.601 has it.
    private static double LightOf(double red, double green, double blue)
        => (0.299 * red) + (0.587 * green) + (0.114 * blue);

    // How much more of something there is on one side than on the other.
    private struct OneSide
    {
        private double _sum;
        private double _x;
        private double _y;

        public void Add(double value, double x, double y)
            => (_sum, _x, _y) = (_sum + value, _x + (value * x), _y + (value * y));

        // Around a patch in full sight the directions cancel out; not where the border of the picture cuts it.
        public readonly (double X, double Y) Mean(double sumX, double sumY, int count)
            => ((_x - (_sum * sumX / count)) / count, (_y - (_sum * sumY / count)) / count);
    }
}
