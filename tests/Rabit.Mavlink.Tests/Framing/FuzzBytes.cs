using System;
using System.Collections.Generic;
using Rabit.Mavlink.Tests.Signing;

namespace Rabit.Mavlink.Tests.Framing;

/// <summary>Bytes that a link could bring on its worst days, the same for the same seed on the same runtime.</summary>
internal static class FuzzBytes
{
    private static readonly byte[] SignedStream = MakeSigned();

    /// <summary>
    /// Pieces of recorded flights, of damaged streams and of signed frames with bytes changed, cut out and put in;
    /// every tenth piece is noise.
    /// </summary>
    public static byte[] Make(int seed, int length)
    {
        var random = new Random(seed);
        byte[][] sources = [TestData.Bytes("ardupilot-flight.tlog"), TestData.Bytes("px4-flight.tlog"),
            TestData.Bytes("d-signed.bin"), TestData.Bytes("c-garbage-part.bin"), SignedStream];
        byte[] source = sources[seed % sources.Length];
        var bytes = new byte[length];
        int filled = 0;
        while (filled < length)
        {
            int count = Math.Min(random.Next(1, 600), length - filled);
            Span<byte> piece = bytes.AsSpan(filled, count);
            if (random.Next(10) == 0)
                Noise(piece, random);
            else
                source.AsSpan(random.Next(source.Length - count), count).CopyTo(piece);
            for (int changes = random.Next(4); changes > 0; changes--)
                piece[random.Next(count)] = Likely(random);
            filled += count;
        }

        return bytes;
    }

    /// <summary>Bytes that mean something in a header come more often.</summary>
    public static byte Likely(Random random) => random.Next(4) switch
    {
        0 => 0xFD,
        1 => 0xFE,
        2 => (byte)random.Next(3),
        _ => (byte)random.Next(256),
    };

    private static void Noise(Span<byte> piece, Random random)
    {
        bool isLikely = random.Next(2) == 0;
        for (int index = 0; index < piece.Length; index++)
            piece[index] = isLikely ? Likely(random) : (byte)random.Next(256);
    }

    private static byte[] MakeSigned()
    {
        var signer = new MavlinkSigner(Keys.One, 0, Keys.ClockAt(Keys.Noon));
        var bytes = new List<byte>();
        var reader = new MavlinkFrameReader(MavlinkDialect.All);
        ReadOnlySpan<byte> flight = TestData.Bytes("px4-flight.tlog").AsSpan(0, 100_000);
        while (reader.TryRead(ref flight, out MavlinkFrame frame, out MavlinkFrameInfo info))
        {
            if (info.IsChecked && frame.Version == MavlinkVersion.V2)
                bytes.AddRange(Wire.Bytes(signer.Sign(frame, info.Message.CrcExtra)));
        }

        return [.. bytes];
    }
}
