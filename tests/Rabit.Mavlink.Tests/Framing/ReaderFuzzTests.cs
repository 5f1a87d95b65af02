using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Mavlink.Tests.Framing;

/// <summary>
/// Random and mutated bytes, by fixed seeds: no exception, bounded memory and work, and the same frames as the plain
/// rule finds.
/// </summary>
public class ReaderFuzzTests(ITestOutputHelper output)
{
    private const int BytesPerSeed = 100_000;

    public static TheoryData<int> Seeds() => new(Enumerable.Range(1, 20));

    [Theory]
    [MemberData(nameof(Seeds))]
    public void TryRead_MutatedBytes_FindsWhatThePlainRuleFinds(int seed)
    {
        output.WriteLine($"seed {seed}");
        byte[] bytes = FuzzBytes.Make(seed, BytesPerSeed);
        var whole = new MavlinkFrameReader(MavlinkDialect.All);
        List<FoundFrame> found = FrameCollector.Read(bytes, bytes.Length, whole);
        List<FoundFrame> inChunks = FrameCollector.Read(
            bytes, 1 + (seed * 7), new MavlinkFrameReader(MavlinkDialect.All));

        Assert.Equal(
            found.Select(frame => frame.ToString()), inChunks.Select(frame => frame.ToString()),
            StringComparer.Ordinal);
        var expected = ReferenceScan.OffsetsOfCheckedFrames(bytes, MavlinkDialect.All)
            .Where(offset => !HasUnknownFlag(bytes, offset));
        Assert.Equal(
            expected.Select(offset => (long)offset),
            found.Where(frame => frame.Info.IsChecked).Select(frame => frame.Info.StreamOffset));
        AssertInOrderAndByteForByte(bytes, found);
        Assert.Equal((bytes.Length, 0), (whole.Counters.Bytes, whole.PendingBytes));
    }

    [Fact]
    public void TryRead_AnyBytes_HoldsBackNoMoreThanTwoFrames()
    {
        byte[] bytes = FuzzBytes.Make(99, BytesPerSeed);
        var reader = new MavlinkFrameReader(MavlinkDialect.All);
        for (int i = 0; i < bytes.Length; i++)
        {
            ReadOnlySpan<byte> one = bytes.AsSpan(i, 1);
            while (reader.TryRead(ref one, out _, out _)) { }
            Assert.InRange(reader.PendingBytes, 0, 2 * MavlinkFrame.MaxWireLength);
        }
    }

    [Theory]
    [InlineData("fd")]
    [InlineData("fe")]
    [InlineData("fdff0000")]
    [InlineData("fdff000000000000fefd")]
    [InlineData("fdff00000001010000000000")]
    [InlineData("fdff000000")]
    [InlineData("feff83")]
    [InlineData("fe68")]
    [InlineData("fdff0001010101efcdab")]
    public void TryRead_HostilePattern_TakesBoundedTimePerByte(string patternHex)
    {
        // The worst that a pattern can do is to claim a long frame every few bytes: "feff83" costs 87 checksum steps
        // per byte. If every claim could cost the claims inside it again, this would take minutes instead of a second
        // or two.
        byte[] pattern = TestData.FromHex(patternHex);
        byte[] bytes = Enumerable.Range(0, 300_000).Select(i => pattern[i % pattern.Length]).ToArray();
        var watch = Stopwatch.StartNew();
        List<FoundFrame> found = FrameCollector.Read(bytes, 1000, new MavlinkFrameReader(MavlinkDialect.All));
        output.WriteLine($"{found.Count} frames, {watch.ElapsedMilliseconds} ms");

        Assert.True(watch.Elapsed < TimeSpan.FromSeconds(30), $"{watch.Elapsed}");
    }

    private static bool HasUnknownFlag(byte[] bytes, int offset)
        => bytes[offset] == 0xFD && (bytes[offset + 2] & ~1) != 0;

    private static void AssertInOrderAndByteForByte(byte[] bytes, List<FoundFrame> found)
    {
        long end = 0;
        foreach (FoundFrame frame in found)
        {
            Assert.True(frame.Info.StreamOffset >= end, frame.ToString());
            byte[] wire = Wire.Bytes(frame.Frame);
            Assert.True(bytes.AsSpan((int)frame.Info.StreamOffset, wire.Length).SequenceEqual(wire), frame.ToString());
            end = frame.Info.StreamOffset + wire.Length;
        }
    }
}
