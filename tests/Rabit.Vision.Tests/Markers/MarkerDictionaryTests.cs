using System;
using Xunit;

namespace Rabit.Vision.Tests.Markers;

public sealed class MarkerDictionaryTests
{
    // The distances that both families are published with, over all rotations, also a code's to its own.
    [Theory]
    [InlineData(MarkerFamily.ArUco4x4, 4)]
    [InlineData(MarkerFamily.AprilTag36h11, 11)]
    public void Codes_AllRotations_AreAsFarApartAsPublished(MarkerFamily family, int expected)
    {
        MarkerDictionary dictionary = MarkerDictionary.Of(family);
        int least = int.MaxValue;
        for (int id = 0; id < dictionary.Count; id++)
        {
            for (int other = 0; other <= id; other++)
            {
                for (int turn = other == id ? 1 : 0; turn < 4; turn++)
                {
                    ulong turned = dictionary.CodeOf(other, turn);
                    least = Math.Min(least, MarkerDictionary.BitsOf(turned ^ dictionary.CodeOf(id)));
                }
            }
        }

        Assert.Equal(expected, least);
    }

    [Fact]
    public void TryFind_WrongCells_CorrectsThoseOf36h11()
    {
        MarkerDictionary tags = MarkerDictionary.AprilTag36h11;
        ulong code = tags.CodeOf(17, 3);
        Assert.True(tags.TryFind(code ^ 0b1000001, out int id, out int turn, out int distance));
        Assert.Equal((17, 3, 2), (id, turn, distance));
        Assert.False(tags.TryFind(code ^ 0b1000011, out _, out _, out _));
        Assert.False(MarkerDictionary.ArUco4x4.TryFind(MarkerDictionary.ArUco4x4.CodeOf(3) ^ 1, out _, out _, out _));
    }
}
