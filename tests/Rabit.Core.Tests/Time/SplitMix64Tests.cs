using System.Linq;
using Rabit.Core.Time;
using Xunit;

namespace Rabit.Core.Tests.Time;

public sealed class SplitMix64Tests
{
    // The reference outputs of Vigna's splitmix64.c for two seeds.
    [Theory]
    [InlineData(1234567UL,
        new[]
        {
            6457827717110365317UL, 3203168211198807973UL, 9817491932198370423UL, 4593380528125082431UL,
            16408922859458223821UL
        })]
    [InlineData(0UL,
        new[]
        {
            0xE220A8397B1DCDAFUL, 0x6E789E6AA1B965F4UL, 0x06C45D188009454FUL, 0xF88BB8A8724C81ECUL, 0x1B39896A51A8749BUL
        })]
    public void Next_PublishedSeeds_MapsThePublishedOutputs(ulong seed, ulong[] outputs)
    {
        foreach (int limit in new[] { 1, 2, 3, 7, 1000, int.MaxValue })
        {
            var random = new SplitMix64(seed);
            Assert.All(
                outputs, output => Assert.Equal((int)(((output >> 32) * (ulong)limit) >> 32), random.Next(limit)));
        }
    }

    [Fact]
    public void Next_SmallLimit_IsEvenOverManyDraws()
    {
        var random = new SplitMix64(42);
        int[] counts = new int[6];
        for (int i = 0; i < 60_000; i++)
            counts[random.Next(6)]++;

        // Expected 10 000 each, with a standard deviation of 91.
        Assert.True(counts.All(c => c is > 9_500 and < 10_500), string.Join(" ", counts));
    }
}
