using System;

namespace Rabit.Vision;

/// <summary>Linear equations with few unknowns.</summary>
internal static class SmallSystem
{
    /// <summary>Solves by elimination with pivots, in place; false where they do not determine the unknowns.</summary>
    /// <param name="matrix">Row by row; is overwritten.</param>
    /// <param name="right">The right side; then the solution.</param>
    /// <param name="count">How many unknowns.</param>
    public static bool TrySolve(Span<double> matrix, Span<double> right, int count)
    {
        for (int column = 0; column < count; column++)
        {
            int pivot = column;
            for (int row = column + 1; row < count; row++)
            {
                if (Math.Abs(matrix[(row * count) + column]) > Math.Abs(matrix[(pivot * count) + column]))
                    pivot = row;
            }

            double diagonal = matrix[(pivot * count) + column];
            if (!(Math.Abs(diagonal) > 1e-300))
                return false;
            for (int i = 0; i < count && pivot != column; i++)
            {
                (matrix[(pivot * count) + i], matrix[(column * count) + i]) =
                    (matrix[(column * count) + i], matrix[(pivot * count) + i]);
            }

            (right[pivot], right[column]) = (right[column], right[pivot]);
            for (int row = column + 1; row < count; row++)
            {
                double factor = matrix[(row * count) + column] / diagonal;
                for (int i = column; i < count; i++)
                    matrix[(row * count) + i] -= factor * matrix[(column * count) + i];
                right[row] -= factor * right[column];
            }
        }

        for (int row = count - 1; row >= 0; row--)
        {
            for (int i = row + 1; i < count; i++)
                right[row] -= matrix[(row * count) + i] * right[i];
            right[row] /= matrix[(row * count) + row];
        }

        return true;
    }
}
