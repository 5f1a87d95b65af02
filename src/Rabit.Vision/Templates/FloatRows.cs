using System;
using System.Runtime.InteropServices;
#if NET
using System.Runtime.Intrinsics;
#endif

namespace Rabit.Vision;

/// <summary>
/// Loops over rows of numbers: in vectors where there are some, with the same results to the bit where there are none.
/// </summary>
internal static class FloatRows
{
    /// <summary>Adds a multiple of the second to the first; as many as the first has.</summary>
    public static void AddMultiple(Span<float> first, ReadOnlySpan<float> second, float factor)
    {
        second = second.Slice(0, first.Length);
        int i = 0;
#if NET
        if (Vector128.IsHardwareAccelerated)
        {
            ref float a = ref MemoryMarshal.GetReference(first);
            ref float b = ref MemoryMarshal.GetReference(second);
            Vector128<float> by = Vector128.Create(factor);
            // A product and a sum of their own, as without vectors: fused they would be rounded once.
            for (; i <= first.Length - Vector128<float>.Count; i += Vector128<float>.Count)
            {
                (Vector128.LoadUnsafe(ref a, (nuint)i) + (Vector128.LoadUnsafe(ref b, (nuint)i) * by))
                    .StoreUnsafe(ref a, (nuint)i);
            }
        }
#endif
        for (; i < first.Length; i++)
            first[i] += second[i] * factor;
    }

    /// <summary>Sum of the products, in four sums whatever the processor, so that all round alike.</summary>
    public static float Dot(ReadOnlySpan<float> first, ReadOnlySpan<float> second)
    {
        (float s0, float s1, float s2, float s3) = (0, 0, 0, 0);
        int i = 0;
#if NET
        if (Vector128.IsHardwareAccelerated)
        {
            ref float a = ref MemoryMarshal.GetReference(first);
            ref float b = ref MemoryMarshal.GetReference(second);
            Vector128<float> sums = Vector128<float>.Zero;
            for (; i <= first.Length - Vector128<float>.Count; i += Vector128<float>.Count)
                sums += Vector128.LoadUnsafe(ref a, (nuint)i) * Vector128.LoadUnsafe(ref b, (nuint)i);
            (s0, s1, s2, s3) = (sums[0], sums[1], sums[2], sums[3]);
        }
#endif
        for (; i <= first.Length - 4; i += 4)
        {
            s0 += first[i] * second[i];
            s1 += first[i + 1] * second[i + 1];
            s2 += first[i + 2] * second[i + 2];
            s3 += first[i + 3] * second[i + 3];
        }

        float rest = 0;
        for (; i < first.Length; i++)
            rest += first[i] * second[i];
        return s0 + s1 + s2 + s3 + rest;
    }
}
