using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Logs;

/// <summary>
/// Logs of flights of others against what pymavlink reads in them, plus the frames that are mended and the one that
/// pymavlink misses where a log turns from MAVLink 1 to 2.
/// </summary>
public sealed class RealLogTests
{
    public static TheoryData<string> Logs => RealLogs.Sidecars.Count > 0 ? [.. RealLogs.Sidecars] : [string.Empty];

    [RealLogTheory]
    [MemberData(nameof(Logs))]
    public void TryRead_LogOfOthers_AgreesWithItsSidecar(string sidecar)
    {
        using JsonDocument document = TestData.Json(sidecar);
        JsonElement facts = document.RootElement;
        JsonElement framing = facts.GetProperty("framing");
        Dictionary<string, long> expected = ExpectedCounts(facts);
        using FileStream file = File.OpenRead(Path.ChangeExtension(sidecar, ".tlog"));
        var log = new TlogReader(file, MavlinkDialect.All);
        var counts = new Dictionary<string, long>(StringComparer.Ordinal);
        var texts = new List<string>();
        long first = 0;
        long last = 0;
        while (log.TryRead(out MavlinkFrame frame, out TlogRecord record))
        {
            Count(counts, KeyOf(frame.MessageId, frame.SystemId, frame.ComponentId), 1);
            first = record.Index == 0 ? record.TimeMicroseconds : first;
            last = record.TimeMicroseconds;
            if (frame.TryDecode(out Statustext text))
                texts.Add($"{frame.SystemId}/{frame.ComponentId} {(int)text.Severity} {text.Text}");
        }

        // pymavlink drops the frame at which it changes the version: one, and only where a log has both. It does not
        // say whose the frames are that it cannot read.
        Dictionary<int, long> unnamed = CountUnnamed(facts);
        bool isMixed = facts.GetProperty("versions").EnumerateObject().Count() > 1;
        Assert.Equal(isMixed ? 1 : 0, counts.Values.Sum() - expected.Values.Sum() - unnamed.Values.Sum());
        foreach (IGrouping<int, KeyValuePair<string, long>> id in counts.GroupBy(c => IdOf(c.Key)))
        {
            unnamed.TryGetValue(id.Key, out long loose);
            foreach (KeyValuePair<string, long> sender in id)
            {
                expected.TryGetValue(sender.Key, out long count);
                Assert.InRange(sender.Value, count, count + loose + (isMixed ? 1 : 0));
            }
        }

        Assert.Empty(expected.Keys.Except(counts.Keys));
        long mended = framing.GetProperty("crc_fits_after_zero_padding").EnumerateArray()
            .Sum(r => r.GetProperty("count").GetInt64());
        long bad = framing.GetProperty("crc_bad").GetInt64();
        Assert.Equal((mended, bad - mended), (log.MendedRecords, log.RefusedRecords));
        Assert.Equal(framing.GetProperty("records").GetInt64(), log.Records + log.RefusedRecords);
        Assert.Equal(RefusedLengths(framing) + Number(framing, "bytes_after_last_whole_record"), log.LostBytes);
        Assert.Equal(Seconds(facts, "first_time_s"), first);
        Assert.InRange(last, Seconds(facts, "last_time_s") - 1, long.MaxValue);
        Assert.Equal(
            facts.GetProperty("status_texts").EnumerateArray().Select(t => $"{t.GetProperty("sender")[0]}/{t.GetProperty("sender")[1]} "
                + $"{t.GetProperty("severity")} {t.GetProperty("text").GetString()}"),
            texts);
    }

    private static Dictionary<string, long> ExpectedCounts(JsonElement facts)
    {
        var expected = new Dictionary<string, long>(StringComparer.Ordinal);
        foreach (JsonElement row in facts.GetProperty("counts").EnumerateArray().Where(r => Number(r, "id") >= 0))
            Count(
                expected,
                KeyOf((int)Number(row, "id"), (int)Number(row, "system"), (int)Number(row, "component")),
                Number(row, "count"));

        return expected;
    }

    // By id: those that are mended, and those that pymavlink does not know.
    private static Dictionary<int, long> CountUnnamed(JsonElement facts)
        => facts.GetProperty("framing").GetProperty("crc_fits_after_zero_padding").EnumerateArray()
            .Select(r => (Id: (int)Number(r, "id"), Count: Number(r, "count")))
            .Concat(facts.GetProperty("counts").EnumerateArray().Where(r => Number(r, "id") < 0)
                .Select(r => (
                    Id: int.Parse(
                        r.GetProperty("name").GetString()!.Split('_')[1], CultureInfo.InvariantCulture),
                    Count: Number(r, "count"))))
            .GroupBy(r => r.Id).ToDictionary(g => g.Key, g => g.Sum(r => r.Count));

    private static int IdOf(string key) => int.Parse(key.Split(' ')[0], CultureInfo.InvariantCulture);

    private static long RefusedLengths(JsonElement framing)
    {
        long mended = framing.GetProperty("crc_fits_after_zero_padding").EnumerateArray().Count();
        return mended > 0
            ? 0
            : framing.GetProperty("crc_bad_by_id").EnumerateArray()
                .Sum(r => Number(r, "count") * (8 + 8 + Number(r, "payload_length")));
    }

    private static void Count(Dictionary<string, long> counts, string key, long more)
        => counts[key] = counts.TryGetValue(key, out long count) ? count + more : more;

    private static string KeyOf(int id, int system, int component) => $"{id} {system}/{component}";

    private static long Number(JsonElement element, string name) => element.GetProperty(name).GetInt64();

    private static long Seconds(JsonElement element, string name)
        => (long)Math.Round(element.GetProperty(name).GetDouble() * 1e6);
}
