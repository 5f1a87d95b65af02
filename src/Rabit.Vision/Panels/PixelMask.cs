using System;

namespace Rabit.Vision;

/// <summary>
/// A byte for each pixel, with a margin all around that is no pixel. Closing joins what is apart by little. Memory that
/// is used again; one thread.
/// </summary>
internal sealed class PixelMask
{
    private const int Margin = 8;   // of a word, so that words can be read one byte off

    private byte[] _other = [];

    /// <summary>The bytes; a pixel is at <see cref="At"/>.</summary>
    public byte[] Bytes { get; private set; } = [];

    /// <summary>From one row to the next.</summary>
    public int Stride { get; private set; }

    private int Height { get; set; }

    /// <summary>Sets the size; the margin is 0, and the pixels are whatever they are.</summary>
    public void Resize(int width, int height)
    {
        int stride = ((width + 7) / 8 * 8) + (2 * Margin);
        if (Bytes.Length < stride * (height + 2))
            (Bytes, _other) = (new byte[stride * (height + 2)], new byte[stride * (height + 2)]);
        else if (stride != Stride || height != Height)
            Array.Clear(Bytes, 0, Bytes.Length);
        (Stride, Width, Height) = (stride, width, height);
        SetMargins(Bytes, 0);
    }

    /// <summary>Columns.</summary>
    public int Width { get; private set; }

    /// <summary>Where a pixel is.</summary>
    public int At(int column, int row) => ((row + 1) * Stride) + Margin + column;

    /// <summary>Which pixel is there.</summary>
    public (int Column, int Row) PixelAt(int at) => ((at % Stride) - Margin, (at / Stride) - 1);

    /// <summary>Closing of ones by a square of 2 x reach + 1.</summary>
    public void Close(int reach)
    {
        for (int i = 0; i < reach; i++)
            Pass(isGrowing: true);
        for (int i = 0; i < reach; i++)
            Pass(isGrowing: false);
        SetMargins(Bytes, 0);
    }

    // What is beyond the border decides nothing.
    private void Pass(bool isGrowing)
    {
        SetMargins(Bytes, (byte)(isGrowing ? 0 : 1));
        Combine(Bytes, _other, 1, isGrowing);
        SetMargins(_other, (byte)(isGrowing ? 0 : 1));
        Combine(_other, Bytes, Stride, isGrowing);
    }

    // Each with its two neighbours, eight at a time; that many more are behind the last pixel.
    private unsafe void Combine(byte[] from, byte[] to, int step, bool isGrowing)
    {
        fixed (byte* source = from)
        fixed (byte* target = to)
        {
            for (int row = 0; row < Height; row++)
            {
                byte* s = source + At(0, row);
                byte* t = target + At(0, row);
                for (int i = 0; i < Width; i += 8)
                {
                    ulong before = *(ulong*)(s + i - step);
                    ulong own = *(ulong*)(s + i);
                    ulong after = *(ulong*)(s + i + step);
                    *(ulong*)(t + i) = isGrowing ? before | own | after : before & own & after;
                }
            }
        }
    }

    private void SetMargins(byte[] bytes, byte value)
    {
        Fill(bytes, 0, Stride, value);
        Fill(bytes, (Height + 1) * Stride, Stride, value);
        for (int row = 0; row < Height; row++)
        {
            Fill(bytes, (row + 1) * Stride, Margin, value);
            Fill(bytes, At(Width, row), Stride - Margin - Width, value);
        }
    }

    private static void Fill(byte[] bytes, int start, int count, byte value)
    {
        for (int i = start; i < start + count; i++)
            bytes[i] = value;
    }
}
