using System;

namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>
/// One estimate of two whose errors may have anything in common, such as the track of another vehicle that may be made
/// of our own reports: never surer than it may be, whatever they share (Julier, Uhlmann: "A Non-divergent Estimation
/// Algorithm in the Presence of Unknown Correlations", 1997). Matrices are square, row by row, up to 4 x 4.
/// </summary>
internal static class CovarianceIntersection
{
    private const int MaxSize = 4;

    /// <summary>Fuses two estimates with the weights that make the determinant of the covariance least.</summary>
    /// <param name="xa">One state.</param>
    /// <param name="pa">Its covariance.</param>
    /// <param name="xb">The other state.</param>
    /// <param name="pb">Its covariance.</param>
    /// <param name="x">The fused state.</param>
    /// <param name="p">Its covariance.</param>
    /// <param name="weightOfA">The weight of the first, 0 to 1.</param>
    /// <returns>False where a covariance is not positive definite; nothing is written then.</returns>
    public static bool TryFuse(
        ReadOnlySpan<double> xa,
        ReadOnlySpan<double> pa,
        ReadOnlySpan<double> xb,
        ReadOnlySpan<double> pb,
        Span<double> x,
        Span<double> p,
        out double weightOfA)
    {
        int n = xa.Length;
        Span<double> a = stackalloc double[MaxSize * MaxSize];
        Span<double> b = stackalloc double[MaxSize * MaxSize];
        weightOfA = 0;
        if (!TryInvert(pa, n, a) || !TryInvert(pb, n, b))
            return false;
        weightOfA = FindWeight(a, b, n);
        Span<double> fused = stackalloc double[MaxSize * MaxSize];
        Span<double> sum = stackalloc double[MaxSize * MaxSize];
        Combine(a, b, weightOfA, n, sum);
        if (!TryInvert(sum, n, fused))
            return false;

        Span<double> weighted = stackalloc double[MaxSize];
        for (int row = 0; row < n; row++)
        {
            weighted[row] = 0;
            for (int k = 0; k < n; k++)
                weighted[row] += (weightOfA * a[(row * n) + k] * xa[k]) + ((1 - weightOfA) * b[(row * n) + k] * xb[k]);
        }

        for (int row = 0; row < n; row++)
        {
            x[row] = 0;
            for (int k = 0; k < n; k++)
                x[row] += fused[(row * n) + k] * weighted[k];
        }

        fused.Slice(0, n * n).CopyTo(p);
        return true;
    }

    // The logarithm of the determinant of w A + (1 - w) B has its one maximum where its slope, which only falls, is 0.
    private static double FindWeight(Span<double> a, Span<double> b, int n)
    {
        (double first, double last) = (Slope(a, b, 0, n), Slope(a, b, 1, n));
        if (Math.Abs(first) + Math.Abs(last) < 1e-12)
            return 0.5; // Both are as sure in every direction.
        if (first <= 0)
            return 0;
        if (last >= 0)
            return 1;
        (double low, double high) = (0, 1);
        for (int i = 0; i < 50; i++)
        {
            double middle = (low + high) / 2;
            if (Slope(a, b, middle, n) > 0)
                low = middle;
            else
                high = middle;
        }

        return (low + high) / 2;
    }

    // Trace of (w A + (1 - w) B)^-1 (A - B).
    private static double Slope(Span<double> a, Span<double> b, double weight, int n)
    {
        Span<double> sum = stackalloc double[MaxSize * MaxSize];
        Span<double> inverse = stackalloc double[MaxSize * MaxSize];
        Combine(a, b, weight, n, sum);
        if (!TryInvert(sum, n, inverse))
            return 0;
        double trace = 0;
        for (int row = 0; row < n; row++)
        {
            for (int k = 0; k < n; k++)
                trace += inverse[(row * n) + k] * (a[(k * n) + row] - b[(k * n) + row]);
        }

        return trace;
    }

    private static void Combine(Span<double> a, Span<double> b, double weight, int n, Span<double> sum)
    {
        for (int i = 0; i < n * n; i++)
            sum[i] = (weight * a[i]) + ((1 - weight) * b[i]);
    }

    /// <summary>Inverts a matrix; false where it is not positive definite.</summary>
    // Gauss and Jordan without exchanges; each pivot of a positive definite matrix is above 0.
    internal static bool TryInvert(ReadOnlySpan<double> matrix, int n, Span<double> inverse)
    {
        matrix.Slice(0, n * n).CopyTo(inverse);
        for (int k = 0; k < n; k++)
        {
            double found = inverse[(k * n) + k];
            if (!(found > 0) || double.IsInfinity(found))
                return false;
            double pivot = 1 / found;
            inverse[(k * n) + k] = 1;
            for (int j = 0; j < n; j++)
                inverse[(k * n) + j] *= pivot;
            for (int i = 0; i < n; i++)
            {
                if (i == k)
                    continue;
                double factor = inverse[(i * n) + k];
                inverse[(i * n) + k] = 0;
                for (int j = 0; j < n; j++)
                    inverse[(i * n) + j] -= factor * inverse[(k * n) + j];
            }
        }

        return true;
    }
}
