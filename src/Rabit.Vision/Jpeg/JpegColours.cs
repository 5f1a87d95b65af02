using System;
#if NET
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
#endif

namespace Rabit.Vision;

/// <summary>
/// Makes red, green and blue of brightness and two colours (JFIF 1.02, page 3) with 16 bits of fraction, as libjpeg
/// does, to the bit.
/// </summary>
internal static class JpegColours
{
    private const int Half = 1 << 15;
    private const int RedOfCr = 91_881;       // 1.40200
    private const int GreenOfCb = 22_554;     // 0.34414
    private const int GreenOfCr = 46_802;     // 0.71414
    private const int BlueOfCb = 116_130;     // 1.77200

    /// <summary>Writes a row of pixels.</summary>
    public static void Convert(
        ReadOnlySpan<byte> y, ReadOnlySpan<byte> cb, ReadOnlySpan<byte> cr, Span<byte> pixels)
    {
        int column = 0;
#if NET
        if (Vector128.IsHardwareAccelerated && BitConverter.IsLittleEndian)
            column = ConvertByVectors(y, cb, cr, pixels);
#endif
        for (; column < y.Length; column++)
        {
            int brightness = y[column];
            int blue = cb[column] - 128;
            int red = cr[column] - 128;
            Span<byte> pixel = pixels.Slice(3 * column, 3);
            pixel[0] = Clamp(brightness + (((RedOfCr * red) + Half) >> 16));
            pixel[1] = Clamp(brightness + ((Half - (GreenOfCb * blue) - (GreenOfCr * red)) >> 16));
            pixel[2] = Clamp(brightness + (((BlueOfCb * blue) + Half) >> 16));
        }
    }

    /// <summary>Writes a row of pixels whose three parts are given.</summary>
    public static void Interleave(
        ReadOnlySpan<byte> red, ReadOnlySpan<byte> green, ReadOnlySpan<byte> blue, Span<byte> pixels)
    {
        for (int column = 0; column < red.Length; column++)
        {
            pixels[3 * column] = red[column];
            pixels[(3 * column) + 1] = green[column];
            pixels[(3 * column) + 2] = blue[column];
        }
    }

    private static byte Clamp(int value) => value < 0 ? (byte)0 : value > 255 ? (byte)255 : (byte)value;

#if NET
    // Sixteen pixels at a time; gives how many were written.
    private static int ConvertByVectors(
        ReadOnlySpan<byte> y, ReadOnlySpan<byte> cb, ReadOnlySpan<byte> cr, Span<byte> pixels)
    {
        ref byte brightness = ref MemoryMarshal.GetReference(y);
        ref byte blues = ref MemoryMarshal.GetReference(cb.Slice(0, y.Length));
        ref byte reds = ref MemoryMarshal.GetReference(cr.Slice(0, y.Length));
        ref byte to = ref MemoryMarshal.GetReference(pixels.Slice(0, 3 * y.Length));
        Vector128<byte> middle = Vector128.Create((byte)128);
        int column = 0;
        for (; column <= y.Length - 16; column += 16)
        {
            Vector128<byte> light = Vector128.LoadUnsafe(ref brightness, (nuint)column);
            Vector128<sbyte> u = (Vector128.LoadUnsafe(ref blues, (nuint)column) ^ middle).AsSByte();
            Vector128<sbyte> v = (Vector128.LoadUnsafe(ref reds, (nuint)column) ^ middle).AsSByte();
            Eight(Vector128.WidenLower(light), Vector128.WidenLower(u), Vector128.WidenLower(v),
                out Vector128<short> redLow, out Vector128<short> greenLow, out Vector128<short> blueLow);
            Eight(Vector128.WidenUpper(light), Vector128.WidenUpper(u), Vector128.WidenUpper(v),
                out Vector128<short> redHigh, out Vector128<short> greenHigh, out Vector128<short> blueHigh);
            Store(
                Bytes(redLow, redHigh), Bytes(greenLow, greenHigh), Bytes(blueLow, blueHigh), ref to,
                (nuint)(3 * column));
        }

        return column;
    }

    // All values are 128 less than they will be, so that the signed saturation clamps them.
    private static Vector128<byte> Bytes(Vector128<short> low, Vector128<short> high)
        => Vector128.NarrowWithSaturation(low, high).AsByte() ^ Vector128.Create((byte)128);

    private static void Eight(
        Vector128<ushort> light, Vector128<short> u, Vector128<short> v,
        out Vector128<short> red, out Vector128<short> green, out Vector128<short> blue)
    {
        Vector128<int> half = Vector128.Create(Half);
        Vector128<int> uLow = Vector128.WidenLower(u);
        Vector128<int> uHigh = Vector128.WidenUpper(u);
        Vector128<int> vLow = Vector128.WidenLower(v);
        Vector128<int> vHigh = Vector128.WidenUpper(v);
        Vector128<short> base128 = light.AsInt16() - Vector128.Create((short)128);
        red = base128 + Vector128.Narrow(((vLow * RedOfCr) + half) >> 16, ((vHigh * RedOfCr) + half) >> 16);
        green = base128 + Vector128.Narrow(
            (half - (uLow * GreenOfCb) - (vLow * GreenOfCr)) >> 16,
            (half - (uHigh * GreenOfCb) - (vHigh * GreenOfCr)) >> 16);
        blue = base128 + Vector128.Narrow(((uLow * BlueOfCb) + half) >> 16, ((uHigh * BlueOfCb) + half) >> 16);
    }

    // An index of 16 or more gives 0.
    private static void Store(Vector128<byte> red, Vector128<byte> green, Vector128<byte> blue, ref byte to, nuint at)
    {
        const byte N = 255;
        Vector128<byte> first =
            Vector128.Shuffle(red, Vector128.Create((byte)0, N, N, 1, N, N, 2, N, N, 3, N, N, 4, N, N, 5))
            | Vector128.Shuffle(green, Vector128.Create(N, (byte)0, N, N, 1, N, N, 2, N, N, 3, N, N, 4, N, N))
            | Vector128.Shuffle(blue, Vector128.Create(N, N, (byte)0, N, N, 1, N, N, 2, N, N, 3, N, N, 4, N));
        Vector128<byte> second =
            Vector128.Shuffle(red, Vector128.Create(N, N, (byte)6, N, N, 7, N, N, 8, N, N, 9, N, N, 10, N))
            | Vector128.Shuffle(green, Vector128.Create((byte)5, N, N, 6, N, N, 7, N, N, 8, N, N, 9, N, N, 10))
            | Vector128.Shuffle(blue, Vector128.Create(N, (byte)5, N, N, 6, N, N, 7, N, N, 8, N, N, 9, N, N));
        Vector128<byte> third =
            Vector128.Shuffle(red, Vector128.Create(N, (byte)11, N, N, 12, N, N, 13, N, N, 14, N, N, 15, N, N))
            | Vector128.Shuffle(green, Vector128.Create(N, N, (byte)11, N, N, 12, N, N, 13, N, N, 14, N, N, 15, N))
            | Vector128.Shuffle(blue, Vector128.Create((byte)10, N, N, 11, N, N, 12, N, N, 13, N, N, 14, N, N, 15));
        first.StoreUnsafe(ref to, at);
        second.StoreUnsafe(ref to, at + 16);
        third.StoreUnsafe(ref to, at + 32);
    }
#endif
}
