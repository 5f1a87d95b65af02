using System;

namespace Rabit.Vision;

/// <summary>From which brightness on a pixel is white, up to which it is black, by the ground of its tile.</summary>
internal readonly struct NeutralLimits
{
    // What may be white, and what clearly is, by the curve of sRGB: so much of the way from the brightness of ground
    // to that of white. Black is a part of the ground's.
    private const double WeakWhitePart = 0.3556;
    private const double StrongWhitePart = 0.6667;
    private const double WeakBlackRatio = 0.5;
    private const double StrongBlackRatio = 0.36;

    // What is darker than that by the whitest thing of the picture is only pale, as concrete, sand and the lines of a
    // road: four fifths of its light.
    private const double StrongByWhitest = 0.9;

    // White has nearly no colour: the difference of its channels is less than that part of the strongest, of 256.
    private const int MaxWhiteChroma = 60;

    private readonly int _strongWhite;
    private readonly int _strongBlack;

    public NeutralLimits(int level, int whitest, PatchTable table)
    {
        (WeakWhite, _strongWhite) = (256, 256);
        if (table.White > 0)
        {
            PatchColour white = table[table.White - 1];
            double above = white.Contrast - 1;
            double strong = level * (1 + (StrongWhitePart * above));
            WeakWhite = Math.Min(236, (int)(level * (1 + (WeakWhitePart * above))));
            _strongWhite = Math.Min(244, (int)Math.Max(strong, white.IsWhite ? whitest * StrongByWhitest : 0));
        }

        WeakBlack = table.Black > 0 ? (int)(level * WeakBlackRatio) : -1;
        _strongBlack = table.Black > 0 ? (int)(level * StrongBlackRatio) : -1;
    }

    /// <summary>From this green on it may be white.</summary>
    public int WeakWhite { get; }

    /// <summary>Up to this green it may be black.</summary>
    public int WeakBlack { get; }

    public unsafe byte WhiteEntry(byte* p, byte white)
    {
        int least = Math.Min(p[0], Math.Min(p[1], p[2]));
        int most = Math.Max(p[0], Math.Max(p[1], p[2]));
        if (least < WeakWhite || (most - least) * 256 > MaxWhiteChroma * most)
            return 0;
        return least >= _strongWhite ? (byte)(white | PatchTable.Strong) : white;
    }

    public unsafe byte BlackEntry(byte* p, byte black)
    {
        int most = Math.Max(p[0], Math.Max(p[1], p[2]));
        if (most > WeakBlack)
            return 0;
        return most <= _strongBlack ? (byte)(black | PatchTable.Strong) : black;
    }
}
