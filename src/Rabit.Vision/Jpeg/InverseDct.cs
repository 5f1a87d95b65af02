using System;
#if NET
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
#endif

namespace Rabit.Vision;

/// <summary>
/// The inverse discrete cosine transform of a block of 8 x 8 (Loeffler, Ligtenberg and Moschytz, ICASSP 1989) with
/// 13 bits of fraction and 2 kept between the passes: the accurate integer method of libjpeg, to the bit.
/// </summary>
internal sealed class InverseDct
{
    private const int Bits = 13;
    private const int PassBits = 2;
    private const int FirstShift = Bits - PassBits;
    private const int SecondShift = Bits + PassBits + 3;

    private const int F0298 = 2446;
    private const int F0390 = 3196;
    private const int F0541 = 4433;
    private const int F0765 = 6270;
    private const int F0899 = 7373;
    private const int F1175 = 9633;
    private const int F1501 = 12299;
    private const int F1847 = 15137;
    private const int F1961 = 16069;
    private const int F2053 = 16819;
    private const int F2562 = 20995;
    private const int F3072 = 25172;

    private readonly int[] _between = new int[64];

    /// <summary>Writes a block that has nothing but its mean.</summary>
    public static void Fill(int mean, byte[] samples, int at, int stride)
    {
        byte value = Clamp(((mean << PassBits) + 16) >> (PassBits + 3));
        for (int row = 0; row < 8; row++)
            samples.AsSpan(at + (row * stride), 8).Fill(value);
    }

    /// <summary>Writes the samples of a block.</summary>
    /// <param name="block">Coefficients, row by row, times their steps.</param>
    /// <param name="samples">Takes the samples.</param>
    /// <param name="at">Where the first sample of the block is.</param>
    /// <param name="stride">Samples from one row to the next.</param>
    public void Transform(int[] block, byte[] samples, int at, int stride)
    {
#if NET
        if (InterleavedVectors.IsSupported)
        {
            TransformByVectors(block, samples, at, stride);
            return;
        }
#endif
        TransformByNumbers(block, samples, at, stride);
    }

    /// <summary>The same without vectors.</summary>
    internal void TransformByNumbers(int[] block, byte[] samples, int at, int stride)
    {
        int[] between = _between;
        for (int column = 0; column < 8; column++)
            Pass(block, column, 8, between, column, 8, FirstShift);
        for (int row = 0; row < 8; row++)
        {
            Pass(between, row * 8, 1, between, row * 8, 1, SecondShift);
            Span<byte> line = samples.AsSpan(at + (row * stride), 8);
            for (int column = 0; column < 8; column++)
                line[column] = Clamp(between[(row * 8) + column]);
        }
    }

    private static byte Clamp(int value)
    {
        value += 128;
        return value < 0 ? (byte)0 : value > 255 ? (byte)255 : (byte)value;
    }

