using System.Linq;
using Rabit.Uav.AutopilotInterface;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

public class BootClockTests
{
    [Theory]
    [InlineData(0, new uint[] { 1000, 2000, 3000 })]
    [InlineData(1, new uint[] { 100_000, 200 })]
    [InlineData(1, new uint[] { 100_000, 200, 1200, 2200 })]
    [InlineData(2, new uint[] { 100_000, 200, 50_000, 100 })]
    [InlineData(0, new uint[] { 10_000, 7_500, 10_200, 7_600 })]           // messages that overtook each other
    [InlineData(0, new uint[] { uint.MaxValue - 500, 400, 1400 })]          // 49.7 days
    [InlineData(0, new uint[] { uint.MaxValue - 500, 400, uint.MaxValue - 100, 1400 })]
    [InlineData(1, new uint[] { 3_000_000_000, 5_000 })]
    [InlineData(0, new uint[] { 0, 0, 0 })]
    public void HasRebooted_TimesSinceBoot_CountsTheBoots(int boots, uint[] times)
    {
        var clock = new BootClock();
        Assert.Equal(boots, times.Count(clock.HasRebooted));
    }
}
