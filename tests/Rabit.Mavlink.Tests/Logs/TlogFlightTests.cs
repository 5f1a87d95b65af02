using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Xunit;

namespace Rabit.Mavlink.Tests.Logs;

/// <summary>The two recorded flights against the facts listed beside them.</summary>
public class TlogFlightTests
{
    [Theory]
    [InlineData("ardupilot-flight")]
    [InlineData("px4-flight")]
    public void TryRead_RecordedFlight_AgreesWithItsSidecar(string name)
    {
        using JsonDocument sidecar = TestData.Json(TestData.PathOf(name + ".json"));
        using FileStream file = File.OpenRead(TestData.PathOf(name + ".tlog"));
        var log = new TlogReader(file, MavlinkDialect.All);
        var counts = new Dictionary<string, long>(StringComparer.Ordinal);
        var sequences = new MavlinkSequenceTracker();
        var times = new List<long>();
        while (log.TryRead(out MavlinkFrame frame, out TlogRecord record))
        {
            Assert.Equal((times.Count, true), (record.Index, record.IsChecked));
            times.Add(record.TimeMicroseconds);
            string key = $"{frame.MessageId} {frame.SystemId}/{frame.ComponentId} v{(int)frame.Version}";
            counts[key] = counts.TryGetValue(key, out long count) ? count + 1 : 1;
            sequences.Track(frame);
        }

        JsonElement facts = sidecar.RootElement;
        Assert.Equal((TlogEnd.Complete, facts.GetProperty("records").GetInt64()), (log.End, log.Records));
        Assert.Equal(
            (0L, null, facts.GetProperty("bytes").GetInt64()), (log.LostBytes, log.FirstDamageOffset, log.Position));
        Assert.Equal(facts.GetProperty("first_us").GetInt64(), times[0]);
        Assert.Equal(facts.GetProperty("last_us").GetInt64(), times[times.Count - 1]);
        Assert.Equal(ListedCounts(facts), Sorted(counts), StringComparer.Ordinal);
        Assert.Equal(ListedSequences(facts), Sequences(sequences), StringComparer.Ordinal);
    }

    [Theory]
    [InlineData("ardupilot-flight", 1)]
    [InlineData("px4-flight", 4093)]
    public void Write_WhatWasRead_GivesTheSameFile(string name, int readLength)
    {
        byte[] original = TestData.Bytes(name + ".tlog");
        var copy = new MemoryStream(original.Length);
        var writer = new TlogWriter(copy);
        var log = new TlogReader(new OneWayStream(original, original.Length, readLength), MavlinkDialect.All);
        while (log.TryRead(out MavlinkFrame frame, out TlogRecord record))
        {
            Assert.Equal(copy.Position, record.Offset);
            Assert.True(writer.Write(record.TimeMicroseconds, frame));
        }

        Assert.True(original.AsSpan().SequenceEqual(copy.ToArray()));
        Assert.Equal(log.Records, writer.Records);
    }

    private static List<string> ListedCounts(JsonElement facts) => Sorted(facts.GetProperty("counts").EnumerateArray()
        .GroupBy(row => $"{row[1]} {row[2]}/{row[3]} v{row[4]}", StringComparer.Ordinal)
        .ToDictionary(rows => rows.Key, rows => rows.Sum(row => row[6].GetInt64()), StringComparer.Ordinal));

    private static List<string> Sorted(Dictionary<string, long> counts) =>
        counts.Select(pair => $"{pair.Key}: {pair.Value}").OrderBy(line => line, StringComparer.Ordinal).ToList();

    private static List<string> ListedSequences(JsonElement facts) => facts.GetProperty("sequence").EnumerateArray()
        .Select(row => $"{row.GetProperty("sysid")}/{row.GetProperty("compid")} {row.GetProperty("frames")} "
            + $"{row.GetProperty("missing")} {row.GetProperty("out_of_order")}")
        .OrderBy(line => line, StringComparer.Ordinal).ToList();

    private static List<string> Sequences(MavlinkSequenceTracker tracker)
        => Enumerable.Range(0, tracker.Count).Select(index => tracker[index])
            .Select(source => $"{source.SystemId}/{source.ComponentId} {source.Frames} {source.Missing} "
                + $"{source.OutOfOrder}")
            .OrderBy(line => line, StringComparer.Ordinal).ToList();
}
