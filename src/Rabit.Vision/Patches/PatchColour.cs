using System;

namespace Rabit.Vision;

/// <summary>
/// How unlike a colour is to that of a surface, whatever light and camera made of it: shade changes its brightness
/// alone, haze and the ground beside it make it paler, and where the strongest channel is at its end, the second one
/// goes on and turns the hue (an overexposed orange is yellowish).
/// </summary>
internal sealed class PatchColour
{
    /// <summary>From this chroma on, part of its strongest channel, it has a hue of its own.</summary>
    public const double MinSaturation = 0.3;

    // One standard deviation.
    private const double HueSigmaDegrees = 6;
    private const double SaturationSigma = 0.11;
    private const double FullSaturation = 0.92;

    // Light of usual ground, and of the darkest. What has less light in its colour than this part of the nominal one
    // is dull.
    private const double LightOfGround = 0.16;
    private const double MinLight = 0.01;
    private const double FullBrilliance = 0.8;
    private const double MinBrilliance = 0.5;

    // Pixels: from where on that counts, and from where on fully.
    private const double SmallSide = 4.5;
    private const double LargeSide = 7;

    // White is twice as bright as ground by the curve of sRGB, which is five times the light; a light grey less.
    private const double FullContrast = 1.9;
    private const double LevelOfWhite = 236;
    private const double MinPartOfWhite = 0.4;
    private const double ContrastSigma = 0.15;
    private const double NeutralSigma = 0.055;

    // Of white and light greys, natural logarithms: between red and blue, where light and white balance shift it most,
    // and of green against both; what is warm and has less of it, as concrete and stone often are, counts more.
    private const double RedByBlueSigma = 0.095;
    private const double GreenSigma = 0.037;
    private const double LittleGreenSigma = 0.025;
    private const double FullyWarm = 0.02;   // red by blue, so that nothing jumps

    // What is brighter against usual ground than white usually is, is less often a stone, and its tint more often of
    // the light: by how much less that counts, for up to so much, natural logarithm. Against dark ground stones are as
    // bright.
    private const double TintByBrightness = 0.3;
    private const double MaxBrighter = 0.35;

    // Ground that is paler than that by the picture is concrete or sand: white stands out less against it, but is as
    // bright by the rest of the picture.
    private const double MaxPale = 1.3;

    // What is white on what has less light than any usual ground has, against that of the picture, is a part of a
    // print, as the cells of a marker: from where on that counts, and one standard deviation. Asphalt has 0.5 and more.
    private const double BlackGround = 0.44;
    private const double BlackGroundSigma = 0.015;

    // Least channel of a white, level.
    private const int MinWhite = 215;

    private const double FullBrightness = 1.15;
    private const double BrightnessSigma = 0.15;

    private const double ClippedFrom = 225;

    // Three times the light, by the curve of sRGB.
    private const double Overexposure = 1.65;

    private readonly double _hue;
    private readonly double _saturation;
    private readonly double _redByBlue;   // of a light grey: its own, which is none of the light; logarithm
    private readonly double _green;       // the same, against both
    private readonly double _tint;        // the same of a dark one, chroma
    private readonly int _strongest;
    private readonly double _turn;   // of the hue by overexposure, degrees
    private readonly double _brilliance;   // light in its colour, of that of usual ground

