using System;

namespace Rabit.Uav.Simulation;

/// <summary>A colour of a thing as the camera sees it in full light, sRGB. A plain value.</summary>
internal readonly struct SurfaceColour(int red, int green, int blue)
{
    public int Red { get; } = red;

    public int Green { get; } = green;

    public int Blue { get; } = blue;

    /// <summary>
    /// The colour of one thing of many: a little lighter or darker, and a little off; together at most 10 % of each
    /// channel.
    /// </summary>
    public SurfaceColour Vary(ref SeededSequence random)
        => Vary(LightOf(ref random), ref random);

    /// <summary>The same, where it lies in the light of others: <see cref="LightOf"/>.</summary>
    public SurfaceColour Vary(double light, ref SeededSequence random) => new(
        Channel(Red, light, ref random), Channel(Green, light, ref random), Channel(Blue, light, ref random));

    /// <summary>How much lighter or darker one thing of many is.</summary>
    public static double LightOf(ref SeededSequence random) => 1 + (0.07 * random.NextSigned());

    private static int Channel(int nominal, double light, ref SeededSequence random)
    {
        double value = nominal * (light + (0.03 * random.NextSigned()));
        return Math.Min(255, (int)(value + 0.5));
    }
}