    private static void Pass(int[] from, int at, int step, int[] to, int toAt, int toStep, int shift)
    {
        int z2 = from[at + (2 * step)];
        int z3 = from[at + (6 * step)];
        int z1 = (z2 + z3) * F0541;
        int t2 = z1 - (z3 * F1847);
        int t3 = z1 + (z2 * F0765);
        int t0 = (from[at] + from[at + (4 * step)]) << Bits;
        int t1 = (from[at] - from[at + (4 * step)]) << Bits;
        int round = 1 << (shift - 1);
        int e0 = t0 + t3 + round;
        int e3 = t0 - t3 + round;
        int e1 = t1 + t2 + round;
        int e2 = t1 - t2 + round;

        int o0 = from[at + (7 * step)];
        int o1 = from[at + (5 * step)];
        int o2 = from[at + (3 * step)];
        int o3 = from[at + step];
        z1 = (o0 + o3) * F0899;
        z2 = (o1 + o2) * F2562;
        int z5 = (o0 + o2 + o1 + o3) * F1175;
        z3 = z5 - ((o0 + o2) * F1961);
        int z4 = z5 - ((o1 + o3) * F0390);
        o0 = (o0 * F0298) - z1 + z3;
        o1 = (o1 * F2053) - z2 + z4;
        o2 = (o2 * F3072) - z2 + z3;
        o3 = (o3 * F1501) - z1 + z4;

        to[toAt] = (e0 + o3) >> shift;
        to[toAt + (7 * toStep)] = (e0 - o3) >> shift;
        to[toAt + toStep] = (e1 + o2) >> shift;
        to[toAt + (6 * toStep)] = (e1 - o2) >> shift;
        to[toAt + (2 * toStep)] = (e2 + o1) >> shift;
        to[toAt + (5 * toStep)] = (e2 - o1) >> shift;
        to[toAt + (3 * toStep)] = (e3 + o0) >> shift;
        to[toAt + (4 * toStep)] = (e3 - o0) >> shift;
    }

#if NET
    // Columns 0 to 3 and 4 to 7, then rows 0 to 3 and 4 to 7; each half is written turned, so that the next pass reads
    // whole vectors.
    private void TransformByVectors(int[] block, byte[] samples, int at, int stride)
    {
        ref int from = ref MemoryMarshal.GetArrayDataReference(block);
        ref int between = ref MemoryMarshal.GetArrayDataReference(_between);
        HalfPass(ref from, ref between, FirstShift);
        HalfPass(ref Unsafe.Add(ref from, 4), ref Unsafe.Add(ref between, 32), FirstShift);
        HalfPass(ref between, ref from, SecondShift);
        HalfPass(ref Unsafe.Add(ref between, 4), ref Unsafe.Add(ref from, 32), SecondShift);

        // What lies outside the array is not written: the last row ends inside, and so do those above.
        Span<byte> rows = samples.AsSpan(at, (7 * stride) + 8);
        ref byte to = ref MemoryMarshal.GetReference(rows);
        Vector128<byte> middle = Vector128.Create((byte)128);
        for (int row = 0; row < 8; row += 2)
        {
            Vector128<short> upper = Vector128.NarrowWithSaturation(
                Vector128.LoadUnsafe(ref from, (nuint)(row * 8)),
                Vector128.LoadUnsafe(ref from, (nuint)((row * 8) + 4)));
            Vector128<short> lower = Vector128.NarrowWithSaturation(
                Vector128.LoadUnsafe(ref from, (nuint)((row * 8) + 8)),
                Vector128.LoadUnsafe(ref from, (nuint)((row * 8) + 12)));
            Vector128<byte> both = Vector128.NarrowWithSaturation(upper, lower).AsByte() ^ middle;
            Unsafe.WriteUnaligned(ref Unsafe.Add(ref to, row * stride), both.AsUInt64().GetElement(0));
            Unsafe.WriteUnaligned(ref Unsafe.Add(ref to, (row + 1) * stride), both.AsUInt64().GetElement(1));
        }
    }

    private static void HalfPass(ref int from, ref int to, int shift)
    {
        Vector128<int> v2 = Vector128.LoadUnsafe(ref from, 16);
        Vector128<int> v6 = Vector128.LoadUnsafe(ref from, 48);
        Vector128<int> z1 = (v2 + v6) * F0541;
        Vector128<int> t2 = z1 - (v6 * F1847);
        Vector128<int> t3 = z1 + (v2 * F0765);
        Vector128<int> v0 = Vector128.LoadUnsafe(ref from, 0);
        Vector128<int> v4 = Vector128.LoadUnsafe(ref from, 32);
        Vector128<int> round = Vector128.Create(1 << (shift - 1));
        Vector128<int> t0 = ((v0 + v4) << Bits) + round;
        Vector128<int> t1 = ((v0 - v4) << Bits) + round;
        Vector128<int> e0 = t0 + t3;
        Vector128<int> e3 = t0 - t3;
        Vector128<int> e1 = t1 + t2;
        Vector128<int> e2 = t1 - t2;

        Vector128<int> o0 = Vector128.LoadUnsafe(ref from, 56);
        Vector128<int> o1 = Vector128.LoadUnsafe(ref from, 40);
        Vector128<int> o2 = Vector128.LoadUnsafe(ref from, 24);
        Vector128<int> o3 = Vector128.LoadUnsafe(ref from, 8);
        z1 = (o0 + o3) * F0899;
        Vector128<int> z2 = (o1 + o2) * F2562;
        Vector128<int> z5 = (o0 + o2 + o1 + o3) * F1175;
        Vector128<int> z3 = z5 - ((o0 + o2) * F1961);
        Vector128<int> z4 = z5 - ((o1 + o3) * F0390);
        o0 = (o0 * F0298) - z1 + z3;
        o1 = (o1 * F2053) - z2 + z4;
        o2 = (o2 * F3072) - z2 + z3;
        o3 = (o3 * F1501) - z1 + z4;

        InterleavedVectors.StoreTurned(
            (e0 + o3) >> shift, (e1 + o2) >> shift, (e2 + o1) >> shift, (e3 + o0) >> shift, ref to, 0);
        InterleavedVectors.StoreTurned(
            (e3 - o0) >> shift, (e2 - o1) >> shift, (e1 - o2) >> shift, (e0 - o3) >> shift, ref to, 4);
    }
#endif
}
