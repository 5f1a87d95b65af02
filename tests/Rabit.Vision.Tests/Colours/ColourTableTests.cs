using System;
using Xunit;

namespace Rabit.Vision.Tests.Colours;

public sealed class ColourTableTests
{
    private static readonly ColourRange Red = new(205, 28, 32);
    private static readonly ColourRange Orange = new(242, 112, 18);

    [Fact]
    public void ClassOf_SelectedRanges_AreOneMoreThanTheirIndex()
    {
        var table = new ColourTable([Red, Orange]);
        Assert.Equal((0, 0), (table.ClassOf(205, 28, 32), table.ClassOf(242, 112, 18)));
        table.Select(0b11);
        Assert.Equal((1, 2, 0), (table.ClassOf(205, 28, 32), table.ClassOf(242, 112, 18), table.ClassOf(86, 112, 56)));
    }

    [Fact]
    public void ClassOf_ColourCloserToARangeThatIsNotSelected_IsNone()
    {
        var table = new ColourTable([Red, Orange]);
        table.Select(0b01);
        Assert.Equal((1, 0), (table.ClassOf(205, 28, 32), table.ClassOf(242, 112, 18)));
    }

    [Fact]
    public void Constructor_MoreThan32Ranges_IsRefused()
    {
        var ranges = new ColourRange[33];
        Assert.Throws<ArgumentException>(() => new ColourTable(ranges));
    }

    [Theory]
    [InlineData(0.6)]
    [InlineData(1)]
    [InlineData(1.2)]
    public void Contains_NominalColourInOtherLight_IsTrue(double light)
    {
        Assert.True(Red.Contains(205 * light, 28 * light, 32 * light));
        Assert.Equal(1, Red.Closeness(205 * light, 28 * light, 32 * light), 6);
        Assert.False(Orange.Contains(205 * light, 28 * light, 32 * light));
    }
}
