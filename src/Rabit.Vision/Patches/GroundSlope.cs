using System;
using System.Numerics;

namespace Rabit.Vision;

/// <summary>
/// What ground that differs from side to side does to the centre of a patch. Beside sand a red panel seems to reach
/// into it, on the side of a dark bush its edge is lost: both pull the centre to the side of the sand. A plane through
/// the ground around the patch says how much of each pixel at the edge is ground that is only like the patch.
/// </summary>
internal sealed class GroundSlope(PatchMap map)
{
    // Up to that a plane is still one of the ground, and not of what lies on it.
    private const double MaxAlike = 0.7;

    // Pixels: ground that is textured gives a slope too. What is less is more likely that.
    private const double TextureShift = 0.1;

    private const int MinGround = 12;

    private readonly PatchMap _map = map;
    private double _level;
    private double _byColumn;
    private double _byRow;

    /// <summary>Moves the centre to where it is on ground that is the same all around.</summary>
    /// <param name="coverage">What part of each pixel is covered, in the cells of the map.</param>
    /// <param name="minCoverage">What is covered less does not count.</param>
    /// <param name="shape">What was measured as if the ground were the same.</param>
    public void Correct(float[] coverage, double minCoverage, ref PatchShape shape)
    {
        double column = shape.CentreX - _map.Left;
        double row = shape.CentreY - _map.Top;
        if (!TryFit(coverage, column, row))
            return;
        (double x, double y) = CentreOf(coverage, minCoverage, column, row);
        double square = (x * x) + (y * y);
        double known = square / (square + (TextureShift * TextureShift));
        shape.CentreX += known * x;
        shape.CentreY += known * y;
    }

    // A plane by least squares: how like the patch the ground is, by column and row from its centre.
    private bool TryFit(float[] coverage, double centreColumn, double centreRow)
    {
        (double n, double sumX, double sumY, double sum) = (0, 0, 0, 0);
        (double sumXX, double sumXY, double sumYY, double byX, double byY) = (0, 0, 0, 0, 0);
        for (int row = 0; row < _map.Rows; row++)
        {
            double y = row - centreRow;
            for (int word = 0; word < _map.Ground.Words; word++)
            {
                for (ulong bits = _map.Ground[row, word]; bits != 0; bits &= bits - 1)
                {
                    int column = (64 * word) + BitOperations.TrailingZeroCount(bits);
                    double alike = Clamp(coverage[(row * _map.Columns) + column], 1);
                    double x = column - centreColumn;
                    (n, sum, sumX, sumY) = (n + 1, sum + alike, sumX + x, sumY + y);
                    (sumXX, sumXY, sumYY) = (sumXX + (x * x), sumXY + (x * y), sumYY + (y * y));
                    (byX, byY) = (byX + (alike * x), byY + (alike * y));
                }
            }
        }

        if (n < MinGround)
            return false;
        (double meanX, double meanY, double mean) = (sumX / n, sumY / n, sum / n);
        (sumXX, sumXY, sumYY) =
            (sumXX - (sumX * meanX), sumXY - (sumX * meanY), sumYY - (sumY * meanY));
        (byX, byY) = (byX - (sumX * mean), byY - (sumY * mean));
        double determinant = (sumXX * sumYY) - (sumXY * sumXY);
        if (determinant < n)
            return false;
        _byColumn = ((byX * sumYY) - (byY * sumXY)) / determinant;
        _byRow = ((byY * sumXX) - (byX * sumXY)) / determinant;
        _level = mean - (_byColumn * meanX) - (_byRow * meanY);
        return true;
    }

    // From the centre as it was.
    private (double X, double Y) CentreOf(
        float[] coverage, double minCoverage, double centreColumn, double centreRow)
    {
        (double sum, double sumX, double sumY) = (0, 0, 0);
        for (int row = 0; row < _map.Rows; row++)
        {
            double y = row - centreRow;
            for (int word = 0; word < _map.Edge.Words; word++)
            {
                for (ulong bits = _map.Edge[row, word]; bits != 0; bits &= bits - 1)
                {
                    int column = (64 * word) + BitOperations.TrailingZeroCount(bits);
                    double x = column - centreColumn;
                    double alike = Clamp(_level + (_byColumn * x) + (_byRow * y), MaxAlike);
                    double part = coverage[(row * _map.Columns) + column];
                    part = part >= 1 ? 1 : (part - alike) / (1 - alike);
                    if (part < minCoverage)
                        continue;
                    (sum, sumX, sumY) = (sum + part, sumX + (part * x), sumY + (part * y));
                }
            }
        }

        return sum > 0 ? (sumX / sum, sumY / sum) : (0, 0);
    }

    private static double Clamp(double value, double max) => Math.Max(-1, Math.Min(max, value));
}
