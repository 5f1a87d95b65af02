namespace Rabit.Vision;

/// <summary>Colour types of a PNG (PNG specification, 11.2.1).</summary>
internal enum PngColour : byte
{
    Grey = 0,
    Rgb = 2,
    Palette = 3,
    GreyAlpha = 4,
    Rgba = 6,
}
