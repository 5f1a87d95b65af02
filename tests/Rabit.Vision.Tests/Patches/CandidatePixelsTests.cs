#if NET
using System;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Vision.Tests.Patches;

/// <summary>The quick look at a row leaves out nothing that the table, or the limits of white or black, take.</summary>
public sealed class CandidatePixelsTests(ITestOutputHelper output)
{
    private const int Width = 203;   // some are left over after the last 16
    private const int Height = 60;

    private static readonly PatchTable Table = new(
    [
        new ColourRange(205, 28, 32), new ColourRange(28, 72, 205), new ColourRange(243, 214, 28),
        new ColourRange(40, 190, 60), new ColourRange(236, 236, 234), new ColourRange(20, 20, 20),
    ]);

    private readonly CandidatePixels _candidates = new();
    private readonly PictureLight _light = new();

    [Theory]
    [InlineData(1, 1)]
    [InlineData(0.6, 1.7)]
    [InlineData(1.5, 0.45)]
    public void Look_AnyColours_HasAllThatHaveAnEntry(double redder, double bluer)
    {
        int seed = Environment.TickCount;
        output.WriteLine($"seed {seed}");
        byte[] picture = Paint(new Random(seed), redder, bluer);
        _light.Measure(picture, Width, Height);
        Assert.Equal(redder != 1, _light.RedGain != 1 && _light.BlueGain != 1);
        if (!_candidates.TrySet(_light, Table, Width))
        {
            // The pixels are then looked at one by one.
            Assert.False(CandidatePixels.TryFindFactor(_light.RedGain, out _)
                && CandidatePixels.TryFindFactor(_light.BlueGain, out _));
            return;
        }

        var limits = new NeutralLimits(_light.Level, _light.Whitest, Table);
        _candidates.SetLimits(0, Width, limits);
        (int entries, int leftOut) = (0, 0);
        for (int row = 0; row < Height; row++)
        {
            _candidates.Look(picture.AsSpan(3 * row * Width, 3 * Width), Width);
            for (int column = 0; column < Width; column++)
            {
                bool isCandidate = (_candidates.Bits[0, column >> 6] >> (column & 63) & 1) != 0;
                bool isNeutral = (_candidates.Neutral[0, column >> 6] >> (column & 63) & 1) != 0;
                int at = 3 * ((row * Width) + column);
                bool hasColour = EntryOf(picture, at) != 0;
                bool isWhiteOrBlack = NeutralEntryOf(picture, at, limits) != 0;
                Assert.True(isCandidate || !hasColour, $"row {row}, column {column}");
                Assert.True((isCandidate && isNeutral) || !isWhiteOrBlack, $"row {row}, column {column}");
                entries += hasColour || isWhiteOrBlack ? 1 : 0;
                leftOut += isCandidate ? 0 : 1;
            }
        }

        Assert.InRange(entries, 500, Width * Height);
        Assert.InRange(leftOut, 500, Width * Height);
    }

    [Theory]
    [InlineData(1, true)]
    [InlineData(1.2, true)]
    [InlineData(0.77, true)]
    [InlineData(2.5, false)]   // more than a factor can say
    public void TryFindFactor_Gain_GivesTheSameSteps(double gain, bool isPossible)
    {
        Assert.Equal(isPossible, CandidatePixels.TryFindFactor(gain, out ushort factor));
        for (int level = 0; isPossible && level < 256; level++)
            Assert.Equal(Math.Min(255, (int)(level * gain)) >> 3, Math.Min(255, (level * factor) >> 15) >> 3);
    }

    // Half of it ground, the rest of any colour.
    private static byte[] Paint(Random random, double redder, double bluer)
    {
        byte[] picture = new byte[3 * Width * Height];
        for (int at = 0; at < picture.Length; at += 3)
        {
            bool isGround = random.Next(2) == 0;
            picture[at] = Level(redder * (isGround ? 86 + random.Next(9) : random.Next(256)));
            picture[at + 1] = Level(isGround ? 92 + random.Next(9) : random.Next(256));
            picture[at + 2] = Level(bluer * (isGround ? 70 + random.Next(9) : random.Next(256)));
        }

        return picture;
    }

    private static byte Level(double value) => (byte)Math.Min(255, value);

    private byte EntryOf(byte[] picture, int at)
    {
        int red = Math.Min(255, (int)(picture[at] * _light.RedGain));
        int blue = Math.Min(255, (int)(picture[at + 2] * _light.BlueGain));
        return Table.Entries[((red >> 3) << 10) | ((picture[at + 1] >> 3) << 5) | (blue >> 3)];
    }

    private static unsafe byte NeutralEntryOf(byte[] picture, int at, in NeutralLimits limits)
    {
        fixed (byte* p = &picture[at])
            return (byte)(limits.WhiteEntry(p, Table.White) | limits.BlackEntry(p, Table.Black));
    }
}
#endif
