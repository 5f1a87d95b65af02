using System;
using System.Linq;
using Xunit;

namespace Rabit.Vision.Tests.Pictures;

public sealed class YuyvTests
{
    // As Yuv420 makes of the same colours, each pixel with its own brightness, and rows with bytes behind.
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void ToRgb_Colours_AreThoseOfYuv420(bool isFullRange)
    {
        const int Seed = 5;
        var random = new Random(Seed);
        byte[] raw = new byte[1 + (3 * 20)];
        random.NextBytes(raw);
        byte[] pixels = new byte[8 * 3 * 3];

        Yuyv.ToRgb(raw, 1, 20, 8, 3, isFullRange, pixels);

        for (int row = 0; row < 3; row++)
        {
            for (int pair = 0; pair < 4; pair++)
            {
                int at = 1 + (20 * row) + (4 * pair);
                byte[] two = new byte[6];
                Yuv420.ToRgb([raw[at], raw[at + 2], raw[at + 1], raw[at + 3]], 0, 2, 1, isFullRange, two);
                Assert.Equal(two, pixels.Skip(((8 * row) + (2 * pair)) * 3).Take(6));
            }
        }
    }

    [Theory]
    [InlineData(0, 8, 3, 2)]
    [InlineData(0, 7, 4, 2)]
    [InlineData(1, 8, 4, 2)]
    public void ToRgb_PictureThatIsNotThere_IsRefused(int offset, int rowBytes, int width, int height)
        => Assert.Throws<ArgumentOutOfRangeException>(
            () => Yuyv.ToRgb(new byte[16], offset, rowBytes, width, height, false, new byte[48]));
}
