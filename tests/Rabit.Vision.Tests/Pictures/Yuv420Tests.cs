using System;
using System.Linq;
using Xunit;

namespace Rabit.Vision.Tests.Pictures;

public sealed class Yuv420Tests
{
    // Black, white, grey, red, green and blue of ITU-R BT.601.
    [Theory]
    [InlineData(16, 128, 128, false, 0, 0, 0)]
    [InlineData(235, 128, 128, false, 255, 255, 255)]
    [InlineData(126, 128, 128, false, 128, 128, 128)]
    [InlineData(81, 90, 240, false, 254, 0, 0)]
    [InlineData(145, 54, 34, false, 0, 255, 1)]
    [InlineData(41, 240, 110, false, 0, 0, 255)]
    [InlineData(76, 85, 255, true, 254, 0, 0)]
    [InlineData(29, 255, 107, true, 0, 0, 254)]
    [InlineData(77, 128, 128, true, 77, 77, 77)]
    public void ToRgb_Colours_AreThoseOfTheStandard(
        byte y, byte u, byte v, bool isFullRange, byte red, byte green, byte blue)
    {
        byte[] raw = [9, .. Enumerable.Repeat(y, 15), .. Enumerable.Repeat(u, 6), .. Enumerable.Repeat(v, 6)];
        byte[] pixels = new byte[5 * 3 * 3];

        Yuv420.ToRgb(raw, 1, 5, 3, isFullRange, pixels);

        for (int at = 0; at < pixels.Length; at += 3)
        {
            Assert.InRange(pixels[at], red - 1, red + 1);
            Assert.InRange(pixels[at + 1], green - 1, green + 1);
            Assert.InRange(pixels[at + 2], blue - 1, blue + 1);
        }
    }

    [Fact]
    public void ToRgb_TooFewBytes_IsRefused()
        => Assert.Throws<ArgumentOutOfRangeException>(
            () => Yuv420.ToRgb(new byte[Yuv420.BytesOf(4, 4)], 1, 4, 4, false, new byte[48]));
}
