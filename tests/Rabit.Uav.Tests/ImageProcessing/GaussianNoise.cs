using System;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>
/// Normal numbers for the pixels of pictures, out of a table: a million of them for each picture take longer than what
/// is tested. Read in runs, each from a random place of the table. One thread.
/// </summary>
internal sealed class GaussianNoise(Random random)
{
    private const int TableSize = 1 << 16;
    private const int RunLength = 499;   // divides no row of a picture

    private static readonly double[] Table = CreateTable();

    private int _at;
    private int _end;

    /// <summary>The next one: mean 0, standard deviation 1.</summary>
    public double Next()
    {
        if (_at == _end)
        {
            _at = random.Next(TableSize - RunLength);
            _end = _at + RunLength;
        }

        return Table[_at++];
    }

    private static double[] CreateTable()
    {
        var numbers = new Random(1);
        double[] table = new double[TableSize];
        for (int i = 0; i < table.Length; i++)
            table[i] = GroundProjectorTests.Gauss(numbers);
        return table;
    }
}
