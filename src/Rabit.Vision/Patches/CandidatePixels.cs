#if NET
using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace Rabit.Vision;

/// <summary>
/// Which pixels of a row may be of a colour, white or black: a look at 16 at a time that leaves out most of the ground,
/// by how much colour it has, and nothing that <see cref="PatchTable"/> or <see cref="NeutralLimits"/> would take.
/// </summary>
internal sealed class CandidatePixels
{
    private const byte N = 255;   // of an index: nothing
    private const byte StepMask = 0xFF << (8 - PatchTable.Bits) & 0xFF;
    private const int One = 1 << 15;   // of a factor

    private byte[] _whiteFrom = [];
    private byte[] _blackTo = [];
    private Vector128<byte> _ofGreen;
    private Vector128<byte> _ofOthers;
    private bool _hasGains;
    private ushort _redFactor;
    private ushort _blueFactor;

    /// <summary>The pixels of the row; only its first row is used.</summary>
    public BitGrid Bits { get; } = new();

    /// <summary>Those of them that may be white or black.</summary>
    public BitGrid Neutral { get; } = new();

    /// <summary>
    /// Prepares for a picture; false where its tint cannot be undone 16 pixels at a time as exactly as one by one.
    /// </summary>
    public bool TrySet(PictureLight light, PatchTable table, int width)
    {
        if (_whiteFrom.Length < width)
            (_whiteFrom, _blackTo) = (new byte[width], new byte[width]);
        _ofGreen = Vector128.Create(table.Chroma.WhereGreenIsStrongest);
        _ofOthers = Vector128.Create(table.Chroma.Elsewhere);
        _hasGains = light.RedGain != 1 || light.BlueGain != 1;
        return Vector128.IsHardwareAccelerated
            && TryFindFactor(light.RedGain, out _redFactor) && TryFindFactor(light.BlueGain, out _blueFactor);
    }

    /// <summary>Sets the limits of white and black of some columns.</summary>
    public void SetLimits(int from, int to, in NeutralLimits limits)
    {
        _whiteFrom.AsSpan(from, to - from).Fill((byte)Math.Min(255, limits.WeakWhite));
        _blackTo.AsSpan(from, to - from).Fill((byte)Math.Max(0, limits.WeakBlack));
    }

    /// <summary>Looks at a row; those that are left over at its end count as candidates.</summary>
    public void Look(ReadOnlySpan<byte> pixels, int width)
    {
        Bits.Clear(width, 1);
        Neutral.Clear(width, 1);
        ref byte from = ref MemoryMarshal.GetReference(pixels);
        int column = 0;
        while (column <= width - 16)
        {
            (ulong all, ulong allNeutral) = (0, 0);
            int word = column >> 6;
            for (int shift = 0; shift < 64 && column <= width - 16; shift += 16, column += 16)
            {
                all |= (ulong)LookAt16(ref from, column, out uint neutral) << shift;
                allNeutral |= (ulong)neutral << shift;
            }

            (Bits[0, word], Neutral[0, word]) = (all, allNeutral);
        }

        if (column == width)
            return;
        Bits.Set(0, column, width - 1);
        Neutral.Set(0, column, width - 1);
    }

    /// <summary>The factor, of 2 to the 15th, that gives the same steps as a gain for each level.</summary>
    internal static bool TryFindFactor(double gain, out ushort factor)
    {
        for (int off = 0; off <= 2; off++)
        {
            double near = Math.Floor(gain * One) + off;
            factor = (ushort)Math.Min(ushort.MaxValue, near);
            if (near <= ushort.MaxValue && IsSame(gain, factor))
                return true;
        }

        factor = 0;
        return false;
    }

