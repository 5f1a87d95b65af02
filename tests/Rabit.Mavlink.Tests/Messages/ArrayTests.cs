using System;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Messages;

public class ArrayTests
{
    [Fact]
    public void Constructor_FewerElements_LeavesTheRestZero()
    {
        var array = new UInt16Array5([1, 2, 3]);
        Assert.Equal(5, array.Length);
        var copy = new ushort[6];
        array.CopyTo(copy);
        Assert.Equal(new ushort[] { 1, 2, 3, 0, 0, 0 }, copy);
    }

    [Fact]
    public void Constructor_MoreElements_IsRefusedWithBothNumbers()
    {
        string message = Assert.Throws<ArgumentException>(() => new UInt16Array5(new ushort[6])).Message;
        Assert.Contains("UInt16Array5 holds 5 elements, 6 were given", message);
    }

    [Fact]
    public void Indexer_EveryElement_IsItsOwn()
    {
        var array = default(SByteArray32);
        for (int i = 0; i < array.Length; i++)
            array[i] = (sbyte)(i - 16);
        for (int i = 0; i < array.Length; i++)
            Assert.Equal(i - 16, array[i]);
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(4)]
    [InlineData(int.MinValue)]
    [InlineData(int.MaxValue)]
    public void Indexer_Outside_IsRefused(int index)
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => default(FloatArray4)[index]);
        Assert.Throws<ArgumentOutOfRangeException>(() =>
        {
            var array = default(FloatArray4);
            array[index] = 1;
        });
    }

    [Fact]
    public void CopyTo_ShortDestination_IsRefused() =>
        Assert.Contains(
            "room for 3", Assert.Throws<ArgumentException>(() => default(FloatArray4).CopyTo(new float[3])).Message);

    [Fact]
    public void Copy_OfAMessage_IsIndependent()
    {
        var first = new ActuatorControlTarget { Controls = new FloatArray8([1, 2, 3, 4, 5, 6, 7, 8]) };
        ActuatorControlTarget second = first;
        FloatArray8 controls = second.Controls;
        controls[7] = 80;
        second.Controls = controls;
        Assert.Equal(8, first.Controls[7]);
        Assert.Equal(80, second.Controls[7]);
        Assert.Equal(7, second.Controls[6]);
    }

    [Fact]
    public void Equals_SameBits_AreEqualAndHashAlike()
    {
        var left = new ByteArray249([1, 2, 3]);
        var right = new ByteArray249([1, 2, 3]);
        Assert.True(left == right);
        Assert.True(left.Equals((object)right));
        Assert.Equal(left.GetHashCode(), right.GetHashCode());
        right[248] = 1;
        Assert.True(left != right);
        Assert.NotEqual(left.GetHashCode(), right.GetHashCode());
        Assert.True(new FloatArray4([float.NaN]) == new FloatArray4([float.NaN]));
        Assert.True(new FloatArray4([0f]) != new FloatArray4([-0f]));
    }

    [Fact]
    public void ToString_Elements_StandBetweenBrackets()
        => Assert.Equal("[1.5, -2, 0, 0]", new FloatArray4([1.5f, -2]).ToString());

    [Fact]
    public void CopySwapped_BigEndianMemory_TurnsEveryElementRound()
    {
        byte[] wire = [1, 2, 3, 4, 5, 6, 7, 8];
        var memory = new byte[8];
        MavlinkArray.CopySwapped(ref memory[0], ref wire[0], 8, 4);
        Assert.Equal(new byte[] { 4, 3, 2, 1, 8, 7, 6, 5 }, memory);
        MavlinkArray.CopySwapped(ref memory[0], ref wire[0], 8, 1);
        Assert.Equal(wire, memory);
    }
}
