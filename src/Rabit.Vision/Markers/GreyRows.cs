using System;
using System.Runtime.InteropServices;
#if NET
using System.Runtime.Intrinsics;
#endif

namespace Rabit.Vision;

/// <summary>
/// Loops over rows of grey pixels: in vectors where there are some, and with the same results where there are none.
/// </summary>
internal static class GreyRows
{
    /// <summary>The smaller of two in place of the first.</summary>
    public static void Min(Span<byte> first, ReadOnlySpan<byte> second)
    {
        int i = 0;
#if NET
        if (Vector128.IsHardwareAccelerated)
        {
            ref byte a = ref MemoryMarshal.GetReference(first);
            ref byte b = ref MemoryMarshal.GetReference(second);
            for (; i <= second.Length - Vector128<byte>.Count; i += Vector128<byte>.Count)
            {
                Vector128.Min(Vector128.LoadUnsafe(ref a, (nuint)i), Vector128.LoadUnsafe(ref b, (nuint)i))
                    .StoreUnsafe(ref a, (nuint)i);
            }
        }
#endif
        for (; i < second.Length; i++)
            first[i] = Math.Min(first[i], second[i]);
    }

    /// <summary>The larger of two in place of the first.</summary>
    public static void Max(Span<byte> first, ReadOnlySpan<byte> second)
    {
        int i = 0;
#if NET
        if (Vector128.IsHardwareAccelerated)
        {
            ref byte a = ref MemoryMarshal.GetReference(first);
            ref byte b = ref MemoryMarshal.GetReference(second);
            for (; i <= second.Length - Vector128<byte>.Count; i += Vector128<byte>.Count)
            {
                Vector128.Max(Vector128.LoadUnsafe(ref a, (nuint)i), Vector128.LoadUnsafe(ref b, (nuint)i))
                    .StoreUnsafe(ref a, (nuint)i);
            }
        }
#endif
        for (; i < second.Length; i++)
            first[i] = Math.Max(first[i], second[i]);
    }

    /// <summary>Of each four columns the smallest and the largest.</summary>
    public static void ReduceTiles(
        ReadOnlySpan<byte> columnMin, ReadOnlySpan<byte> columnMax, Span<byte> min, Span<byte> max)
    {
        int i = 0;
#if NET
        if (Vector128.IsHardwareAccelerated && BitConverter.IsLittleEndian)
        {
            ReadOnlySpan<uint> low = MemoryMarshal.Cast<byte, uint>(columnMin);
            ReadOnlySpan<uint> high = MemoryMarshal.Cast<byte, uint>(columnMax);
            ref uint a = ref MemoryMarshal.GetReference(low);
            ref uint b = ref MemoryMarshal.GetReference(high);
            for (; i <= min.Length - 4; i += 4)
            {
                Vector128<uint> p = Vector128.LoadUnsafe(ref a, (nuint)i);
                p = Vector128.Min(p.AsByte(), (p >> 8).AsByte()).AsUInt32();
                p = Vector128.Min(p.AsByte(), (p >> 16).AsByte()).AsUInt32();
                Vector128<uint> q = Vector128.LoadUnsafe(ref b, (nuint)i);
                q = Vector128.Max(q.AsByte(), (q >> 8).AsByte()).AsUInt32();
                q = Vector128.Max(q.AsByte(), (q >> 16).AsByte()).AsUInt32();
                for (int k = 0; k < 4; k++)
                    (min[i + k], max[i + k]) = ((byte)p[k], (byte)q[k]);
            }
        }
#endif
        for (; i < min.Length; i++)
        {
            int at = i * 4;
            min[i] = Math.Min(
                Math.Min(columnMin[at], columnMin[at + 1]), Math.Min(columnMin[at + 2], columnMin[at + 3]));
            max[i] = Math.Max(
                Math.Max(columnMax[at], columnMax[at + 1]), Math.Max(columnMax[at + 2], columnMax[at + 3]));
        }
    }

    /// <summary>
    /// A level between the smallest and the largest of each three neighbours; 0 where they are nearer than the
    /// contrast.
    /// </summary>
    /// <param name="min">One longer than the levels at both ends.</param>
    /// <param name="max">One longer than the levels at both ends.</param>
    /// <param name="levels">Takes the levels.</param>
    /// <param name="minContrast">Grey levels.</param>
    /// <param name="share">Of the way from the smallest to the largest, in 256ths.</param>
    public static void Levels(
        ReadOnlySpan<byte> min, ReadOnlySpan<byte> max, Span<byte> levels, int minContrast, int share)
    {
        int i = 0;
#if NET
        if (Vector128.IsHardwareAccelerated)
            i = VectorLevels(min, max, levels, minContrast, share);
#endif
        for (; i < levels.Length; i++)
        {
            int low = Math.Min(Math.Min(min[i], min[i + 1]), min[i + 2]);
            int high = Math.Max(Math.Max(max[i], max[i + 1]), max[i + 2]);
            levels[i] = (byte)(high - low < minContrast ? 0 : low + (((high - low) * share) >> 8));
        }
    }

#if NET
    private static int VectorLevels(
        ReadOnlySpan<byte> min, ReadOnlySpan<byte> max, Span<byte> levels, int minContrast, int share)
    {
        ref byte a = ref MemoryMarshal.GetReference(min);
        ref byte b = ref MemoryMarshal.GetReference(max);
        ref byte to = ref MemoryMarshal.GetReference(levels);
        Vector128<byte> contrast = Vector128.Create((byte)minContrast);
        Vector128<ushort> factor = Vector128.Create((ushort)share);
        int i = 0;
        for (; i <= levels.Length - Vector128<byte>.Count; i += Vector128<byte>.Count)
        {
            Vector128<byte> low = Vector128.Min(
                Vector128.Min(Vector128.LoadUnsafe(ref a, (nuint)i), Vector128.LoadUnsafe(ref a, (nuint)(i + 1))),
                Vector128.LoadUnsafe(ref a, (nuint)(i + 2)));
            Vector128<byte> high = Vector128.Max(
                Vector128.Max(Vector128.LoadUnsafe(ref b, (nuint)i), Vector128.LoadUnsafe(ref b, (nuint)(i + 1))),
                Vector128.LoadUnsafe(ref b, (nuint)(i + 2)));
            Vector128<byte> range = high - low;
            (Vector128<ushort> lower, Vector128<ushort> upper) = Vector128.Widen(range);
            Vector128<byte> part = Vector128.Narrow((lower * factor) >> 8, (upper * factor) >> 8);
            ((low + part) & Vector128.GreaterThanOrEqual(range, contrast)).StoreUnsafe(ref to, (nuint)i);
        }

        return i;
    }
#endif
}
