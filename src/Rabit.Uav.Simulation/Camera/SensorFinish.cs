using System;
#if NET
using System.Runtime.Intrinsics.X86;
#endif

namespace Rabit.Uav.Simulation;

/// <summary>
/// What lens and sensor do to a picture at the end: darker corners, one side a little lighter than the other, and
/// noise. The noise comes out of a table, from another place of it in each row of each picture. Allocates nothing for
/// a picture.
/// </summary>
internal sealed partial class SensorFinish
{
    private const int TableSize = 1 << 16;
    private const double DarkerInCorners = 0.16;
    private const double LighterToTheRight = 0.02;

    private const ulong PurposeOfTable = 0x6E6F697365;
    private const ulong PurposeOfRows = 0x726F7773;

    private readonly ulong _seed;
    private readonly int _rowLength;      // bytes
    private readonly int _height;
    private readonly short[] _gains;      // 1/256, of each byte
    private readonly short[] _noise;      // 1/256 levels; goes on at its end as it begins, for the length of a row

#if NET
    /// <summary>Whether several bytes are made at a time, where the processor can; the bytes are the same.</summary>
    public bool UsesVectors { get; set; } = Avx2.IsSupported;
#endif

    public SensorFinish(int width, int height, double noiseSigma, ulong seed)
    {
        (_seed, _rowLength, _height) = (seed, 3 * width, height);
        _gains = new short[_rowLength * height];
        double corner2 = ((double)width * width) + ((double)height * height);
        for (int v = 0; v < height; v++)
        {
            for (int u = 0; u < width; u++)
            {
                (double x, double y) = ((2 * u) + 1 - width, (2 * v) + 1 - height);
                double gain = 1 - (DarkerInCorners * ((x * x) + (y * y)) / corner2) + (LighterToTheRight * x / width);
                short whole = (short)(256 * gain);
                int at = (v * _rowLength) + (3 * u);
                (_gains[at], _gains[at + 1], _gains[at + 2]) = (whole, whole, whole);
            }
        }

        _noise = new short[TableSize + _rowLength];
        var random = new SeededSequence(SeededSequence.Derive(seed, PurposeOfTable));
        for (int at = 0; at < TableSize; at++)
            _noise[at] = (short)Math.Floor((256 * noiseSigma * random.NextNormal()) + 0.5);
        for (int at = TableSize; at < _noise.Length; at++)
            _noise[at] = _noise[at - TableSize];
    }

    public void Apply(byte[] pixels, long number)
    {
        var rows = new SeededSequence(SeededSequence.Derive(_seed, PurposeOfRows, (ulong)number));
        for (int v = 0; v < _height; v++)
        {
            int from = v * _rowLength;
            int noise = rows.Next(TableSize);
            int done = 0;
#if NET
            if (UsesVectors)
                done = FinishSixteens(pixels, from, noise);
#endif
            FinishOnes(pixels, from + done, from + _rowLength, noise + done);
        }
    }

    private void FinishOnes(byte[] pixels, int from, int end, int noiseFrom)
    {
        short[] gains = _gains;
        short[] noises = _noise;
        int noise = noiseFrom;
        for (int at = from; at < end; at++)
        {
            int value = ((pixels[at] * gains[at]) + noises[noise++] + 128) >> 8;
            pixels[at] = value < 0 ? (byte)0 : value > 255 ? (byte)255 : (byte)value;
        }
    }
}
