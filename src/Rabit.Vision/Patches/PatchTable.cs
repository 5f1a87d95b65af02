using System;

namespace Rabit.Vision;

/// <summary>
/// Which colours of pixels may belong to a patch of one of the colours that are searched for, weakly or strongly, in
/// steps of 8 for each channel: made once. White and black have none: they depend on the light around them.
/// </summary>
public sealed class PatchTable
{
    /// <summary>Maximum of colours.</summary>
    public const int MaxColours = 32;

    /// <summary>In an entry: the colour is clear, not only possible.</summary>
    internal const byte Strong = 0x80;

    internal const int Bits = 5;

    private const double WeakHueDegrees = 18;
    private const double WeakSaturation = 0.5;
    private const double StrongHueDegrees = 12;
    private const double StrongSaturation = 0.66;
    private const double MinChroma = 40;

    private readonly PatchColour[] _colours;

    /// <summary>Makes the table.</summary>
    /// <param name="colours">At most <see cref="MaxColours"/>.</param>
    /// <exception cref="ArgumentException">There are more, or white or black twice.</exception>
    public PatchTable(ReadOnlySpan<ColourRange> colours)
    {
        if (FindFault(colours) is { } fault)
            throw new ArgumentException($"The colours of patches: {fault}.", nameof(colours));
        _colours = new PatchColour[colours.Length];
        for (int i = 0; i < colours.Length; i++)
            _colours[i] = new PatchColour(colours[i]);
        White = FindNeutral(isBright: true);
        Black = FindNeutral(isBright: false);
        for (int index = 0; index < Entries.Length; index++)
            Entries[index] = Classify(Middle(index >> (2 * Bits)), Middle(index >> Bits), Middle(index));
        Chroma = new ChromaLimits(Entries);
    }

    /// <summary>Why no table can be made for these colours; null if one can.</summary>
    /// <param name="colours">All different.</param>
    public static string? FindFault(ReadOnlySpan<ColourRange> colours)
    {
        if (colours.Length > MaxColours)
            return $"there are {colours.Length} colours; at most {MaxColours} are possible";
        (int bright, int dark) = (0, 0);
        foreach (ColourRange colour in colours)
        {
            var patch = new PatchColour(colour);
            bright += patch is { IsNeutral: true, IsBright: true } ? 1 : 0;
            dark += patch is { IsNeutral: true, IsBright: false } ? 1 : 0;
        }

        return bright > 1 || dark > 1
            ? $"there are two {(bright > 1 ? "whites or light greys" : "blacks or dark greys")} that differ; only brightness shows them, which must be the same for all classes"
            : null;
    }

    /// <summary>How many colours.</summary>
    public int Count => _colours.Length;

    /// <summary>By red, green, blue from the high bits: 0 for none, else the index of the colour and 1.</summary>
    internal byte[] Entries { get; } = new byte[1 << (3 * Bits)];

    /// <summary>How much colour the entries have at least.</summary>
    internal ChromaLimits Chroma { get; }

    /// <summary>One more than the index of white; 0 if it is not searched for.</summary>
    internal byte White { get; }

    /// <summary>One more than the index of black; 0 if it is not searched for.</summary>
    internal byte Black { get; }

    internal PatchColour this[int index] => _colours[index];

    /// <summary>
    /// How unlike the colour of a patch is to one of the table, as the sum of squared deviations: 0 for the same,
    /// up to about 4 in its usual light. The veil of haze, and what the blur of the lens mixes in of the ground, are
    /// taken out first; not for neutral colours.
    /// </summary>
    /// <param name="shape">What was measured of the patch.</param>
    /// <param name="index">The colour.</param>
    /// <param name="light">Of the picture.</param>
    /// <param name="mixed">How much of the ground the blur mixes into it, 0 to 1.</param>
    public double CostOf(in PatchShape shape, int index, PictureLight light, out double mixed)
    {
        mixed = 0;
        if (light is null)
            throw new ArgumentNullException(nameof(light));
        PatchColour colour = _colours[index];
        if (colour.IsNeutral)
            return colour.NeutralCost(shape, light);
        double brilliance = colour.Brilliance(shape, light.Level, UsuallyMixed(shape));
        double least = double.PositiveInfinity;
        for (double veil = 0; veil <= 1; veil += 0.5)
        {
            double cost = CostWithoutVeil(colour, shape, light, veil, brilliance, least, out double part);
            if (cost < least)
                (least, mixed) = (cost, part);
        }

        return least;
    }

