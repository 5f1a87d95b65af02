using System;

namespace Rabit.Uav.Simulation;

/// <summary>
/// What lens and sensor do to a picture at the end: darker corners, one side a little lighter than the other, and
/// noise. The noise comes out of a table, from another place of it in each row of each picture. Allocates nothing for
/// a picture.
/// </summary>
internal sealed class SensorFinish
{
    private const int TableSize = 1 << 16;
    private const double DarkerInCorners = 0.16;
    private const double LighterToTheRight = 0.02;

    private const ulong PurposeOfTable = 0x6E6F697365;
    private const ulong PurposeOfRows = 0x726F7773;

    private readonly ulong _seed;
    private readonly int _width;
    private readonly int _height;
    private readonly ushort[] _gains;                    // 1/256
    private readonly short[] _noise = new short[TableSize];   // 1/256 levels

    public SensorFinish(int width, int height, double noiseSigma, ulong seed)
    {
        (_seed, _width, _height) = (seed, width, height);
        _gains = new ushort[width * height];
        double corner2 = ((double)width * width) + ((double)height * height);
        for (int v = 0; v < height; v++)
        {
            for (int u = 0; u < width; u++)
            {
                (double x, double y) = ((2 * u) + 1 - width, (2 * v) + 1 - height);
                double gain = 1 - (DarkerInCorners * ((x * x) + (y * y)) / corner2) + (LighterToTheRight * x / width);
                _gains[(v * width) + u] = (ushort)(256 * gain);
            }
        }

        var random = new SeededSequence(SeededSequence.Derive(seed, PurposeOfTable));
        for (int at = 0; at < TableSize; at++)
            _noise[at] = (short)Math.Floor((256 * noiseSigma * random.NextNormal()) + 0.5);
    }

    public void Apply(byte[] pixels, long number)
    {
        var rows = new SeededSequence(SeededSequence.Derive(_seed, PurposeOfRows, (ulong)number));
        int at = 0;
        for (int v = 0; v < _height; v++)
        {
            int noise = rows.Next(TableSize);
            for (int gainAt = v * _width, end = gainAt + _width; gainAt < end; gainAt++)
            {
                int gain = _gains[gainAt];
                pixels[at] = Finish(pixels[at], gain, _noise[noise & (TableSize - 1)]);
                pixels[at + 1] = Finish(pixels[at + 1], gain, _noise[(noise + 1) & (TableSize - 1)]);
                pixels[at + 2] = Finish(pixels[at + 2], gain, _noise[(noise + 2) & (TableSize - 1)]);
                noise += 3;
                at += 3;
            }
        }
    }

    private static byte Finish(byte level, int gain, int noise)
    {
        int value = ((level * gain) + noise + 128) >> 8;
        return value < 0 ? (byte)0 : value > 255 ? (byte)255 : (byte)value;
    }
}
