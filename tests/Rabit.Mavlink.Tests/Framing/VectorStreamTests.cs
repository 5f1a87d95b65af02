using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Xunit;

namespace Rabit.Mavlink.Tests.Framing;

/// <summary>
/// Streams with damage, garbage, unknown ids and flags: exactly the frames listed beside them, however the bytes are
/// cut.
/// </summary>
public class VectorStreamTests
{
    private static readonly int[] ChunkLengths = [1, 7, 64, 1000, int.MaxValue];

    [ExtendedDataFact("a-truncated-headers.bin")]
    public void TryRead_StreamWithTruncatedHeaders_FindsExactlyTheListedFrames()
        => FindsTheListedFrames("a-truncated-headers", 5000);

    [ExtendedDataFact("b-byte-loss.bin")]
    public void TryRead_StreamWithLostBytes_FindsExactlyTheListedFrames() => FindsTheListedFrames("b-byte-loss", 4737);

    [ExtendedDataFact("c-garbage.bin")]
    public void TryRead_StreamWithGarbage_FindsExactlyTheListedFrames() => FindsTheListedFrames("c-garbage", 3000);

    [Theory]
    [InlineData("a-truncated-headers-part")]
    [InlineData("b-byte-loss-part")]
    [InlineData("c-garbage-part")]
    public void TryRead_StartOfADamagedStream_FindsExactlyTheListedFrames(string name) =>
        FindsTheListedFrames(TestData.PathOf(name + ".bin"), TestData.PathOf(name + ".json"), 600);

    [Fact]
    public void TryRead_StreamWithUnknownIdsAndFlags_DeliversForwardsAndDropsAsListed()
    {
        byte[] bytes = TestData.Bytes("e-unknown.bin");
        using JsonDocument facts = TestData.Json(TestData.PathOf("e-unknown.json"));
        List<JsonElement> rows = Rows(facts, row => row[8].GetString() != "drop");
        foreach (int chunk in ChunkLengths)
        {
            var reader = new MavlinkFrameReader(CrcExtraDialect.All);
            List<FoundFrame> found = FrameCollector.Read(bytes, Math.Min(chunk, bytes.Length), reader);

            Assert.Equal(
                rows.Select(row => Line(row, row[8].GetString() == "deliver")), found.Select(frame => frame.ToString()),
                StringComparer.Ordinal);
            Assert.Equal(
                (330, 159, 111),
                (reader.Counters.Frames, reader.Counters.UnknownFrames, reader.Counters.IncompatibleFrames));
            Assert.Equal(
                (0, 0, bytes.Length),
                (reader.Counters.SkippedBytes, reader.Counters.BadChecksums, reader.Counters.Bytes));
            Assert.All(found, frame => AssertSameBytes(bytes, frame));
        }
    }

    private static void FindsTheListedFrames(string name, int expected) =>
        FindsTheListedFrames(ExtendedData.Find(name + ".bin")!, ExtendedData.Find(name + ".json")!, expected);

    private static void FindsTheListedFrames(string stream, string list, int expected)
    {
        byte[] bytes = File.ReadAllBytes(stream);
        using JsonDocument facts = TestData.Json(list);
        List<string> rows = Rows(facts, _ => true).ConvertAll(row => Line(row, isChecked: true));
        Assert.Equal(expected, rows.Count);
        string? first = null;
        foreach (int chunk in ChunkLengths)
        {
            var reader = new MavlinkFrameReader(CrcExtraDialect.All);
            List<FoundFrame> found = FrameCollector.Read(bytes, Math.Min(chunk, bytes.Length), reader);

            Assert.Equal(
                rows, found.Where(frame => frame.Info.IsChecked).Select(frame => frame.ToString()),
                StringComparer.Ordinal);
            Assert.All(found, frame => AssertSameBytes(bytes, frame));
            string all = string.Join("\n", found);
            Assert.Equal(first ??= all, all);
        }
    }

    private static List<JsonElement> Rows(JsonDocument facts, Func<JsonElement, bool> isWanted) =>
        facts.RootElement.GetProperty("frames").EnumerateArray().Where(isWanted).ToList();

    private static string Line(JsonElement row, bool isChecked) => FormattableString.Invariant(
        $"{row[0]} +{row[1]} V{row[2]} id {row[3]} {row[4]}/{row[5]} seq {row[6]} signed {row[7].GetInt32() == 1} checked {isChecked}");

    private static void AssertSameBytes(byte[] stream, FoundFrame found)
    {
        var wire = new byte[MavlinkFrame.MaxWireLength];
        int length = found.Frame.WriteTo(wire);
        Assert.True(
            stream.AsSpan((int)found.Info.StreamOffset, length).SequenceEqual(wire.AsSpan(0, length)),
            found.ToString());
    }
}
