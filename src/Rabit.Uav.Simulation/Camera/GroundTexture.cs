using System;

namespace Rabit.Uav.Simulation;

/// <summary>
/// What the ground looks like: grass, dry grass, bare soil and a farm track, from value noise of several octaves in a
/// tile that repeats itself, and finer grain from a smaller one. It lies still in the world. Immutable.
/// </summary>
internal sealed class GroundTexture
{
    /// <summary>After this distance the ground repeats itself, metres.</summary>
    public const double Period = Size / (double)CoarsePerMetre;

    private const int SizeBits = 9;
    private const int Size = 1 << SizeBits;
    private const int Mask = Size - 1;
    private const int CoarsePerMetre = 2;
    private const int FinePerMetre = 16;   // a whole number of fine tiles to a coarse one

    // A power of two above all indices, so that indices left of the origin are positive too.
    private const double IndexOffset = 1 << 28;

    // A colour whose channels are 16 bits apart, so that one multiplication weighs all three: 0x0000_00RR_00GG_00BB.
    private const ulong Channels = 0x00FF_00FF_00FF;

    private readonly ulong[] _coarse = new ulong[Size * Size];
    private readonly byte[] _fine = new byte[Size * Size];     // 128 is the mean

    public GroundTexture(ulong seed)
    {
        var random = new SeededSequence(seed);
        FillCoarse(ref random);
        FillFine(ref random);
    }

    /// <summary>The colour of a place, 0x00RRGGBB. Allocates nothing.</summary>
    /// <param name="north">Metres, within some kilometres of 0.</param>
    /// <param name="east">Metres, likewise.</param>
    /// <param name="grain">How much of the finest grain a pixel still resolves, 0 to 256.</param>
    public uint ColourAt(double north, double east, int grain)
    {
        int n = (int)((north * (CoarsePerMetre * 256)) + IndexOffset);
        int e = (int)((east * (CoarsePerMetre * 256)) + IndexOffset);
        ulong colour = CoarseAt(n, e);
        if (grain == 0)
            return (uint)((colour >> 16) & 0xFF_0000) | (uint)((colour >> 8) & 0xFF00) | (uint)(colour & 0xFF);

        n = (int)((north * (FinePerMetre * 256)) + IndexOffset);
        e = (int)((east * (FinePerMetre * 256)) + IndexOffset);
        int light = 256 + ((FineAt(n, e) * grain) >> 8);
        return (Light((uint)(colour >> 32), light) << 16) | (Light((uint)(colour >> 16) & 0xFF, light) << 8)
            | Light((uint)colour & 0xFF, light);
    }

    private static uint Light(uint channel, int light)
    {
        int value = ((int)channel * light) >> 8;
        return (uint)(value > 255 ? 255 : value);
    }

    // Between four neighbours, weights in 1/256.
    private ulong CoarseAt(int n, int e)
    {
        ulong[] tile = _coarse;
        int row = ((n >> 8) & Mask) << SizeBits;
        int nextRow = (((n >> 8) + 1) & Mask) << SizeBits;
        int column = (e >> 8) & Mask;
        int nextColumn = (column + 1) & Mask;
        uint partE = (uint)(e & 0xFF);
        uint partN = (uint)(n & 0xFF);
        ulong upper = Blend(tile[row | column], tile[row | nextColumn], partE);
        ulong lower = Blend(tile[nextRow | column], tile[nextRow | nextColumn], partE);
        return Blend(upper, lower, partN);
    }

    // a * (256 - part) + b * part: a channel that is below zero on the way borrows from the next, and gives it back.
    private static ulong Blend(ulong a, ulong b, uint part)
        => unchecked(((a << 8) + ((b - a) * part)) >> 8) & Channels;

    private int FineAt(int n, int e)
    {
        byte[] tile = _fine;
        int row = ((n >> 8) & Mask) << SizeBits;
        int nextRow = (((n >> 8) + 1) & Mask) << SizeBits;
        int column = (e >> 8) & Mask;
        int nextColumn = (column + 1) & Mask;
        int partE = e & 0xFF;
        int partN = n & 0xFF;
        int upper = Blend(tile[row | column], tile[row | nextColumn], partE);
        int lower = Blend(tile[nextRow | column], tile[nextRow | nextColumn], partE);
        return (Blend(upper, lower, partN) >> 16) - 128;
    }

    // 256 times what is between.
    private static int Blend(int a, int b, int part) => (a << 8) + ((b - a) * part);

    private void FillCoarse(ref SeededSequence random)
    {
        double[] dryness = ValueNoise.Fill(Size, firstCells: 8, octaves: 5, ref random);
        double[] soil = ValueNoise.Fill(Size, firstCells: 16, octaves: 5, ref random);
        double[] light = ValueNoise.Fill(Size, firstCells: 32, octaves: 4, ref random);
        var track = new FarmTrack(Period, ref random);
        for (int row = 0; row < Size; row++)
        {
            for (int column = 0; column < Size; column++)
            {
                int at = (row << SizeBits) | column;
                double dry = Smooth(0.38, 0.68, dryness[at]);
                double bare = Smooth(0.60, 0.78, soil[at]);
                bare = Math.Max(
                    bare, 0.85 * track.BareAt(row / (double)CoarsePerMetre, column / (double)CoarsePerMetre));
                double gain = 0.72 + (0.56 * light[at]);
                _coarse[at] = ((ulong)Mix(84, 128, 132, dry, bare, gain) << 32)
                    | ((ulong)Mix(104, 124, 114, dry, bare, gain) << 16)
                    | Mix(56, 78, 88, dry, bare, gain);
            }
        }
    }

    private void FillFine(ref SeededSequence random)
    {
        double[] tufts = ValueNoise.Fill(Size, firstCells: 64, octaves: 4, ref random);
        for (int at = 0; at < tufts.Length; at++)
            _fine[at] = (byte)Math.Max(0, Math.Min(255, 128 + (int)Math.Floor((tufts[at] - 0.5) * 330)));
    }

    private static uint Mix(double grass, double dryGrass, double soil, double dry, double bare, double gain)
    {
        double value = grass + ((dryGrass - grass) * dry);
        value += (soil - value) * bare;
        return (uint)((value * gain) + 0.5);
    }

    private static double Smooth(double from, double to, double value)
    {
        double part = Math.Max(0, Math.Min(1, (value - from) / (to - from)));
        return part * part * (3 - (2 * part));
    }
}
