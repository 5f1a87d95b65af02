using System;
using System.Linq;
using System.Text;
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
    [InlineData("10 \u20AC, \U0001F681")]
    [InlineData("\U0001F681\U0001F681\U0001F681\U0001F681")]
    public void Constructor_TextThatFits_ReadsTheSame(string text)
    {
        var value = new Text16(text);
        Assert.Equal(text, value.ToString());
        Assert.Equal(Encoding.UTF8.GetByteCount(text), value.Length);
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
    [InlineData("\u20AC\u20AC\u20AC\u20AC\u20AC\u20AC", "has 18 bytes as UTF-8, Text16 holds 16")]
    public void Constructor_CharacterThatATextCannotHold_IsRefused(string text, string reason) =>
        Assert.Contains(reason, Assert.Throws<ArgumentException>(() => new Text16(text)).Message);

    // Not as data of a theory, which the runner could not write down.
    [Fact]
    public void Constructor_HalfOfASurrogatePair_IsRefused()
    {
        Assert.Contains(
            "character 2 is U+D83D", Assert.Throws<ArgumentException>(() => new Text16("5 \uD83D")).Message);
        Assert.Contains(
            "character 0 is U+DE81", Assert.Throws<ArgumentException>(() => new Text16("\uDE81\uD83D")).Message);
    }

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

    [Theory]
    [InlineData("68C3A96C6C6F", "h\u00E9llo")]
    [InlineData("68E96C6C6F", "h\u00E9llo")]
    [InlineData("C3", "\u00C3")]
    [InlineData("E282", "\u00E2\u0082")]
    [InlineData("C0AF", "\u00C0\u00AF")]
    [InlineData("EDA080", "\u00ED\u00A0\u0080")]
    [InlineData("F4908080", "\u00F4\u0090\u0080\u0080")]
    [InlineData("F09F9A81C3", "\U0001F681\u00C3")]
    public void ToString_BytesThatAreNoUtf8_AreCharactersOfThatNumber(string hex, string text)
    {
        var bytes = new byte[hex.Length / 2];
        for (int i = 0; i < bytes.Length; i++)
            bytes[i] = Convert.ToByte(hex.Substring(2 * i, 2), 16);
        var value = new Text16(bytes);
        Assert.Equal(text, value.ToString());
        Assert.True(value.TextEquals(text));
        Assert.False(value.TextEquals(text + "\u00E9"));
    }

    [Fact]
    public void ToString_EveryByte_IsTheCharacterOfThatNumber()
    {
        byte[] bytes = Enumerable.Range(1, 100).Select(number => (byte)(number + 155)).ToArray();
        Assert.Equal(new string(bytes.Select(value => (char)value).ToArray()), new Text100(bytes).ToString());
    }
}
