using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Vision.Tests.Jpeg;

public sealed class InverseDctTests
{
    [Theory]
    [InlineData(1, 300)]
    [InlineData(2, 3_000)]
    [InlineData(3, 2_000_000_000)]
    public void Transform_ByVectorsAndByNumbers_AreTheSame(int seed, int range)
    {
        var numbers = new SeededNumbers(seed);
        var inverse = new InverseDct();
        int[] block = new int[64];
        byte[] expected = new byte[20 * 8];
        byte[] samples = new byte[20 * 8];
        for (int round = 0; round < 500; round++)
        {
            for (int at = 0; at < 64; at++)
                block[at] = numbers.Below(3) == 0 ? (int)numbers.Uniform(-range, range) : 0;
            inverse.TransformByNumbers(block, expected, 3, 20);

            inverse.Transform(block, samples, 3, 20);

            Assert.Equal(expected, samples);
        }
    }
}
