using System;
using System.Linq;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Messages;

public class TextTests
{
    [Theory]
    [InlineData("")]
    [InlineData("SYSID_THISMAV")]
    [InlineData("exactly sixteen.")]
    [InlineData("Grüße \u00FF")]
    public void Constructor_TextThatFits_ReadsTheSame(string text)
    {
        var value = new Text16(text);
        Assert.Equal(text, value.ToString());
        Assert.Equal(text.Length, value.Length);
        Assert.Equal(16, value.Capacity);
        Assert.True(value.TextEquals(text));
        Assert.False(value.TextEquals(text + "x"));
    }

    [Fact]
    public void Constructor_TextTooLong_IsRefusedWithBothNumbers() =>
        Assert.Contains(
            "has 17 characters, Text16 holds 16",
            Assert.Throws<ArgumentException>(() => new Text16("seventeen letters")).Message);

    [Theory]
    [InlineData("a\0b", "character 1 is U+0000")]
    [InlineData("5 \u20AC", "character 2 is U+20AC")]
    public void Constructor_CharacterThatAByteCannotHold_IsRefused(string text, string reason) =>
        Assert.Contains(reason, Assert.Throws<ArgumentException>(() => new Text16(text)).Message);

    [Fact]
    public void Constructor_Null_IsRefused() => Assert.Throws<ArgumentNullException>(() => new Text16((string)null!));

    [Fact]
    public void Decode_BytesAfterTheFirstZero_AreKeptButNotRead()
    {
        var payload = new byte[ParamRequestRead.MavlinkMaxLength];
        "AB\0CD".Select(character => (byte)character).ToArray().CopyTo(payload, 4);
        var message = default(ParamRequestRead);
        message.Decode(payload);
        Assert.Equal("AB", message.ParamId.ToString());
        Assert.Equal((byte)'C', message.ParamId[3]);
        Assert.False(message.ParamId == new Text16("AB"));
        Assert.True(message.ParamId.TextEquals("AB"));
        var encoded = new byte[payload.Length];
        message.Encode(encoded);
        Assert.Equal(payload, encoded);
    }

    [Fact]
    public void ToString_EveryByte_IsTheCharacterOfThatNumber()
    {
        byte[] bytes = Enumerable.Range(1, 100).Select(number => (byte)(number + 155)).ToArray();
        Assert.Equal(new string(bytes.Select(value => (char)value).ToArray()), new Text100(bytes).ToString());
    }
}