    /// <summary>Whether a colour is white or black, which only brightness shows.</summary>
    /// <param name="index">The colour.</param>
    public bool IsNeutral(int index) => _colours[index].IsNeutral;

    /// <summary>Whether a colour is white, and no light grey as that of a silver car.</summary>
    /// <param name="index">The colour.</param>
    public bool IsWhite(int index) => _colours[index].IsWhite;

    /// <summary>
    /// Of a light grey, its contrast with usual ground as a part of that of white, at least 0.4: what varies on it and
    /// around it is the larger against that. 1 for all others.
    /// </summary>
    /// <param name="index">Of the colours it was made for.</param>
    public double PartOfWhite(int index) => _colours[index].PartOfWhite;

    /// <summary>How much darker against the ground a patch is than one of its colour should be, squared.</summary>
    /// <param name="shape">What was measured of the patch.</param>
    /// <param name="index">The colour; 0 for white and black.</param>
    public double DarknessOf(in PatchShape shape, int index)
    {
        double off = _colours[index].IsNeutral ? 0 : _colours[index].Darkness(shape);
        return off * off;
    }

    // How much blur mixes in costs by itself: from where that alone is more than the least on, nothing is left to try.
    private static double CostWithoutVeil(
        PatchColour colour, in PatchShape shape, PictureLight light, double veil, double brilliance, double least,
        out double mixed)
    {
        mixed = 0;
        double usual = UsuallyMixed(shape);
        (double red, double green, double blue) = light.Unveil(shape.Red, shape.Green, shape.Blue, veil);
        (double groundRed, double groundGreen, double groundBlue) =
            light.Unveil(shape.GroundRed, shape.GroundGreen, shape.GroundBlue, veil);
        for (double part = 0; part < 0.65 && part / usual * (part / usual) < least; part += 0.1)
        {
            double cost = colour.Cost(
                Math.Max(0, red - (part * groundRed)),
                Math.Max(0, green - (part * groundGreen)),
                Math.Max(0, blue - (part * groundBlue)), brilliance) + (part / usual * (part / usual));
            if (cost < least)
                (least, mixed) = (cost, part);
        }

        return least;
    }

    private static double UsuallyMixed(in PatchShape shape) => 0.1 + (1 / Math.Sqrt(shape.Area));

    private static double Middle(int index) => ((index & ((1 << Bits) - 1)) << (8 - Bits)) + 3.5;

    private byte FindNeutral(bool isBright)
    {
        int at = Array.FindIndex(_colours, c => c.IsNeutral && c.IsBright == isBright);
        return (byte)(at + 1);
    }

    private byte Classify(double red, double green, double blue)
    {
        if (Math.Max(red, Math.Max(green, blue)) - Math.Min(red, Math.Min(green, blue)) < MinChroma)
            return 0;
        int best = -1;
        double least = double.PositiveInfinity;
        for (int i = 0; i < _colours.Length; i++)
        {
            double cost = _colours[i].IsNeutral ? least : _colours[i].Cost(red, green, blue, brilliance: 1);
            if (cost < least)
                (best, least) = (i, cost);
        }

        if (best < 0)
            return 0;
        (double hue, double saturation) = _colours[best].Compare(red, green, blue);
        if (hue > WeakHueDegrees || saturation < WeakSaturation)
            return 0;
        bool isStrong = hue <= StrongHueDegrees && saturation >= StrongSaturation;
        return (byte)((best + 1) | (isStrong ? Strong : 0));
    }
}
