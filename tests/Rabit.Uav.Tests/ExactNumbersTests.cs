using System;
using Xunit;

namespace Rabit.Uav.Tests;

/// <summary>
/// Durations as numbers and back, sines and cosines: to the bit the same on each runtime, by one number that both are
/// compared with. (The sines are those of glibc on x64.)
/// </summary>
public sealed class ExactNumbersTests
{
    private const int Many = 100_000;
    private const long MaxTicks = 36_000_000_000; // an hour

    [Fact]
    public void Numbers_OfManyDurations_AreTheSameToTheBitOnEachRuntime()
    {
        ulong hash = 14695981039346656037;
        ulong state = 1;
        for (int i = 0; i < Many; i++)
        {
            double part = Next(ref state) / (double)(1L << 53);
            var time = TimeSpan.FromTicks((long)(part * MaxTicks));
            Add(ref hash, BitConverter.DoubleToInt64Bits(time.ExactSeconds));
            Add(ref hash, BitConverter.DoubleToInt64Bits(time.ExactMilliseconds));
            Add(ref hash, TimeSpan.OfSeconds(part * 1000).Ticks);
            Add(ref hash, TimeSpan.OfMilliseconds(-part).Ticks);
        }

        Assert.Equal(9756015585301093821UL, hash);
    }

#if NET
    [Fact]
    public void Numbers_OfManyDurations_AreThoseOfDotNet()
    {
        ulong state = 2;
        for (int i = 0; i < Many; i++)
        {
            double part = Next(ref state) / (double)(1L << 53);
            var time = TimeSpan.FromTicks((long)(part * MaxTicks));
            Assert.Equal(time.TotalSeconds, time.ExactSeconds);
            Assert.Equal(time.TotalMilliseconds, time.ExactMilliseconds);
            Assert.Equal(TimeSpan.FromSeconds(part * 1000), TimeSpan.OfSeconds(part * 1000));
            Assert.Equal(TimeSpan.FromMilliseconds(-part), TimeSpan.OfMilliseconds(-part));
        }

        Assert.Equal(TimeSpan.FromSeconds(TimeSpan.MaxValue.TotalSeconds), TimeSpan.OfSeconds(922337203685.47754));
    }
#endif

    [Theory]
    [InlineData(1e12)]
    [InlineData(-1e12)]
    [InlineData(double.PositiveInfinity)]
    public void OfSeconds_TooLong_Throws(double seconds)
        => Assert.Throws<OverflowException>(() => TimeSpan.OfSeconds(seconds));

    [Fact]
    public void OfSeconds_NoNumber_Throws() => Assert.Throws<ArgumentException>(() => TimeSpan.OfSeconds(double.NaN));

    [LinuxX64Fact]
    public void SineAndCosine_OfManyAngles_AreTheSameToTheBitOnEachRuntime()
    {
        ulong hash = 14695981039346656037;
        ulong state = 3;
        for (int i = 0; i < Many; i++)
        {
            double angle = 20 * ((Next(ref state) / (double)(1L << 53)) - 0.5);
            Add(ref hash, BitConverter.DoubleToInt64Bits(Trig.Sin(angle)));
            Add(ref hash, BitConverter.DoubleToInt64Bits(Trig.Cos(angle)));
        }

        Assert.Equal(9161882341809934756UL, hash);
    }

    private static ulong Next(ref ulong state)
    {
        state = unchecked((state * 6364136223846793005) + 1442695040888963407);
        return state >> 11;
    }

    private static void Add(ref ulong hash, long value) => hash = unchecked((hash ^ (ulong)value) * 1099511628211);
}
