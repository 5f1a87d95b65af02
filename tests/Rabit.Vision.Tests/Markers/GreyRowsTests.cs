using System;
using System.Linq;
using Xunit;

namespace Rabit.Vision.Tests.Markers;

/// <summary>The loops in vectors give what the definition gives, at every length.</summary>
public sealed class GreyRowsTests
{
    private readonly Random _random = new(5);

    [Fact]
    public void MinMax_EveryLength_AreThoseOfEachPixel()
    {
        for (int length = 1; length < 70; length++)
        {
            (byte[] a, byte[] b) = (Bytes(length), Bytes(length));
            byte[] min = (byte[])a.Clone();
            byte[] max = (byte[])a.Clone();
            GreyRows.Min(min, b);
            GreyRows.Max(max, b);
            Assert.Equal(a.Zip(b, Math.Min), min);
            Assert.Equal(a.Zip(b, Math.Max), max);
        }
    }

    [Fact]
    public void ReduceTiles_EveryLength_AreThoseOfFourColumns()
    {
        for (int tiles = 1; tiles < 40; tiles++)
        {
            (byte[] low, byte[] high) = (Bytes(tiles * 4), Bytes(tiles * 4));
            (byte[] min, byte[] max) = (new byte[tiles], new byte[tiles]);
            GreyRows.ReduceTiles(low, high, min, max);
            for (int i = 0; i < tiles; i++)
            {
                Assert.Equal(low.Skip(i * 4).Take(4).Min(), min[i]);
                Assert.Equal(high.Skip(i * 4).Take(4).Max(), max[i]);
            }
        }
    }

    [Fact]
    public void Levels_EveryLength_LieBetweenTheExtremesOfThree()
    {
        for (int length = 1; length < 70; length++)
        {
            byte[] low = [.. Bytes(length + 2).Select(b => (byte)(b / 2))];
            byte[] high = [.. low.Select(b => (byte)(b + _random.Next(60)))];
            byte[] levels = new byte[length];
            GreyRows.Levels(low, high, levels, 40, 140);
            for (int i = 0; i < length; i++)
            {
                int min = low.Skip(i).Take(3).Min();
                int max = high.Skip(i).Take(3).Max();
                Assert.Equal(max - min < 40 ? 0 : min + ((max - min) * 140 / 256), levels[i]);
            }
        }
    }

    private byte[] Bytes(int count)
    {
        byte[] bytes = new byte[count];
        _random.NextBytes(bytes);
        return bytes;
    }
}
