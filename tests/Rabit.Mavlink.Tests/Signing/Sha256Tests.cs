using System;
using System.Linq;
using System.Text;
using Rabit.Mavlink.Signing;
using Xunit;

namespace Rabit.Mavlink.Tests.Signing;

/// <summary>
/// The published examples of SHA-256 (NIST, FIPS 180-4 "Examples with intermediate values" and CAVP), and the runtime's
/// own beside ours.
/// </summary>
public class Sha256Tests
{
    [Theory]
    [InlineData("", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855")]
    [InlineData("abc", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad")]
    [InlineData("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq",
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1")]
    [InlineData(
        "abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmnhijklmnoijklmnopjklmnopqklmnopqrlmnopqrsmnopqrstnopqrstu",
        "cf5b16a778af8380036ce59e7b0492370b249b11e8f07a51afac45037afee9d1")]
    public void Hash_PublishedText_GivesThePublishedHash(string text, string expected)
        => Assert.Equal(expected, Hash(Encoding.ASCII.GetBytes(text)));

    [Theory]
    [InlineData("d3", "28969cdfa74a12c82f3bad960b0b000aca2ac329deea5c2328ebc6f2ba9802c1")]
    [InlineData("11af", "5ca7133fa735326081558ac312c620eeca9970d1e70a4b95533d956f072d1f98")]
    [InlineData("b4190e", "dff2e73091f6c05e528896c4c831b9448653dc2ff043528f6769437bc7b975c2")]
    [InlineData("74ba2521", "b16aa56be3880d18cd41e68384cf1ec8c17680c45a02b1575dc1518923ae8b0e")]
    public void Hash_PublishedBytes_GivesThePublishedHash(string hex, string expected)
        => Assert.Equal(expected, Hash(TestData.FromHex(hex)));

    [Fact]
    public void Hash_AMillionTimesA_GivesThePublishedHash() => Assert.Equal(
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0",
        Hash(Enumerable.Repeat((byte)'a', 1_000_000).ToArray()));

    [Fact]
    public void Hash_EveryLengthToSixBlocks_IsTheRuntimesOwn()
    {
        var random = new Random(1);
        using var runtimes = System.Security.Cryptography.SHA256.Create();
        for (int length = 0; length <= 384; length++)
        {
            var bytes = new byte[length];
            random.NextBytes(bytes);
#pragma warning disable CA1850 // The one-shot method is not on Mono.
            Assert.Equal(TestData.ToHex(runtimes.ComputeHash(bytes), 32), Hash(bytes));
#pragma warning restore CA1850
        }
    }

    [Fact]
    public void HashFirst48_AnyBytes_IsTheStartOfTheHash()
    {
        var buffer = new byte[64];
        buffer[0] = (byte)'a';
        buffer[1] = (byte)'b';
        buffer[2] = (byte)'c';

        // ba 78 16 bf 8f 01, the first byte lowest.
        Assert.Equal(0x018FBF1678BAUL, Sha256.HashFirst48(buffer, 3));
    }

    private static string Hash(byte[] message)
    {
        // What lies behind the message must not matter.
        byte[] buffer = Enumerable.Repeat((byte)0xA5, Sha256.PaddedLength(message.Length)).ToArray();
        message.CopyTo(buffer, 0);
        var hash = new byte[Sha256.HashLength];
        Sha256.Hash(buffer, message.Length, hash);
        return TestData.ToHex(hash, hash.Length);
    }
}
