using System;
using System.IO;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Uav.Communications;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>Keys and clocks in files.</summary>
public sealed class SigningFileTests : IDisposable
{
    // SHA-256 of "abc" (FIPS 180-2, B.1).
    private const string Hex = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

    private readonly string _folder =
        Directory.CreateDirectory(Path.Combine(Path.GetTempPath(), $"rabit-signing-{Guid.NewGuid():N}")).FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Theory]
    [InlineData(Hex)]
    [InlineData(Hex + "\n")]
    [InlineData(Hex + "  -\n")]
    [InlineData("BA7816BF8F01CFEA414140DE5DAE2223B00361A396177A9CB410FF61F20015AD\r\n")]
    public void Key_HexadecimalDigits_IsRead(string content)
    {
        using MavlinkSigningKey key = SigningKeyFile.Read(Write("key", content));
        using MavlinkSigningKey expected = MavlinkSigningKey.FromPassphrase("abc");
        Assert.Equal(BytesOf(expected), BytesOf(key));
    }

    [Fact]
    public void Key_32Bytes_IsRead()
    {
        byte[] secret = Enumerable.Range(1, MavlinkSigningKey.Length).Select(n => (byte)n).ToArray();
        string path = Path.Combine(_folder, "raw");
        File.WriteAllBytes(path, secret);
        using MavlinkSigningKey key = SigningKeyFile.Read(path);
        Assert.Equal(secret, BytesOf(key));
    }

    [Theory]
    [InlineData("", "neither 32 bytes nor 64 hexadecimal digits")]
    [InlineData("a pass phrase", "neither 32 bytes nor 64 hexadecimal digits")]
    [InlineData(Hex + "00", "neither")]
    [InlineData("xa7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad", "neither")]
    [InlineData("0000000000000000000000000000000000000000000000000000000000000000", "zeros")]
    public void Key_None_IsRefusedWithTheFileAndWithoutItsContent(string content, string expected)
    {
        string path = Write("bad", content);
        ArgumentException e = Assert.Throws<ArgumentException>(() => SigningKeyFile.Read(path).Dispose());
        Assert.Contains(path, e.Message, StringComparison.Ordinal);
        Assert.Contains(expected, e.Message, StringComparison.Ordinal);
        Assert.True(content.Length < 2 || !e.ToString().Contains(content));
    }

    [Fact]
    public void Key_NoFileOrFarTooLong_IsRefused()
    {
        Assert.Contains("Signing key", Assert.Throws<ArgumentException>(
            () => SigningKeyFile.Read(Path.Combine(_folder, "none")).Dispose()).Message, StringComparison.Ordinal);
        string path = Write("long", new string('a', 5000));
        Assert.Contains(
            "5000 bytes are no key",
            Assert.Throws<ArgumentException>(() => SigningKeyFile.Read(path).Dispose()).Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void Clock_InFiles_GoesOnAfterARestart()
    {
        string path = Path.Combine(_folder, "clock");
        var clock = new MavlinkSigningClock(new FileTimestampStore(path));
        clock.Advance(new DateTime(2026, 1, 1, 0, 0, 0, DateTimeKind.Utc), TimeSpan.Zero);
        long before = clock.Timestamp;
        Assert.True(clock.Save());
        var next = new MavlinkSigningClock(new FileTimestampStore(path));
        Assert.InRange(next.Timestamp, before, before + 1);
        Assert.True(File.Exists(path + ".0") && File.Exists(path + ".1"));
    }

    [Fact]
    public void Clock_FilesThatCannotBeWritten_IsReportedAndNotThrown()
    {
        var store = new FileTimestampStore(Path.Combine(_folder, "no such folder", "clock"));
        Assert.Equal(0, store.Read(0, new byte[12]));
        Assert.False(store.Write(0, new byte[12]));
        Assert.Throws<ArgumentException>(() => new FileTimestampStore(""));
    }

    private string Write(string name, string content)
    {
        string path = Path.Combine(_folder, name);
        File.WriteAllText(path, content);
        return path;
    }

    private static byte[] BytesOf(MavlinkSigningKey key)
    {
        var bytes = new byte[MavlinkSigningKey.Length];
        key.CopyTo(bytes);
        return bytes;
    }
}
