using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using Rabit.Mavlink.Tests.Messages;
using Rabit.Mavlink.Tests.Signing;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Mavlink.Tests.Framing;

/// <summary>
/// Whatever comes in, the whole way: framing in both modes, signatures, decoding, routing, log reading. No exception,
/// bounded memory and work, an end. Eleven million bytes in every run; as many more as RABIT_FUZZ_MEGABYTES says (200
/// if it says nothing) in the longer tests.
/// </summary>
public class FuzzTests(ITestOutputHelper output)
{
    private const int BytesPerSeed = 1_100_000;
    private const int FirstSeed = 1000;

    private static readonly Dictionary<int, Decode> Decoders = MessageTypes.ById.ToDictionary(
        pair => pair.Key,
        pair => (Decode)Delegate.CreateDelegate(
            typeof(Decode),
            typeof(FuzzTests).GetMethod(nameof(DecodeAndEncode), BindingFlags.NonPublic | BindingFlags.Static)!
                .MakeGenericMethod(pair.Value)));

    private readonly byte[] _wire = new byte[MavlinkFrame.MaxWireLength];

    private delegate int Decode(in MavlinkFrame frame, byte[] buffer);

    public static TheoryData<int> Seeds() => new(Enumerable.Range(FirstSeed, 10));

    [Theory]
    [MemberData(nameof(Seeds))]
    public void Everything_MutatedBytes_ComesToAnEndWithoutAFault(int seed) => Run(seed);

    [Fact]
    [Trait("Category", "Long")]
    public void Everything_ManyMutatedBytes_ComesToAnEndWithoutAFault()
    {
        string? megabytes = Environment.GetEnvironmentVariable("RABIT_FUZZ_MEGABYTES");
        long wanted = 1_000_000L * (string.IsNullOrEmpty(megabytes)
            ? 200
            : int.Parse(megabytes, System.Globalization.CultureInfo.InvariantCulture));
        int seed = FirstSeed + 10;
        for (long done = 0; done < wanted; done += BytesPerSeed)
            Run(seed++);
    }

    private void Run(int seed)
    {
        output.WriteLine($"seed {seed}");
        byte[] bytes = FuzzBytes.Make(seed, BytesPerSeed);
        long inFrames = Read(bytes, seed, MavlinkInvalidFramePolicy.NextByte, out MavlinkReaderCounters counters);
        Read(bytes, seed, MavlinkInvalidFramePolicy.SkipFrame, out MavlinkReaderCounters skipping);
        Assert.True(counters.ChecksumBytes <= 20L * bytes.Length, $"{counters.ChecksumBytes}");
        Assert.True(skipping.ChecksumBytes <= bytes.Length, $"{skipping.ChecksumBytes}");
        Assert.True(counters.Frames >= skipping.Frames, $"{counters.Frames} {skipping.Frames}");
        Assert.True(inFrames > bytes.Length / 10, $"{inFrames}");
        ReadLog(bytes);
    }

    // Returns how many bytes were frames: with the bytes skipped and dropped they are all.
    private long Read(byte[] bytes, int seed, MavlinkInvalidFramePolicy policy, out MavlinkReaderCounters counters)
    {
        var random = new Random(seed);
        var reader = new MavlinkFrameReader(MavlinkDialect.All, policy);
        var verifier = new MavlinkVerifier(Keys.One, Keys.ClockAt(Keys.Noon), maxStreams: 4);
        var router = new MavlinkRouter(1, 191, maxSources: 16);
        router.SetLink(0, MavlinkLinkRules.Live);
        router.SetLink(1, MavlinkLinkRules.Live);
        long inFrames = 0;
        for (int start = 0; start < bytes.Length;)
        {
            int count = Math.Min(random.Next(1, 5000), bytes.Length - start);
            ReadOnlySpan<byte> rest = bytes.AsSpan(start, count);
            while (reader.TryRead(ref rest, out MavlinkFrame frame, out MavlinkFrameInfo info))
                inFrames += Use(frame, info, bytes, verifier, router);
            Assert.True(rest.IsEmpty);
            Assert.InRange(reader.PendingBytes, 0, 2 * MavlinkFrame.MaxWireLength);
            start += count;
        }

        while (reader.TryFlush(out MavlinkFrame frame, out MavlinkFrameInfo info))
            inFrames += Use(frame, info, bytes, verifier, router);
        counters = reader.Counters;
        Assert.Equal((bytes.Length, 0), (counters.Bytes, reader.PendingBytes));
        Assert.InRange(
            bytes.Length - inFrames - counters.SkippedBytes, 0,
            counters.IncompatibleFrames * MavlinkFrame.MaxWireLength);
        return inFrames;
    }

    private int Use(
        in MavlinkFrame frame, in MavlinkFrameInfo info, byte[] bytes, MavlinkVerifier verifier, MavlinkRouter router)
    {
        int length = frame.WriteTo(_wire);
        Assert.True(bytes.AsSpan((int)info.StreamOffset, length).SequenceEqual(_wire.AsSpan(0, length)));
        verifier.Verify(frame);
        router.Route(0, frame, info);
        if (info.IsChecked)
            Assert.InRange(Decoders[frame.MessageId](frame, _wire), 1, MavlinkFrame.MaxWireLength);
        return length;
    }

    private static int DecodeAndEncode<T>(in MavlinkFrame frame, byte[] buffer)
        where T : struct, IMavlinkMessage
    {
        frame.TryDecode(out T message);
        return MavlinkFrame.Create(message, 1, 1, 0).WriteTo(buffer);
    }

    private static void ReadLog(byte[] bytes)
    {
        var log = new TlogReader(new MemoryStream(bytes), MavlinkDialect.All);
        while (log.TryRead(out _, out _)) { }
        Assert.Equal(bytes.Length, log.Position);
    }
}
