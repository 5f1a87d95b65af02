using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Tests.Golden;
using Xunit;

namespace Rabit.Mavlink.Tests.Signing;

public class MavlinkSigningKeyTests
{
    [Theory]
    [InlineData(0)]
    [InlineData(31)]
    [InlineData(33)]
    public void New_WrongLength_IsRefused(int length)
    {
        byte[] secret = Enumerable.Repeat((byte)0xAB, length).ToArray();

        Exception exception = Assert.Throws<ArgumentException>(() => new MavlinkSigningKey(secret));
        Assert.Contains($"{length} were given", exception.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void New_Zeros_IsRefused() => Assert.Throws<ArgumentException>(() => new MavlinkSigningKey(new byte[32]));

    [Fact]
    public void New_Copies_TheCallerMayEraseItsOwn()
    {
        byte[] secret = Keys.Bytes(1);
        using var key = new MavlinkSigningKey(secret);
        Array.Clear(secret, 0, secret.Length);

        Assert.True(key.Matches(Keys.Signed(Keys.Noon)));
    }

    [Fact]
    public void FromPassphrase_Text_IsSha256OfItsUtf8()
    {
        var bytes = new byte[32];
        using MavlinkSigningKey key = MavlinkSigningKey.FromPassphrase("abc");
        key.CopyTo(bytes);

        Assert.Equal("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad", TestData.ToHex(bytes, 32));
    }

    [Fact]
    public void FromPassphrase_Nothing_IsRefused()
        => Assert.Throws<ArgumentException>(() => MavlinkSigningKey.FromPassphrase(""));

    [Fact]
    public void Matches_EveryGoldenLine_IsTrueForItsKeyAndNoOther()
    {
        using MavlinkSigningKey other = Keys.Of(77);
        foreach (GoldenVector vector in GoldenVectors.All)
        {
            using MavlinkSigningKey key = Keys.Of(vector.Signing.GetProperty("key"));
            MavlinkFrame frame = Framing.Wire.Single(vector.V2Signed, out _);

            Assert.True(key.Matches(frame), vector.ToString());
            Assert.False(other.Matches(frame), vector.ToString());
            Assert.Equal(vector.Signing.GetProperty("link_id").GetByte(), frame.SignatureLinkId);
            Assert.Equal(vector.Signing.GetProperty("timestamp").GetInt64(), frame.SignatureTimestamp);
        }
    }

    [Fact]
    public void Matches_AnyBitChanged_IsFalse()
    {
        byte[] wire = Framing.Wire.Bytes(Keys.Signed(Keys.Noon, linkId: 3));
        for (int bit = 0; bit < wire.Length * 8; bit++)
        {
            // The length, and the flag that there is a signature, say where the signature is: such bytes are another
            // frame, or none.
            if (bit / 8 is 0 or 1 || bit == 16)
                continue;
            byte[] changed = (byte[])wire.Clone();
            changed[bit / 8] ^= (byte)(1 << (bit % 8));
            MavlinkFrame.FromWire(changed, out MavlinkFrame frame);
            Assert.False(Keys.One.Matches(frame), $"bit {bit}");
        }
    }

    [Fact]
    public void Matches_Unsigned_IsFalse() => Assert.False(Keys.One.Matches(Keys.Unsigned()));

    [Fact]
    public void CreateSetup_ForOneSystem_CarriesTheKey()
    {
        SetupSigning setup = Keys.One.CreateSetup(1, 0, Keys.Noon);
        var carried = new byte[32];
        setup.SecretKey.CopyTo(carried);

        Assert.Equal(Keys.Bytes(1), carried);
        Assert.Equal(
            ((byte)1, (byte)0, (ulong)Keys.Noon), (setup.TargetSystem, setup.TargetComponent, setup.InitialTimestamp));
    }

    [Fact]
    public void CreateSetup_Broadcast_IsRefused() =>
        Assert.Throws<ArgumentOutOfRangeException>(() => Keys.One.CreateSetup(0, 0, Keys.Noon));

    [Fact]
    public void Dispose_ErasesTheKey_AndNothingWorksAnyMore()
    {
        MavlinkSigningKey key = Keys.Of(5);
        MavlinkFrame signed = Keys.Signed(Keys.Noon, key);
        var signer = new MavlinkSigner(key, 0, Keys.ClockAt(Keys.Noon));
        key.Dispose();

        Assert.Throws<ObjectDisposedException>(() => key.Matches(signed));
        Assert.Throws<ObjectDisposedException>(() => key.CopyTo(new byte[32]));
        Assert.Throws<ObjectDisposedException>(() => key.CreateSetup(1, 1, 0));
        Assert.Throws<ObjectDisposedException>(() => signer.Sign(Keys.Unsigned(), Heartbeat.MavlinkCrcExtra));
        var secret = (byte[])typeof(MavlinkSigningKey).GetField(
            "_secret", BindingFlags.NonPublic | BindingFlags.Instance)!.GetValue(
            key)!;
        Assert.All(secret, value => Assert.Equal(0, value));
    }

    [Fact]
    public void PublicMembers_OfAllThatHasAKey_DiscloseNothingOfIt()
    {
        var clock = Keys.ClockAt(Keys.Noon);
        var sender = new MavlinkSender(1, 191) { Signer = new MavlinkSigner(Keys.One, 0, clock) };
        object[] holders = [Keys.One, sender, sender.Signer, new MavlinkVerifier(Keys.One, clock), clock];

        foreach (object holder in holders)
        {
            Assert.DoesNotContain(holder.GetType().GetFields(), field => field.IsPublic && !field.IsLiteral);
            foreach (string text in TextsOf(holder))
                AssertDisclosesNothing(text);
        }
    }

    [Fact]
    public void Exceptions_AboutKeys_DiscloseNothingOfThem()
    {
        byte[] tooLong = [.. Keys.Bytes(1), 99];
        AssertDisclosesNothing(Assert.Throws<ArgumentException>(() => new MavlinkSigningKey(tooLong)).ToString());
        AssertDisclosesNothing(Assert.Throws<ArgumentException>(() => Keys.One.CopyTo(new byte[31])).ToString());
        AssertDisclosesNothing(
            Assert.Throws<ArgumentOutOfRangeException>(() => Keys.One.CreateSetup(0, 0, 0)).ToString());
    }

    private static IEnumerable<string> TextsOf(object holder) => holder.GetType()
        .GetProperties()
        .Select(property => property.GetValue(holder)?.ToString() ?? "")
        .Append(holder.ToString()!);

    // No three bytes of the key in a row, in hexadecimal, Base64 or decimal.
    private static void AssertDisclosesNothing(string text)
    {
        byte[] secret = Keys.Bytes(1);
        for (int start = 0; start + 3 <= secret.Length; start++)
        {
            byte[] part = secret.Skip(start).Take(3).ToArray();
            Assert.DoesNotContain(TestData.ToHex(part, 3), text, StringComparison.OrdinalIgnoreCase);
            Assert.DoesNotContain(Convert.ToBase64String(part), text, StringComparison.Ordinal);
            Assert.DoesNotContain(string.Join(", ", part), text, StringComparison.Ordinal);
        }
    }
}
