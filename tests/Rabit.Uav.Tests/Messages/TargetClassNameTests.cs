using System;
using System.Text;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Messages;

public sealed class TargetClassNameTests
{
    [Theory]
    [InlineData("r")]
    [InlineData("red")]
    [InlineData("eightish")]
    [InlineData("nine long")]
    [InlineData("sixteen letters!")]
    public void RoundTrip_AnyLength_IsTheSame(string text)
    {
        var name = new TargetClassName(text);
        var bytes = new byte[TargetClassName.MaxLength];
        Assert.Equal((text, text.Length, false), (name.ToString(), name.Length, name.IsNone));
        Assert.Equal(text, Encoding.ASCII.GetString(bytes, 0, name.CopyTo(bytes)));
        Assert.True(TargetClassName.TryRead(bytes.AsSpan(0, text.Length), out TargetClassName back));
        Assert.True(back == name && back.Equals((object)name) && back.GetHashCode() == name.GetHashCode());
    }

    [Theory]
    [InlineData(null)]
    [InlineData("")]
    [InlineData(" red")]
    [InlineData("red ")]
    [InlineData("r\u00e9d")]
    [InlineData("r\ud800d")]
    [InlineData("a\tb")]
    [InlineData("a\u007f")]
    [InlineData("seventeen letters")]
    public void TryParse_NotANameOfAClass_IsRefused(string? text)
    {
        Assert.False(TargetClassName.TryParse(text, out TargetClassName name));
        Assert.True(name.IsNone);
        Assert.ThrowsAny<ArgumentException>(() => new TargetClassName(text!));
    }

    [Fact]
    public void Equals_OtherNameOrCase_IsFalse()
    {
        Assert.True(new TargetClassName("red") != new TargetClassName("Red"));
        Assert.NotEqual(new TargetClassName("sixteen letters!"), new TargetClassName("sixteen letters?"));
        Assert.Equal(string.Empty, TargetClassName.None.ToString());
    }

    [Fact]
    public void CopyTo_NoRoom_IsRefused()
        => Assert.Throws<ArgumentException>(() => new TargetClassName("red").CopyTo(new byte[2]));
}
