using System;

namespace Rabit.Vision;

/// <summary>
/// The one or two colours of a panel, and which pixels may show them: black and white by their brightness against the
/// ground around them, others by hue and saturation. Immutable.
/// </summary>
/// <example>
/// <code>
/// var chequered = new PanelColours(new ColourRange(20, 20, 20), new ColourRange(240, 240, 240));
/// var redAndWhite = new PanelColours(new ColourRange(205, 28, 32), new ColourRange(240, 240, 240));
/// var black = new PanelColours(new ColourRange(20, 20, 20));
/// </code>
/// </example>
public sealed class PanelColours
{
    // By the curve of sRGB: a sixth of the light of the ground, and twice of it.
    internal const float MaxDarkByGround = 0.42f;
    internal const float MinBrightByGround = 1.45f;

    internal const int Bits = 5;

    private const int MaxBlack = 80;
    private const int MinWhite = 180;
    private const double MinHueApartDegrees = 25;
    private const double MaxHueDegrees = 15;
    private const double MinSaturation = 0.55;
    private const double MinChroma = 30;

    // What shows a colour beside the ground, whatever that is: nearly half of it.
    private const float PartOfChroma = 0.45f;

    private readonly float _firstChroma;
    private readonly float _secondChroma;

    /// <summary>Takes the colours.</summary>
    /// <param name="first">One.</param>
    /// <param name="second">The other; null for a panel of one colour.</param>
    /// <exception cref="ArgumentException">They cannot be distinguished, or one is grey, as ground is.</exception>
    public PanelColours(ColourRange first, ColourRange? second = null)
    {
        if (FindFault(first ?? throw new ArgumentNullException(nameof(first)), second) is { } fault)
            throw new ArgumentException($"The colours of a panel: {fault}.", nameof(second));
        (First, Second) = (first, second);
        DarkPart = PartThat(IsBlack);
        BrightPart = PartThat(IsWhite);
        HasHue = !IsNeutral(first) || (second is not null && !IsNeutral(second));
        (_firstChroma, _secondChroma) = (ChromaThatShows(first), second is null ? 0 : ChromaThatShows(second));
        var one = new PatchColour(first);
        PatchColour? other = second is null ? null : new PatchColour(second);
        for (int index = 0; index < Table.Length; index++)
        {
            (double red, double green, double blue) =
                (Middle(index >> (2 * Bits)), Middle(index >> Bits), Middle(index));
            double chroma = Math.Max(red, Math.Max(green, blue)) - Math.Min(red, Math.Min(green, blue));
            if (chroma >= MinChroma)
                Table[index] = (byte)(Shows(one, red, green, blue) ? 1 : Shows(other, red, green, blue) ? 2 : 0);
        }
    }

    /// <summary>One of them.</summary>
    public ColourRange First { get; }

    /// <summary>The other; null for a panel of one colour.</summary>
    public ColourRange? Second { get; }

    /// <summary>Which one is black: 1 or 2, 0 for none.</summary>
    internal byte DarkPart { get; }

    /// <summary>Which one is white: 1 or 2, 0 for none.</summary>
    internal byte BrightPart { get; }

    /// <summary>Whether one of them is black or white, which the brightness of the ground shows.</summary>
    internal bool HasNeutral => (DarkPart | BrightPart) != 0;

    /// <summary>Whether one of them is neither black nor white.</summary>
    internal bool HasHue { get; }

    /// <summary>
    /// Levels of chroma with which a pixel shows one of them whatever the ground is; of one that has a hue.
    /// </summary>
    /// <param name="part">1 for the first, 2 for the second.</param>
    internal float ChromaThatSuffices(int part) => part == 1 ? _firstChroma : _secondChroma;

    /// <summary>By red, green, blue from the high bits: 1 or 2 for what has a hue, else 0.</summary>
    internal byte[] Table { get; } = new byte[1 << (3 * Bits)];

    /// <summary>Whether a colour is black: it has no hue, and is dark.</summary>
    /// <param name="colour">The colour.</param>
    /// <exception cref="ArgumentNullException">It is null.</exception>
    public static bool IsBlack(ColourRange colour) => IsNeutral(colour) && StrongestOf(colour) <= MaxBlack;

    /// <summary>Whether a colour is white: it has no hue, and is bright.</summary>
    /// <param name="colour">The colour.</param>
    /// <exception cref="ArgumentNullException">It is null.</exception>
    public static bool IsWhite(ColourRange colour) => IsNeutral(colour) && StrongestOf(colour) >= MinWhite;

    /// <summary>Whether a colour is black, white or grey: it has no hue.</summary>
    /// <param name="colour">The colour.</param>
    /// <exception cref="ArgumentNullException">It is null.</exception>
    public static bool IsNeutral(ColourRange colour)
        => ColourRange.Describe(
            (colour ?? throw new ArgumentNullException(nameof(colour))).Red, colour.Green, colour.Blue).Saturation
            < PatchColour.MinSaturation;

    /// <summary>Why a panel of these colours cannot be found; null if it can.</summary>
    /// <param name="first">One.</param>
    /// <param name="second">The other; null for a panel of one colour.</param>
    public static string? FindFault(ColourRange first, ColourRange? second)
    {
        if (IsGrey(first ?? throw new ArgumentNullException(nameof(first))) || (second is not null && IsGrey(second)))
            return "one of them is grey, as ground is";
        if (second is null)
            return null;
        bool areSame = IsNeutral(first) || IsNeutral(second)
            ? IsNeutral(first) && IsNeutral(second) && IsBlack(first) == IsBlack(second)
            : HueBetween(first, second) < MinHueApartDegrees;
        return areSame ? "they are the same, or too near to each other" : null;
    }

    private static bool IsGrey(ColourRange colour) => IsNeutral(colour) && !IsBlack(colour) && !IsWhite(colour);

    private static int StrongestOf(ColourRange colour) => Math.Max(colour.Red, Math.Max(colour.Green, colour.Blue));

    private static float ChromaThatShows(ColourRange colour)
        => PartOfChroma * (float)ColourRange.Describe(colour.Red, colour.Green, colour.Blue).Chroma;

    private static double HueBetween(ColourRange one, ColourRange other)
    {
        double off = Math.Abs(
            ColourRange.Describe(one.Red, one.Green, one.Blue).HueDegrees
            - ColourRange.Describe(other.Red, other.Green, other.Blue).HueDegrees);
        return Math.Min(off, 360 - off);
    }

    private static double Middle(int index) => ((index & ((1 << Bits) - 1)) << (8 - Bits)) + 3.5;

    private static bool Shows(PatchColour? colour, double red, double green, double blue)
    {
        if (colour is null || colour.IsNeutral)
            return false;
        (double hue, double saturation) = colour.Compare(red, green, blue);
        return hue <= MaxHueDegrees && saturation >= MinSaturation;
    }

    private byte PartThat(Func<ColourRange, bool> holds)
        => (byte)(holds(First) ? 1 : Second is not null && holds(Second) ? 2 : 0);
}
