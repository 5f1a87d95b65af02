using System;
using System.Runtime.CompilerServices;

namespace Rabit.Uav.Simulation;

/// <summary>
/// What the ground looks like: grass, dry grass, bare soil and a farm track, from value noise of several octaves in a
/// tile that repeats itself, and finer grain from a smaller one. It lies still in the world. Immutable.
/// </summary>
internal sealed partial class GroundTexture
{
    /// <summary>After this distance the ground repeats itself, metres.</summary>
    public const double Period = Size / (double)CoarsePerMetre;

    /// <summary>All of the finest grain.</summary>
    public const int AllGrain = 256;

    private const int SizeBits = 9;
    private const int Size = 1 << SizeBits;
    private const int Mask = Size - 1;

    // The coarse tile has its first row and column at its end too, so that each place has its neighbours beside it.
    private const int CoarseStride = Size + 1;
    private const int CoarsePerMetre = 2;
    private const int FinePerMetre = 16;   // a whole number of fine tiles to a coarse one
    private const int CoarseShift = 3;     // by which FinePerMetre is more than CoarsePerMetre

    // A place in the tiles is a whole number of 1/256 fine steps. From a power of two above all of them, so that those
    // left of the origin are positive too.
    private const double IndexPerMetre = FinePerMetre * 256;
    private const double IndexOffset = 1 << 28;

    // A colour whose channels are 16 bits apart, so that one multiplication weighs all three: 0x0000_00RR_00GG_00BB.
    private const ulong Channels = 0x00FF_00FF_00FF;

    private readonly ulong[] _coarse = new ulong[CoarseStride * CoarseStride];

    // A place and its neighbours to the right, below, and both, from the lowest byte on; 128 is the mean.
    private readonly uint[] _fine = new uint[Size * Size];

    public GroundTexture(ulong seed)
    {
        var random = new SeededSequence(seed);
        FillCoarse(ref random);
        FillFine(ref random);
    }

    /// <summary>The colour of a place, 0x00RRGGBB. Allocates nothing.</summary>
    /// <param name="north">Metres, within some kilometres of 0.</param>
    /// <param name="east">Metres, likewise.</param>
    /// <param name="grain">
    /// How much of the finest grain a pixel still resolves, 0 to <see cref="AllGrain"/>.
    /// </param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]   // Mono inlines little by itself
    public uint ColourAt(double north, double east, int grain)
    {
        int n = (int)((north * IndexPerMetre) + IndexOffset);
        int e = (int)((east * IndexPerMetre) + IndexOffset);
        ulong colour = CoarseAt(n >> CoarseShift, e >> CoarseShift);
        if (grain == 0)
            return (uint)((colour >> 16) & 0xFF_0000) | (uint)((colour >> 8) & 0xFF00) | (uint)(colour & 0xFF);

        int light = 256 + ((FineAt(n, e) * grain) >> 8);
        return (Light((uint)(colour >> 32), light) << 16) | (Light((uint)(colour >> 16) & 0xFF, light) << 8)
            | Light((uint)colour & 0xFF, light);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static uint Light(uint channel, int light)
    {
        int value = ((int)channel * light) >> 8;
        return (uint)(value > 255 ? 255 : value);
    }

    // Between four neighbours, weights in 1/256.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private ulong CoarseAt(int n, int e)
    {
        ulong[] tile = _coarse;
        int at = (((n >> 8) & Mask) * CoarseStride) + ((e >> 8) & Mask);
        uint partE = (uint)(e & 0xFF);
        uint partN = (uint)(n & 0xFF);
        ulong upper = Blend(tile[at], tile[at + 1], partE);
        ulong lower = Blend(tile[at + CoarseStride], tile[at + CoarseStride + 1], partE);
        return Blend(upper, lower, partN);
    }

    // a * (256 - part) + b * part: a channel that is below zero on the way borrows from the next, and gives it back.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static ulong Blend(ulong a, ulong b, uint part)
        => unchecked(((a << 8) + ((b - a) * part)) >> 8) & Channels;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private int FineAt(int n, int e)
    {
        uint four = _fine[(((n >> 8) & Mask) << SizeBits) | ((e >> 8) & Mask)];
        int partE = e & 0xFF;
        int upper = Blend((int)(four & 0xFF), (int)((four >> 8) & 0xFF), partE);
        int lower = Blend((int)((four >> 16) & 0xFF), (int)(four >> 24), partE);
        return (Blend(upper, lower, n & 0xFF) >> 16) - 128;
    }

    // 256 times what is between.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int Blend(int a, int b, int part) => (a << 8) + ((b - a) * part);

    private void FillCoarse(ref SeededSequence random)
    {
        double[] dryness = ValueNoise.Fill(Size, firstCells: 8, octaves: 5, ref random);
        double[] soil = ValueNoise.Fill(Size, firstCells: 16, octaves: 5, ref random);
        double[] light = ValueNoise.Fill(Size, firstCells: 32, octaves: 4, ref random);
        var track = new FarmTrack(Period, ref random);
        for (int row = 0; row < Size; row++)
        {
            double line = track.LineAt(row / (double)CoarsePerMetre);
            for (int column = 0; column < Size; column++)
            {
                int at = (row << SizeBits) | column;
                double dry = Smooth(0.38, 0.68, dryness[at]);
                double bare = Smooth(0.60, 0.78, soil[at]);
                bare = Math.Max(bare, 0.85 * track.BareAt(line, column / (double)CoarsePerMetre));
                double gain = 0.72 + (0.56 * light[at]);
                _coarse[(row * CoarseStride) + column] = ((ulong)Mix(84, 128, 132, dry, bare, gain) << 32)
                    | ((ulong)Mix(104, 124, 114, dry, bare, gain) << 16)
                    | Mix(56, 78, 88, dry, bare, gain);
            }

            _coarse[(row * CoarseStride) + Size] = _coarse[row * CoarseStride];
        }

        Array.Copy(_coarse, 0, _coarse, Size * CoarseStride, CoarseStride);
    }

    private void FillFine(ref SeededSequence random)
    {
        double[] tufts = ValueNoise.Fill(Size, firstCells: 64, octaves: 4, ref random);
        byte[] grain = Array.ConvertAll(
            tufts, tuft => (byte)Math.Max(0, Math.Min(255, 128 + (int)Math.Floor((tuft - 0.5) * 330))));
        for (int at = 0; at < grain.Length; at++)
        {
            int right = (at & ~Mask) | ((at + 1) & Mask);
            _fine[at] = grain[at] | ((uint)grain[right] << 8) | ((uint)grain[Below(at)] << 16)
                | ((uint)grain[Below(right)] << 24);
        }
    }

    private static int Below(int at) => (at + Size) & ((Size * Size) - 1);

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
