using System;
#if NET
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
#endif

namespace Rabit.Vision;

/// <summary>
/// Gives whole rows of a component that has fewer samples than the picture: between the samples by a triangle filter
/// where there is one for two, as libjpeg does ("fancy upsampling"), else the nearest one.
/// </summary>
internal sealed class JpegUpsampler
{
    private const int Slack = 64;

    private byte[] _row = [];
    private ushort[] _sums = [];   // one more on each side than there are samples
    private JpegComponent _component = new();
    private int _horizontal;
    private int _vertical;

    /// <summary>The row that <see cref="Select"/> chose is in this array.</summary>
    public byte[] Row { get; private set; } = [];

    /// <summary>Where the row begins.</summary>
    public int RowAt { get; private set; }

    public void Arrange(JpegHeader header, JpegComponent component)
    {
        _component = component;
        _horizontal = header.MaxHorizontal / component.Horizontal;
        _vertical = header.MaxVertical / component.Vertical;
        int needed = (component.Width * _horizontal) + Slack;
        if (_horizontal * _vertical > 1 && _row.Length < needed)
            _row = new byte[needed];
        if (_horizontal == 2 && _sums.Length < component.Width + Slack)
            _sums = new ushort[component.Width + Slack];
    }

    /// <summary>Makes a row of the picture.</summary>
    public void Select(int row)
    {
        int near = row / _vertical;
        int nearAt = near * _component.Stride;
        (Row, RowAt) = (_row, 0);
        bool isWide = _component.Width > 2;
        if (_horizontal == 1 && _vertical == 1)
            (Row, RowAt) = (_component.Samples, nearAt);
        else if (_horizontal == 1 && _vertical == 2)
            Blend(nearAt, FarAt(row, near), (row & 1) + 1);
        else if (_horizontal == 2 && _vertical == 1 && isWide)
            SpreadOne(nearAt);
        else if (_horizontal == 2 && _vertical == 2 && isWide)
            SpreadTwo(nearAt, FarAt(row, near));
        else
            Repeat(nearAt);
    }

    // The other row that is nearest: the one above for an even row, below for an odd one.
    private int FarAt(int row, int near)
    {
        int far = (row & 1) == 0 ? Math.Max(near - 1, 0) : Math.Min(near + 1, _component.Height - 1);
        return far * _component.Stride;
    }

    private void Repeat(int at)
    {
        ReadOnlySpan<byte> from = _component.Samples.AsSpan(at, _component.Width);
        for (int column = 0; column < from.Length; column++)
            _row.AsSpan(column * _horizontal, _horizontal).Fill(from[column]);
    }

    private void Blend(int near, int far, int bias)
    {
        byte[] from = _component.Samples;
        int column = 0;
#if NET
        if (Vector128.IsHardwareAccelerated)
        {
            ref byte first = ref MemoryMarshal.GetArrayDataReference(from);
            Vector128<ushort> round = Vector128.Create((ushort)bias);
            for (; column <= _component.Width - 16; column += 16)
            {
                Vector128<byte> a = Vector128.LoadUnsafe(ref first, (nuint)(near + column));
                Vector128<byte> b = Vector128.LoadUnsafe(ref first, (nuint)(far + column));
                Vector128<ushort> low = (Sum(Vector128.WidenLower(a), Vector128.WidenLower(b)) + round) >>> 2;
                Vector128<ushort> high = (Sum(Vector128.WidenUpper(a), Vector128.WidenUpper(b)) + round) >>> 2;
                Vector128.Narrow(low, high).CopyTo(_row, column);
            }
        }
#endif
        for (; column < _component.Width; column++)
            _row[column] = (byte)(((3 * from[near + column]) + from[far + column] + bias) >> 2);
    }

    private void SpreadOne(int at)
    {
        byte[] from = _component.Samples;
        int column = 0;
#if NET
        if (Vector128.IsHardwareAccelerated)
        {
            ref byte first = ref MemoryMarshal.GetArrayDataReference(from);
            for (; column <= _component.Width - 16; column += 16)
            {
                Vector128<byte> a = Vector128.LoadUnsafe(ref first, (nuint)(at + column));
                Vector128.WidenLower(a).CopyTo(_sums, column + 1);
                Vector128.WidenUpper(a).CopyTo(_sums, column + 9);
            }
        }
#endif
        for (; column < _component.Width; column++)
            _sums[column + 1] = from[at + column];
        Spread(1, 2, 2);
    }

    private void SpreadTwo(int near, int far)
    {
        byte[] from = _component.Samples;
        int column = 0;
#if NET
        if (Vector128.IsHardwareAccelerated)
        {
            ref byte first = ref MemoryMarshal.GetArrayDataReference(from);
            for (; column <= _component.Width - 16; column += 16)
            {
                Vector128<byte> a = Vector128.LoadUnsafe(ref first, (nuint)(near + column));
                Vector128<byte> b = Vector128.LoadUnsafe(ref first, (nuint)(far + column));
                Sum(Vector128.WidenLower(a), Vector128.WidenLower(b)).CopyTo(_sums, column + 1);
                Sum(Vector128.WidenUpper(a), Vector128.WidenUpper(b)).CopyTo(_sums, column + 9);
            }
        }
#endif
        for (; column < _component.Width; column++)
            _sums[column + 1] = (ushort)((3 * from[near + column]) + from[far + column]);
        Spread(8, 7, 4);
    }

    // Two samples of each, three quarters of it and one quarter of its neighbour. With the outermost ones put twice the
    // ends come out as they are.
    private void Spread(int leftBias, int rightBias, int shift)
    {
        int count = _component.Width;
        ushort[] sums = _sums;
        sums[0] = sums[1];
        sums[count + 1] = sums[count];
        int column = 0;
#if NET
        if (Vector128.IsHardwareAccelerated && BitConverter.IsLittleEndian)
        {
            ref ushort first = ref MemoryMarshal.GetArrayDataReference(sums);
            Vector128<ushort> left = Vector128.Create((ushort)leftBias);
            Vector128<ushort> right = Vector128.Create((ushort)rightBias);
            for (; column <= count - 8; column += 8)
            {
                Vector128<ushort> here = Vector128.LoadUnsafe(ref first, (nuint)(column + 1));
                here = here + here + here;
                Vector128<ushort> a = (here + Vector128.LoadUnsafe(ref first, (nuint)column) + left) >>> shift;
                Vector128<ushort> b = (here + Vector128.LoadUnsafe(ref first, (nuint)(column + 2)) + right) >>> shift;
                (a | (b << 8)).AsByte().CopyTo(_row, 2 * column);
            }
        }
#endif
        for (; column < count; column++)
        {
            int here = 3 * sums[column + 1];
            _row[2 * column] = (byte)((here + sums[column] + leftBias) >> shift);
            _row[(2 * column) + 1] = (byte)((here + sums[column + 2] + rightBias) >> shift);
        }
    }

#if NET
    private static Vector128<ushort> Sum(Vector128<ushort> near, Vector128<ushort> far) => near + near + near + far;
#endif
}
