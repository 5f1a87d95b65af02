using System;

namespace Rabit.Vision;

/// <summary>From which brightness on a pixel is white, up to which it is black, by the ground of its tile.</summary>
internal readonly struct NeutralLimits
{
    // White is brighter than the ground by so much, by the curve of sRGB; black darker.
    private const double WeakWhiteRatio = 1.32;
    private const double StrongWhiteRatio = 1.6;
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
        WeakWhite = table.White > 0 ? Math.Min(236, (int)(level * WeakWhiteRatio)) : 256;
        _strongWhite = table.White > 0
            ? Math.Min(244, (int)Math.Max(level * StrongWhiteRatio, whitest * StrongByWhitest))
            : 256;
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
