namespace Rabit.Uav.Simulation;

/// <summary>
/// Value noise: random numbers on the corners of a grid, smoothly blended between them, each octave with half the
/// cells' size and half the weight of the one before. Square, and without a seam where its copies meet.
/// </summary>
internal static class ValueNoise
{
    /// <summary>Fills a square, row by row, with values from 0 to 1, 0.5 on average.</summary>
    /// <param name="size">Values per side, a power of two.</param>
    /// <param name="firstCells">Cells per side in the coarsest octave, a power of two.</param>
    /// <param name="octaves">How many octaves; the finest has at most <paramref name="size"/> cells per side.</param>
    /// <param name="random">Gives the numbers on the corners.</param>
    public static double[] Fill(int size, int firstCells, int octaves, ref SeededSequence random)
    {
        double[] values = new double[size * size];
        double all = 0;
        double weight = 1;
        for (int octave = 0, cells = firstCells; octave < octaves; octave++, cells *= 2, weight /= 2)
        {
            Add(values, size, cells, weight, ref random);
            all += weight;
        }

        for (int at = 0; at < values.Length; at++)
            values[at] /= all;
        return values;
    }

    private static void Add(double[] values, int size, int cells, double weight, ref SeededSequence random)
    {
        double[] corners = new double[cells * cells];
        for (int at = 0; at < corners.Length; at++)
            corners[at] = weight * random.NextUnit();

        int step = size / cells;
        double[] parts = new double[step];
        for (int at = 0; at < step; at++)
            parts[at] = Ease(at / (double)step);
        for (int row = 0; row < size; row++)
        {
            int upper = row / step * cells;
            int lower = ((row / step) + 1) % cells * cells;
            double partDown = parts[row % step];
            int at = row * size;
            for (int left = 0; left < cells; left++)
            {
                int right = left + 1 == cells ? 0 : left + 1;
                (double upperLeft, double lowerLeft) = (corners[upper + left], corners[lower + left]);
                double upperMore = corners[upper + right] - upperLeft;
                double lowerMore = corners[lower + right] - lowerLeft;
                foreach (double part in parts)
                {
                    double top = upperLeft + (upperMore * part);
                    double bottom = lowerLeft + (lowerMore * part);
                    values[at++] += top + ((bottom - top) * partDown);
                }
            }
        }
    }

    private static double Ease(double part) => part * part * (3 - (2 * part));
}
