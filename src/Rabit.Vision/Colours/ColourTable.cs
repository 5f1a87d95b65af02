using System;

namespace Rabit.Vision;

/// <summary>
/// Classifies every colour of a picture, in steps of 8 for each channel, by the <see cref="ColourRange"/> that it falls
/// into: a look-up table of 32 KB, which stays in the cache. For one thread at a time.
/// </summary>
/// <example>
/// <code>
/// var table = new ColourTable([new ColourRange(205, 28, 32), new ColourRange(28, 72, 205)]);
/// table.Select(0b10);                               // the second alone
/// int ofBlue = table.ClassOf(28, 72, 205);          // 2: one more than its index
/// int ofRed = table.ClassOf(205, 28, 32);           // 0: not selected
/// </code>
/// </example>
public sealed class ColourTable
{
    /// <summary>Low bits of a channel that do not count.</summary>
    public const int Shift = 3;

    /// <summary>Bits of a channel that count.</summary>
    public const int Bits = 8 - Shift;

    private readonly ColourRange[] _ranges;
    private uint _selected;

    /// <summary>Makes a table that selects none of the ranges.</summary>
    /// <param name="ranges">At most 32. Copied.</param>
    /// <exception cref="ArgumentException">There are more.</exception>
    public ColourTable(ReadOnlySpan<ColourRange> ranges)
    {
        if (ranges.Length > 32)
            throw new ArgumentException(
                $"There are {ranges.Length} colour ranges; at most 32 are possible.", nameof(ranges));
        _ranges = ranges.ToArray();
    }

    /// <summary>
    /// By red, green, blue from the high bits: 0 for no range, else one more than the index of the range.
    /// </summary>
    internal byte[] Classes { get; } = new byte[1 << (3 * Bits)];

    /// <summary>The class of a colour: 0 for none, else one more than the index of its range.</summary>
    /// <param name="red">0 to 255.</param>
    /// <param name="green">0 to 255.</param>
    /// <param name="blue">0 to 255.</param>
    public int ClassOf(byte red, byte green, byte blue)
        => Classes[((red >> Shift) << (2 * Bits)) | ((green >> Shift) << Bits) | (blue >> Shift)];

    /// <summary>
    /// Selects ranges. A colour belongs to the range it is closest to, selected or not. Allocates nothing.
    /// </summary>
    /// <param name="ranges">A bit for each range, the first in bit 0.</param>
    public void Select(uint ranges)
    {
        if (ranges == _selected)
            return;
        _selected = ranges;
        for (int index = 0; index < Classes.Length; index++)
        {
            const int Mask = (1 << Bits) - 1;
            double red = Middle(index >> (2 * Bits));
            double green = Middle((index >> Bits) & Mask);
            double blue = Middle(index & Mask);
            Classes[index] = Classify(red, green, blue);
        }
    }

    private static double Middle(int step) => (step << Shift) + ((1 << Shift) / 2) - 0.5;

    private byte Classify(double red, double green, double blue)
    {
        byte best = 0;
        double closeness = 0;
        for (int i = 0; i < _ranges.Length; i++)
        {
            if (!_ranges[i].Contains(red, green, blue) || _ranges[i].Closeness(red, green, blue) <= closeness)
                continue;
            closeness = _ranges[i].Closeness(red, green, blue);
            best = (byte)(i + 1);
        }

        return best > 0 && (_selected & (1u << (best - 1))) != 0 ? best : (byte)0;
    }
}
