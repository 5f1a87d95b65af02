#if NET
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.Arm;
using System.Runtime.Intrinsics.X86;

namespace Rabit.Vision;

/// <summary>Turns small matrices in vectors, for which the runtime has no name that fits every processor.</summary>
internal static class InterleavedVectors
{
    /// <summary>Whether this processor has what is needed: x86 with SSE2, or 64-bit ARM.</summary>
    public static bool IsSupported => Sse2.IsSupported || AdvSimd.Arm64.IsSupported;

    /// <summary>Writes four columns of four as the rows of a matrix that is 8 wide, from a column on.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void StoreTurned(
        Vector128<int> a, Vector128<int> b, Vector128<int> c, Vector128<int> d, ref int to, int column)
    {
        Vector128<long> ab = Low(a, b).AsInt64();
        Vector128<long> cd = Low(c, d).AsInt64();
        Vector128<long> abHigh = High(a, b).AsInt64();
        Vector128<long> cdHigh = High(c, d).AsInt64();
        Low(ab, cd).AsInt32().StoreUnsafe(ref to, (nuint)column);
        High(ab, cd).AsInt32().StoreUnsafe(ref to, (nuint)(column + 8));
        Low(abHigh, cdHigh).AsInt32().StoreUnsafe(ref to, (nuint)(column + 16));
        High(abHigh, cdHigh).AsInt32().StoreUnsafe(ref to, (nuint)(column + 24));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<int> Low(Vector128<int> a, Vector128<int> b)
        => Sse2.IsSupported ? Sse2.UnpackLow(a, b) : AdvSimd.Arm64.ZipLow(a, b);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<int> High(Vector128<int> a, Vector128<int> b)
        => Sse2.IsSupported ? Sse2.UnpackHigh(a, b) : AdvSimd.Arm64.ZipHigh(a, b);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<long> Low(Vector128<long> a, Vector128<long> b)
        => Sse2.IsSupported ? Sse2.UnpackLow(a, b) : AdvSimd.Arm64.ZipLow(a, b);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<long> High(Vector128<long> a, Vector128<long> b)
        => Sse2.IsSupported ? Sse2.UnpackHigh(a, b) : AdvSimd.Arm64.ZipHigh(a, b);
}
#endif