    public PatchColour(ColourRange colour)
    {
        (_hue, _saturation, _) = ColourRange.Describe(colour.Red, colour.Green, colour.Blue);
        _strongest = colour.Red >= colour.Green && colour.Red >= colour.Blue ? 0 : colour.Green >= colour.Blue ? 1 : 2;
        IsNeutral = _saturation < MinSaturation;
        IsWhite = IsNeutral && Math.Min(colour.Red, Math.Min(colour.Green, colour.Blue)) >= MinWhite;
        _tint = ChromaOf(colour.Red, colour.Green, colour.Blue);
        (_redByBlue, _green) = IsWhite ? (0, 0) : TintOf(colour.Red, colour.Green, colour.Blue);
        int most = Math.Max(colour.Red, Math.Max(colour.Green, colour.Blue));
        IsBright = most >= 128;
        Contrast = IsBright ? FullContrast * Math.Min(1, most / LevelOfWhite) : FullContrast;
        PartOfWhite = IsNeutral && IsBright && !IsWhite
            ? Math.Max(MinPartOfWhite, (Contrast - 1) / (FullContrast - 1)) : 1;
        (double hue, _, _) = ColourRange.Describe(
            Math.Min(255, Overexposure * colour.Red), Math.Min(255, Overexposure * colour.Green),
            Math.Min(255, Overexposure * colour.Blue));
        _turn = Difference(hue, _hue);
        _brilliance = ChromaLight(colour.Red, colour.Green, colour.Blue) / LightOfGround;
    }

    /// <summary>White, black or grey: only its brightness against its surroundings shows it.</summary>
    public bool IsNeutral { get; }

    /// <summary>Of a neutral one: white or a light grey.</summary>
    public bool IsBright { get; }

    /// <summary>Of a neutral one: how many times as bright as the ground it is, by the curve of sRGB.</summary>
    public double Contrast { get; }

    /// <summary>
    /// Of a light grey, its contrast with usual ground as a part of that of white, at least 0.4; 1 for all others.
    /// </summary>
    public double PartOfWhite { get; }

    /// <summary>White, and no grey: nothing that is lit as it is and is no lamp is brighter.</summary>
    public bool IsWhite { get; }

    /// <summary>How far the hue is off, degrees, and the saturation as a part of the nominal one.</summary>
    public (double HueDegrees, double Saturation) Compare(double red, double green, double blue)
    {
        (double hue, double saturation, _) = ColourRange.Describe(red, green, blue);
        double off = Difference(hue, _hue);
        if (Math.Max(red, Math.Max(green, blue)) >= ClippedFrom)
            off = _turn > 0 ? off - Clamp(off, 0, _turn) : off - Clamp(off, _turn, 0);
        return (Math.Abs(off), saturation / _saturation);
    }

    /// <summary>
    /// How much of its light is in its colour against the ground around it, or that of the whole picture where it is
    /// darker, as a part of the nominal one: haze takes saturation, but not that, and shade takes it from the ground
    /// too. A dull surface has little of both. From 0.5 to 1; what has more, and what is so small that the ground is
    /// mixed into it, counts as 1.
    /// </summary>
    public double Brilliance(in PatchShape shape, double level, double mixed)
    {
        double ground = Math.Max(shape.GroundRed, Math.Max(shape.GroundGreen, shape.GroundBlue));
        double around = Math.Max(MinLight, LinearLight.Of(Math.Min(ground, level)));
        double part = ChromaLight(shape.Red, shape.Green, shape.Blue) / around / _brilliance / (1 - mixed);
        double dull = 1 - Clamp(part / FullBrilliance, MinBrilliance, 1);
        return 1 - (dull * Clamp((Math.Sqrt(shape.Area) - SmallSide) / (LargeSide - SmallSide), 0, 1));
    }

    /// <summary>How unlike: 0 for the same, 1 for one standard deviation in hue or saturation, squared.</summary>
    /// <param name="red">0 to 255.</param>
    /// <param name="green">0 to 255.</param>
    /// <param name="blue">0 to 255.</param>
    /// <param name="brilliance">1, or less for what may be paler the less: <see cref="Brilliance"/>.</param>
    public double Cost(double red, double green, double blue, double brilliance)
    {
        (double hue, double saturation) = Compare(red, green, blue);
        double pale = Math.Max(0, FullSaturation - saturation) / (brilliance * SaturationSigma);
        return (hue * hue / (HueSigmaDegrees * HueSigmaDegrees)) + (pale * pale);
    }