    private static bool IsSame(double gain, ushort factor)
    {
        for (int level = 0; level < 256; level++)
        {
            int exact = Math.Min(255, (int)(level * gain));
            if ((exact & StepMask) != (Math.Min(255, (level * factor) >> 15) & StepMask))
                return false;
        }

        return true;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private uint LookAt16(ref byte from, int column, out uint neutral)
    {
        (Vector128<byte> red, Vector128<byte> green, Vector128<byte> blue) = Load(ref from, (nuint)(3 * column));
        Vector128<byte> most = Vector128.Max(red, Vector128.Max(green, blue));
        Vector128<byte> least = Vector128.Min(red, Vector128.Min(green, blue));
        Vector128<byte> isNeutral =
            Vector128.GreaterThanOrEqual(
                least, Vector128.LoadUnsafe(ref MemoryMarshal.GetArrayDataReference(_whiteFrom), (nuint)column))
            | Vector128.LessThanOrEqual(
                most, Vector128.LoadUnsafe(ref MemoryMarshal.GetArrayDataReference(_blackTo), (nuint)column));
        if (_hasGains)
        {
            red = Scale(red, _redFactor);
            blue = Scale(blue, _blueFactor);
            most = Vector128.Max(red, Vector128.Max(green, blue));
            least = Vector128.Min(red, Vector128.Min(green, blue));
        }

        neutral = isNeutral.ExtractMostSignificantBits();
        return neutral | HasColour(red, green, most, least).ExtractMostSignificantBits();
    }

    // In steps of the table.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Vector128<byte> HasColour(
        Vector128<byte> red, Vector128<byte> green, Vector128<byte> most, Vector128<byte> least)
    {
        var steps = Vector128.Create(StepMask);
        most &= steps;
        Vector128<byte> isGreen =
            Vector128.AndNot(Vector128.Equals(green & steps, most), Vector128.Equals(red & steps, most));
        Vector128<byte> limit = Vector128.ConditionalSelect(
            isGreen, Vector128.Shuffle(_ofGreen, most >>> 4), Vector128.Shuffle(_ofOthers, most >>> 4));
        return Vector128.GreaterThanOrEqual(most - (least & steps), limit);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static (Vector128<byte> Red, Vector128<byte> Green, Vector128<byte> Blue) Load(ref byte from, nuint at)
    {
        Vector128<byte> a = Vector128.LoadUnsafe(ref from, at);
        Vector128<byte> b = Vector128.LoadUnsafe(ref from, at + 16);
        Vector128<byte> c = Vector128.LoadUnsafe(ref from, at + 32);
        return (
            Vector128.Shuffle(a, Vector128.Create((byte)0, 3, 6, 9, 12, 15, N, N, N, N, N, N, N, N, N, N))
            | Vector128.Shuffle(b, Vector128.Create(N, N, N, N, N, N, 2, 5, 8, 11, 14, N, N, N, N, N))
            | Vector128.Shuffle(c, Vector128.Create(N, N, N, N, N, N, N, N, N, N, N, 1, 4, 7, 10, 13)),
            Vector128.Shuffle(a, Vector128.Create((byte)1, 4, 7, 10, 13, N, N, N, N, N, N, N, N, N, N, N))
            | Vector128.Shuffle(b, Vector128.Create(N, N, N, N, N, 0, 3, 6, 9, 12, 15, N, N, N, N, N))
            | Vector128.Shuffle(c, Vector128.Create(N, N, N, N, N, N, N, N, N, N, N, 2, 5, 8, 11, 14)),
            Vector128.Shuffle(a, Vector128.Create((byte)2, 5, 8, 11, 14, N, N, N, N, N, N, N, N, N, N, N))
            | Vector128.Shuffle(b, Vector128.Create(N, N, N, N, N, 1, 4, 7, 10, 13, N, N, N, N, N, N))
            | Vector128.Shuffle(c, Vector128.Create(N, N, N, N, N, N, N, N, N, N, 0, 3, 6, 9, 12, 15)));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<byte> Scale(Vector128<byte> levels, ushort factor)
    {
        (Vector128<ushort> low, Vector128<ushort> high) = Vector128.Widen(levels);
        Vector128<ushort> most = Vector128.Create((ushort)255);
        return Vector128.Narrow(
            Vector128.Min(HighProduct(low << 1, factor), most), Vector128.Min(HighProduct(high << 1, factor), most));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<ushort> HighProduct(Vector128<ushort> values, ushort factor)
    {
        if (Sse2.IsSupported)
            return Sse2.MultiplyHigh(values, Vector128.Create(factor));
        (Vector128<uint> low, Vector128<uint> high) = Vector128.Widen(values);
        return Vector128.Narrow((low * factor) >>> 16, (high * factor) >>> 16);
    }
}
#endif
