using System;

namespace Rabit.Uav.SensorFusion.Metrics;

/// <summary>The Cholesky decomposition of a small symmetric matrix, given by its upper triangle, row by row.</summary>
internal static class SmallCholesky
{
    /// <summary>Squared Mahalanobis distance; infinite for a matrix that is not positive definite.</summary>
    public static double MahalanobisSquared(ReadOnlySpan<double> error, ReadOnlySpan<double> upperTriangle)
    {
        int n = error.Length;
        Span<double> root = stackalloc double[n * n];
        Span<double> white = stackalloc double[n];
        if (!TryDecompose(upperTriangle, n, root))
            return double.PositiveInfinity;
        double sum = 0;
        for (int row = 0; row < n; row++)
        {
            double rest = error[row];
            for (int k = 0; k < row; k++)
                rest -= root[(row * n) + k] * white[k];
            white[row] = rest / root[(row * n) + row];
            sum += white[row] * white[row];
        }

        return sum;
    }

    // Lower triangle, row by row.
    private static bool TryDecompose(ReadOnlySpan<double> upperTriangle, int n, Span<double> root)
    {
        for (int row = 0; row < n; row++)
        {
            for (int column = 0; column <= row; column++)
            {
                double rest = upperTriangle[(column * n) - (column * (column - 1) / 2) + row - column];
                for (int k = 0; k < column; k++)
                    rest -= root[(row * n) + k] * root[(column * n) + k];
                if (column < row)
                    root[(row * n) + column] = rest / root[(column * n) + column];
                else if (rest > 0)
                    root[(row * n) + row] = Math.Sqrt(rest);
                else
                    return false;
            }
        }

        return true;
    }
}
