using System;
using System.Numerics;

namespace Rabit.Vision;

/// <summary>The colours of a patch and of the ground right around it.</summary>
internal sealed class PatchSamples(PatchMap map)
{
    // Of a patch without an inner pixel, those that are covered most show its colour best.
    private const double NearlyFull = 0.8;

    private readonly PatchMap _map = map;
    private readonly int[] _red = new int[256];
    private readonly int[] _green = new int[256];
    private readonly int[] _blue = new int[256];
    private byte[] _pixels = [];

    public void SetPicture(byte[] pixels) => _pixels = pixels;

    /// <summary>The median, so that a second thing beside it, a shadow or a road's line does not count.</summary>
    public MeanColour Ground()
    {
        Array.Clear(_red, 0, 256);
        Array.Clear(_green, 0, 256);
        Array.Clear(_blue, 0, 256);
        int count = CountGround();
        return new MeanColour { Red = Median(_red, count), Green = Median(_green, count), Blue = Median(_blue, count) };
    }

    /// <summary>
    /// The mean of the pixels that have only such around them; where it is too thin for that, of those furthest from
    /// the ground.
    /// </summary>
    /// <param name="ground">Around it.</param>
    /// <param name="pure">The same where the blur does not reach, if there is such.</param>
    public MeanColour Inside(in MeanColour ground, out MeanColour pure)
    {
        MeanColour core = default;
        MeanColour inner = default;
        for (int row = 2; row < _map.Rows - 2; row++)
        {
            for (int word = 0; word < _map.Own.Words; word++)
            {
                if (_map.Own[row, word] == 0)
                    continue;
                int first = _map.PixelAt(64 * word, row);
                ulong innerBits = _map.InnerOf(row, word);
                Add(first, innerBits, ref inner);
                Add(first, _map.CoreOf(row, word, innerBits), ref core);
            }
        }

        if (inner.Count >= 4)
        {
            MeanColour full = inner.Mean();
            pure = core.Count >= 4 ? core.Mean() : full;
            return full;
        }

        MeanColour mean = All();
        (double red, double green, double blue) =
            (mean.Red - ground.Red, mean.Green - ground.Green, mean.Blue - ground.Blue);
        double most = Strongest(ground, red, green, blue, double.PositiveInfinity, out _);
        Strongest(ground, red, green, blue, NearlyFull * most, out MeanColour best);
        pure = best.Count > 0 ? best.Mean() : mean;
        return pure;
    }

    private MeanColour All()
    {
        MeanColour all = default;
        for (int row = 0; row < _map.Rows; row++)
        {
            for (int word = 0; word < _map.Own.Words; word++)
                Add(_map.PixelAt(64 * word, row), _map.Own[row, word], ref all);
        }

        return all.Mean();
    }

    private unsafe int CountGround()
    {
        int count = 0;
        fixed (byte* pixels = _pixels)
        fixed (int* red = _red, green = _green, blue = _blue)
        {
            for (int row = 0; row < _map.Rows; row++)
            {
                for (int word = 0; word < _map.Ground.Words; word++)
                {
                    ulong bits = _map.Ground[row, word];
                    count += BitOperations.PopCount(bits);
                    int first = _map.PixelAt(64 * word, row);
                    for (; bits != 0; bits &= bits - 1)
                    {
                        byte* p = pixels + first + (3 * BitOperations.TrailingZeroCount(bits));
                        red[p[0]]++;
                        green[p[1]]++;
                        blue[p[2]]++;
                    }
                }
            }
        }

        return count;
    }

    private void Add(int first, ulong bits, ref MeanColour sum)
    {
        for (; bits != 0; bits &= bits - 1)
            sum.Add(_pixels, first + (3 * BitOperations.TrailingZeroCount(bits)));
    }

    private double Strongest(
        in MeanColour ground, double red, double green, double blue, double from, out MeanColour mean)
    {
        double most = 0;
        mean = default;
        for (int row = 0; row < _map.Rows; row++)
        {
            for (int word = 0; word < _map.Own.Words; word++)
            {
                int first = _map.PixelAt(64 * word, row);
                for (ulong bits = _map.Own[row, word]; bits != 0; bits &= bits - 1)
                {
                    int at = first + (3 * BitOperations.TrailingZeroCount(bits));
                    double along = ((_pixels[at] - ground.Red) * red) + ((_pixels[at + 1] - ground.Green) * green)
                        + ((_pixels[at + 2] - ground.Blue) * blue);
                    most = Math.Max(most, along);
                    if (along >= from)
                        mean.Add(_pixels, at);
                }
            }
        }

        return most;
    }

    private static int Median(int[] histogram, int all)
    {
        (int sum, int value) = (0, 0);
        while (value < 255 && 2 * (sum += histogram[value]) < all)
            value++;
        return value;
    }
}
