using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>Says of every colour of a picture, in steps of 8 for each channel, which colour of a target it may be: 32 KB that stay in the cache.</summary>
internal sealed class ColourTable
{
    /// <summary>Low bits of a channel that are not looked at.</summary>
    public const int Shift = 3;

    /// <summary>Bits of a channel that are looked at.</summary>
    public const int Bits = 8 - Shift;

    /// <summary>By red, green, blue from the high bits: 0 for none, else one more than the place in <see cref="TargetColour.All"/>.</summary>
    public byte[] Classes { get; } = new byte[1 << (3 * Bits)];

    /// <summary>The colours that are looked for.</summary>
    public TargetColours Colours { get; private set; }

    /// <summary>Looks for other colours from now on. Allocates nothing.</summary>
    public void Choose(TargetColours colours)
    {
        if (colours == Colours)
            return;
        Colours = colours;
        for (int index = 0; index < Classes.Length; index++)
        {
            const int Mask = (1 << Bits) - 1;
            double red = Middle(index >> (2 * Bits));
            double green = Middle((index >> Bits) & Mask);
            double blue = Middle(index & Mask);
            Classes[index] = ClassOf(red, green, blue, colours);
        }
    }

    private static double Middle(int step) => (step << Shift) + ((1 << Shift) / 2) - 0.5;

    private static byte ClassOf(double red, double green, double blue, TargetColours colours)
    {
        TargetColour[] all = TargetColour.All;
        byte best = 0;
        double closeness = 0;
        for (int i = 0; i < all.Length; i++)
        {
            if (!all[i].Holds(red, green, blue) || all[i].Closeness(red, green, blue) <= closeness)
                continue;
            closeness = all[i].Closeness(red, green, blue);
            best = (byte)(i + 1);
        }

        return best > 0 && (colours & all[best - 1].Colour) != 0 ? best : (byte)0;
    }
}
