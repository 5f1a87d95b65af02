using System;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Darker corners, a wrong white balance and a wrong exposure: each level times a number, clipped at 255.
/// </summary>
internal sealed class LightGain
{
    private const int Shift = 10;

    private readonly int[] _places;     // of each pixel, 1/1024
    private readonly int[] _channels;   // red, green, blue, 1/1024

    public LightGain(SimulatedPictureEffects options, int width, int height)
    {
        _places = new int[width * height];
        double corner2 = ((double)width * width) + ((double)height * height);
        for (int i = 0; i < _places.Length; i++)
        {
            (double x, double y) = ((2 * (i % width)) + 1 - width, (2 * (i / width)) + 1 - height);
            double r2 = ((x * x) + (y * y)) / corner2;
            _places[i] = Scaled(1 - (options.Vignetting * r2));
        }

        double gain = options.ExposureGain;
        _channels = [Scaled(gain * options.RedGain), Scaled(gain), Scaled(gain * options.BlueGain)];
    }

    public void Apply(byte[] pixels)
    {
        (int red, int green, int blue) = (_channels[0], _channels[1], _channels[2]);
        int at = 0;
        foreach (int place in _places)
        {
            pixels[at] = Level(pixels[at], place, red);
            pixels[at + 1] = Level(pixels[at + 1], place, green);
            pixels[at + 2] = Level(pixels[at + 2], place, blue);
            at += 3;
        }
    }

    private static int Scaled(double gain) => (int)Math.Floor((gain * (1 << Shift)) + 0.5);

    private static byte Level(byte level, int place, int channel)
        => (byte)Math.Min(255, ((level * ((place * channel) >> Shift)) + (1 << (Shift - 1))) >> Shift);
}
