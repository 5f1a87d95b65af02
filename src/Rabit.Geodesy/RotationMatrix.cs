using System;

namespace Rabit.Geodesy;

/// <summary>Reads rotation matrices, row by row.</summary>
internal static class RotationMatrix
{
    // A matrix typed in with four digits is good enough; a mirrored or transposed-in-part one is not.
    private const double Tolerance = 1e-3;

    /// <exception cref="ArgumentException">It is not the matrix of a rotation.</exception>
    public static void Demand(double[] m, string parameter)
    {
        if (m.Length != 9)
            throw new ArgumentException(
                $"A rotation matrix has 9 numbers, row by row; there are {m.Length}.", parameter);
        for (int i = 0; i < 3; i++)
        {
            for (int j = i; j < 3; j++)
            {
                double dot = (m[3 * i] * m[3 * j]) + (m[(3 * i) + 1] * m[(3 * j) + 1])
                    + (m[(3 * i) + 2] * m[(3 * j) + 2]);
                if (!(Math.Abs(dot - (i == j ? 1 : 0)) <= Tolerance))
                    throw new ArgumentException(
                        $"The rows {i + 1} and {j + 1} of a rotation matrix are not at right angles and of length 1.",
                        parameter);
            }
        }

        if (Determinant(m) < 0)
            throw new ArgumentException(
                "A rotation matrix with determinant -1 mirrors; two axes may be swapped.", parameter);
    }

    /// <summary>
    /// By the largest component, which keeps the digits (Shepperd, Journal of Guidance and Control 1(3), 1978).
    /// </summary>
    public static (double W, double X, double Y, double Z) ToQuaternion(double[] m)
    {
        double trace = m[0] + m[4] + m[8];
        if (trace >= m[0] && trace >= m[4] && trace >= m[8])
            return (1 + trace, m[7] - m[5], m[2] - m[6], m[3] - m[1]);
        if (m[0] >= m[4] && m[0] >= m[8])
            return (m[7] - m[5], 1 + m[0] - m[4] - m[8], m[1] + m[3], m[2] + m[6]);
        return m[4] >= m[8]
            ? (m[2] - m[6], m[1] + m[3], 1 - m[0] + m[4] - m[8], m[5] + m[7])
            : (m[3] - m[1], m[2] + m[6], m[5] + m[7], 1 - m[0] - m[4] + m[8]);
    }

    private static double Determinant(double[] m)
        => (m[0] * ((m[4] * m[8]) - (m[5] * m[7]))) - (m[1] * ((m[3] * m[8]) - (m[5] * m[6])))
            + (m[2] * ((m[3] * m[7]) - (m[4] * m[6])));
}