    /// <summary>
    /// The same for white, black or grey: by brightness against the ground, and by how little colour; of a light grey
    /// by its own tint.
    /// </summary>
    public double NeutralCost(in PatchShape shape, PictureLight light)
    {
        double inside = shape.Red + (2 * shape.Green) + shape.Blue;
        double ground = shape.GroundRed + (2 * shape.GroundGreen) + shape.GroundBlue;
        int level = light.Level;
        double ratio = IsBright
            ? inside / Math.Max(1, Math.Min(Math.Max(ground, 4 * level), MaxPale * 4 * level))
            : Math.Min(ground, 4 * level) / Math.Max(1, inside);
        double off = Math.Log(ratio / Contrast);
        double weak = Math.Max(0, -off) / ContrastSigma;
        if (!IsBright)
            return (weak * weak) + ChromaCost(shape);
        double black = Math.Max(0, BlackGround - (ground / (4.0 * level))) / BlackGroundSigma;
        double bright = IsWhite ? 1 + (TintByBrightness * Clamp(off, 0, MaxBrighter)) : 1;
        return (weak * weak) + (black * black) + (TintCost(shape, light) / (bright * bright));
    }

    /// <summary>
    /// How much too dark it is against the ground, in standard deviations: what has a bright colour reflects more in
    /// its strongest channel than ground does, and in the shade of a tree hardly less.
    /// </summary>
    public double Darkness(in PatchShape shape)
    {
        double ratio = _strongest switch
        {
            0 => shape.Red / Math.Max(1, shape.GroundRed),
            1 => shape.Green / Math.Max(1, shape.GroundGreen),
            _ => shape.Blue / Math.Max(1, shape.GroundBlue),
        };
        return Math.Max(0, FullBrightness - ratio) / BrightnessSigma;
    }

    private double ChromaCost(in PatchShape shape)
    {
        double chroma = Math.Max(0, ChromaOf(shape.Red, shape.Green, shape.Blue) - _tint) / NeutralSigma;
        return chroma * chroma;
    }

    // Lush grass has little red and blue in any light: where they were raised for that, it may have been too much, and
    // the likelier of both counts.
    private double TintCost(in PatchShape shape, PictureLight light)
    {
        double cost = TintCost(shape.Red, shape.Green, shape.Blue, light.LikelyTint);
        if (light.RedGain <= 1 && light.BlueGain <= 1)
            return cost;
        (double red, double blue) = (Math.Max(1, light.RedGain), Math.Max(1, light.BlueGain));
        return Math.Min(cost, TintCost(shape.Red / red, shape.Green, shape.Blue / blue, light.LikelyTint));
    }

    private double TintCost(double red, double green, double blue, double likelyTint)
    {
        (double redByBlue, double againstBoth) = TintOf(red, green, blue);
        redByBlue -= _redByBlue;
        againstBoth -= _green;
        double tint = (redByBlue - likelyTint) / RedByBlueSigma;
        double warm = againstBoth < 0 ? Clamp(redByBlue / FullyWarm, 0, 1) : 0;
        againstBoth /= GreenSigma + (warm * (LittleGreenSigma - GreenSigma));
        return (tint * tint) + (againstBoth * againstBoth);
    }

    private static (double RedByBlue, double Green) TintOf(double red, double green, double blue)
    {
        (double logRed, double logBlue) = (LogOf(red), LogOf(blue));
        return (logRed - logBlue, LogOf(green) - ((logRed + logBlue) / 2));
    }

    private static double LogOf(double level) => Math.Log(Math.Max(1, level));

    private static double ChromaLight(double red, double green, double blue)
        => LinearLight.Of(Math.Max(red, Math.Max(green, blue))) - LinearLight.Of(Math.Min(red, Math.Min(green, blue)));

    private static double ChromaOf(double red, double green, double blue)
    {
        double most = Math.Max(red, Math.Max(green, blue));
        return (most - Math.Min(red, Math.Min(green, blue))) / Math.Max(60, most);
    }

    private static double Difference(double a, double b)
    {
        double off = a - b;
        return off > 180 ? off - 360 : off < -180 ? off + 360 : off;
    }

    private static double Clamp(double value, double min, double max) => Math.Max(min, Math.Min(max, value));
}
