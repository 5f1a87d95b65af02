#if NET
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace Rabit.Uav.Simulation;

// Four places at a time, one in each 64 bits of a vector. Gives what ColourAt gives.
internal sealed partial class GroundTexture
{
    // A number of this size has its whole part in the lowest bits.
    private const double WholeInLowestBits = 1L << 52;

    /// <summary>
    /// The colours of four places: 12 bytes, red, green and blue of each. Allocates nothing. Needs AVX2.
    /// </summary>
    /// <inheritdoc cref="ColourAt"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector128<byte> ColoursAt(Vector256<double> north, Vector256<double> east, Vector256<double> grain)
    {
        Vector256<ulong> n = Whole((north * IndexPerMetre) + Vector256.Create(IndexOffset));
        Vector256<ulong> e = Whole((east * IndexPerMetre) + Vector256.Create(IndexOffset));
        Vector256<short> colours = CoarseAt(n >> CoarseShift, e >> CoarseShift);
        Vector256<int> whole = Whole(Vector256.Min(grain, Vector256.Create((double)AllGrain))).AsInt32();
        Vector256<int> light = (FineAt(n, e) * whole) >> 8;
        colours += (colours * InEachChannel(light.AsUInt64() & Vector256.Create(0xFFFFUL)).AsInt16()) >> 8;
        Vector128<byte> packed = Sse2.PackUnsignedSaturate(colours.GetLower(), colours.GetUpper());
        return Ssse3.Shuffle(
            packed, Vector128.Create((byte)2, 1, 0, 6, 5, 4, 10, 9, 8, 14, 13, 12, 255, 255, 255, 255));
    }

    // Not negative, and below 2^52.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<ulong> Whole(Vector256<double> value)
    {
        Vector256<double> added = Vector256.Create(WholeInLowestBits);
        return (Vector256.Floor(value) + added).AsUInt64() ^ added.AsUInt64();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Vector256<short> CoarseAt(Vector256<ulong> n, Vector256<ulong> e)
    {
        Vector256<ulong> mask = Vector256.Create((ulong)Mask);
        Vector256<ulong> row = (n >> 8) & mask;
        Vector256<ulong> at = (row << SizeBits) + row + ((e >> 8) & mask);   // CoarseStride is one more than Size
        Vector256<ushort> partE = InEachChannel(e & Vector256.Create(0xFFUL));
        Vector256<ushort> partN = InEachChannel(n & Vector256.Create(0xFFUL));

        ref ulong tile = ref MemoryMarshal.GetArrayDataReference(_coarse);
        (nuint a, nuint b) = ((nuint)at.GetElement(0), (nuint)at.GetElement(1));
        (nuint c, nuint d) = ((nuint)at.GetElement(2), (nuint)at.GetElement(3));
        Vector256<ushort> upper = Between(ref tile, a, b, c, d, partE);
        ref ulong nextRow = ref Unsafe.Add(ref tile, CoarseStride);
        Vector256<ushort> lower = Between(ref nextRow, a, b, c, d, partE);
        return Blend(upper, lower, partN).AsInt16();
    }

    // Between each place and the one to its right.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<ushort> Between(
        ref ulong tile, nuint a, nuint b, nuint c, nuint d, Vector256<ushort> partE)
    {
        Vector256<ulong> ac = Vector256.Create(
            Vector128.LoadUnsafe(ref tile, a), Vector128.LoadUnsafe(ref tile, c));
        Vector256<ulong> bd = Vector256.Create(
            Vector128.LoadUnsafe(ref tile, b), Vector128.LoadUnsafe(ref tile, d));
        return Blend(Avx2.UnpackLow(ac, bd).AsUInt16(), Avx2.UnpackHigh(ac, bd).AsUInt16(), partE);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<ushort> Blend(Vector256<ushort> a, Vector256<ushort> b, Vector256<ushort> part)
        => ((a * (Vector256.Create((ushort)256) - part)) + (b * part)) >> 8;

    // In the lower half of each 64 bits; the upper one is not of use.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Vector256<int> FineAt(Vector256<ulong> n, Vector256<ulong> e)
    {
        Vector256<ulong> mask = Vector256.Create((ulong)Mask);
        Vector256<ulong> at = (((n >> 8) & mask) << SizeBits) | ((e >> 8) & mask);
        ref uint tile = ref MemoryMarshal.GetArrayDataReference(_fine);
        Vector128<uint> four = Vector128.Create(
            Unsafe.Add(ref tile, (nuint)at.GetElement(0)), Unsafe.Add(ref tile, (nuint)at.GetElement(1)),
            Unsafe.Add(ref tile, (nuint)at.GetElement(2)), Unsafe.Add(ref tile, (nuint)at.GetElement(3)));

        // Weights of left and right, twice; then of above and below.
        Vector256<ulong> partE = e & Vector256.Create(0xFFUL);
        Vector256<ulong> weightsE = Vector256.Create(256UL) - partE + (partE << 16);
        Vector256<int> between = Avx2.MultiplyAddAdjacent(
            Avx2.ConvertToVector256Int16(four.AsByte()), (weightsE | (weightsE << 32)).AsInt16());
        Vector256<ulong> partN = n & Vector256.Create(0xFFUL);
        Vector256<int> weightsN = (Vector256.Create(256UL) - partN + (partN << 32)).AsInt32();
        Vector256<int> weighted = between * weightsN;
        Vector256<int> sum = weighted + (weighted.AsUInt64() >> 32).AsInt32();
        return (sum >> 16) - Vector256.Create(128);
    }

    // The lowest 16 bits of each 64 in all of them; the others are zero.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<ushort> InEachChannel(Vector256<ulong> value)
    {
        value |= value << 16;
        return (value | (value << 32)).AsUInt16();
    }
}
#endif
