using System;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Tests.Communications;
using Rabit.Uav.Tests;
using Xunit;

namespace UavConsole.Tests;

/// <summary>Recorded flights on the console, to the JSON that docs/uavconsole-summary.md describes.</summary>
public sealed class ReplayTests : IDisposable
{
    private readonly TestLog _log = new("damaged.tlog");
    private readonly string _summary;

    public ReplayTests() => _summary = Path.Combine(_log.Folder, "summary.json");

    [Theory]
    [InlineData("ardupilot-flight", "Ardupilotmega")]
    [InlineData("px4-flight", "Px4")]
    public void Summary_RecordedFlight_AgreesWithTheSidecar(string name, string autopilot)
    {
        using ConsoleProcess process = Replay($"tlog:{TestData.PathOf(name + ".tlog")}?speed=max");
        using JsonDocument sidecar = TestData.Json(name + ".json");
        JsonElement facts = sidecar.RootElement;
        using JsonDocument document = JsonDocument.Parse(File.ReadAllText(_summary));
        JsonElement summary = document.RootElement;
        JsonElement link = Assert.Single(summary.GetProperty("links").EnumerateArray());

        Assert.Equal(autopilot, summary.GetProperty("autopilot").GetString());
        Assert.Equal("Quadrotor", summary.GetProperty("vehicleType").GetString());
        Assert.Equal(facts.GetProperty("first_us").GetInt64(), summary.GetProperty("firstUtcMicroseconds").GetInt64());
        Assert.Equal(facts.GetProperty("last_us").GetInt64(), summary.GetProperty("lastUtcMicroseconds").GetInt64());
        Assert.Equal(SidecarFacts.ModeChanges(facts), SummaryFacts.ModeChanges(summary));
        Assert.Equal(SidecarFacts.Acknowledgements(facts), SummaryFacts.Acknowledgements(summary));
        Assert.Equal(SidecarFacts.Texts(facts), SummaryFacts.Texts(summary));
        Assert.Equal(SidecarFacts.Ranges(facts), SummaryFacts.Ranges(summary));
        Assert.Equal(facts.GetProperty("records").GetInt64(), link.GetProperty("frames").GetInt64());
        Assert.Equal("Ended", link.GetProperty("state").GetString());
        Assert.Equal(
            SidecarFacts.Counts(facts),
            link.GetProperty("counts").EnumerateArray().Select(Count).OrderBy(l => l, StringComparer.Ordinal));
        Assert.Equal(SidecarFacts.Sources(facts), link.GetProperty("sources").EnumerateArray().Select(Source));
        Assert.Equal(
            ["HEARTBEAT"],
            summary.GetProperty("ownFrames").EnumerateArray().Select(c => c.GetProperty("name").GetString()));
        Assert.Equal(0, summary.GetProperty("run").GetProperty("exitCode").GetInt32());
    }

    [Fact]
    public void BundledFlight_AtTenTimesItsPace_IsInterruptedInOrder()
    {
        string bundled = Path.Combine(
            Path.GetDirectoryName(typeof(ReplayTests).Assembly.Location)!, "flights", "ardupilot-flight.tlog");
        using ConsoleProcess process = ConsoleProcess.Start(
            "--summary", _summary, "--link", $"tlog:{bundled}?speed=10");
        Assert.EndsWith(
            "ardupilot-flight.tlog?speed=10", process.WaitFor("replaying or observing"), StringComparison.Ordinal);
        process.WaitFor("autopilot: autopilot Ardupilotmega of a Quadrotor, system 1, component 1");

        process.Signal(ConsoleProcess.Interrupt);

        Assert.Equal(0, process.WaitForEnd());
        Assert.DoesNotContain(process.Output, l => l.Any(c => c == '\u001b'));
    }

    [Fact]
    public void Report_OfAReplay_IsWrittenWhereAskedFor()
    {
        string report = Path.Combine(_log.Folder, "flight.html");
        string log = Path.Combine(_log.Folder, "flight.log");
        using ConsoleProcess process = ConsoleProcess.Run(
            out int exitCode, "--link", $"tlog:{TestData.PathOf("px4-flight.tlog")}?speed=max", "--headless",
            "--summary", _summary, "--report", report, "--log", log);

        Assert.True(exitCode == 0, process.ToString());
        Assert.Contains("report: " + report, process.Output);
        Assert.Contains("A flight that was observed", File.ReadAllText(report));
        string[] lines = File.ReadAllLines(log);
        Assert.Contains(lines, l => l.Contains("reactor: starts communications"));
        Assert.Contains(lines, l => l.Contains("autopilot: autopilot Px4 of a Quadrotor"));
        using JsonDocument document = JsonDocument.Parse(File.ReadAllText(_summary));
        Assert.Equal(JsonValueKind.Null, document.RootElement.GetProperty("mission").ValueKind);
    }

    [Fact]
    public void Log_CutInItsLastRecord_PlaysTheRestAndNamesTheDamage()
    {
        byte[] flight = File.ReadAllBytes(TestData.PathOf("px4-flight.tlog"));
        _log.Raw(flight.Take(flight.Length - 5).ToArray());
        int lost = LengthOfLastRecord(flight) - 5;

        AssertDamage(frames: 23150, lost, offset: flight.Length - 5 - lost);
    }

    [Fact]
    public void Log_DamagedInside_PlaysTheRestAndNamesTheDamage()
    {
        byte[] first = [.. Enumerable.Range(0, 100).SelectMany(n => Record(n))];
        _log.Raw(first).Raw(Enumerable.Repeat((byte)0xAA, 333).ToArray())
            .Raw([.. Enumerable.Range(100, 50).SelectMany(n => Record(n))]);

        AssertDamage(frames: 150, lost: 333, offset: first.Length);
    }

    [Fact]
    public void Log_DamagedInsideTheBundledFlight_PlaysAllOtherRecords()
    {
        byte[] flight = File.ReadAllBytes(TestData.PathOf("ardupilot-flight.tlog"));
        for (int at = 500_000; at < 500_010; at++)
            flight[at] ^= 0xFF;
        _log.Raw(flight);

        using ConsoleProcess process = Replay(_log.Url + "?speed=max");
        JsonElement link = Link(out JsonDocument document);
        using (document)
        {
            Assert.InRange(link.GetProperty("frames").GetInt64(), 20918, 20920);
            Assert.InRange(link.GetProperty("firstDamageOffsetBytes").GetInt64(), 500_000 - 300, 500_010);
            Assert.InRange(link.GetProperty("bytesLost").GetInt64(), 10, 900);
        }
    }

    [Fact]
    public void TwoLogs_AreCountedEachByItself()
    {
        using ConsoleProcess process = ConsoleProcess.Run(
            out int exitCode,
            "--headless", "--summary", _summary,
            "--link", $"tlog:{TestData.PathOf("ardupilot-flight.tlog")}?speed=max",
            "--link", $"tlog:{TestData.PathOf("px4-flight.tlog")}?speed=max");

        Assert.True(exitCode == 0, process.ToString());
        using JsonDocument document = JsonDocument.Parse(File.ReadAllText(_summary));
        Assert.Equal(
            new long[] { 20921, 23151 },
            document.RootElement.GetProperty("links").EnumerateArray().Select(l => l.GetProperty("frames").GetInt64()));
    }

    [Fact]
    public void StatusText_WithControlCharacters_DoesNotReachTheTerminal()
    {
        var text = new Statustext
        {
            Severity = MavSeverity.Alert,
            Text = new Text50("a\u001b]0;title\u0007b\nc [red]d")
        };
        _log.Record(0, Frames.Heartbeat()).Record(1, Frames.Of(text)).Record(2, Frames.Heartbeat(sequence: 1));

        using ConsoleProcess process = Replay(_log.Url + "?speed=max");

        Assert.Contains(process.Output, l => l.EndsWith("alert: a.]0;title.b.c [red]d", StringComparison.Ordinal));
        Assert.DoesNotContain(process.Output, l => l.Any(char.IsControl));
        using JsonDocument document = JsonDocument.Parse(File.ReadAllText(_summary));
        Assert.Equal(
            "a\u001b]0;title\u0007b\nc [red]d",
            document.RootElement.GetProperty("statusTexts")[0].GetProperty("text").GetString());
    }

    [Fact]
    public void Help_ShowsTheOptionsAndEndsWell()
    {
        using ConsoleProcess process = ConsoleProcess.Run(out int exitCode, "--help");

        Assert.Equal(0, exitCode);
        foreach (string option in new[]
        {
            "--link", "--headless", "--summary", "--system-id", "tlog:FILE[?speed=10|max]", "--seed", "--targets",
            "--realtime", "--mission", "--fly", "--camera", "--truth", "--report", "--log", "--allow-partial-search",
        })
            Assert.Contains(process.Output, l => l.Contains(option));
    }

    public void Dispose() => _log.Dispose();

    private ConsoleProcess Replay(string link)
    {
        ConsoleProcess process = ConsoleProcess.Run(
            out int exitCode, "--link", link, "--headless", "--summary", _summary);
        Assert.True(exitCode == 0, process.ToString());
        Assert.Empty(process.Errors);
        return process;
    }

    private void AssertDamage(long frames, long lost, long offset)
    {
        using ConsoleProcess process = Replay(_log.Url + "?speed=max");

        Assert.Contains(
            $"  {lost} bytes belong to no intact record or frame, the first at offset {offset}", process.Output);
        JsonElement link = Link(out JsonDocument document);
        using (document)
        {
            Assert.Equal(
                (frames, lost, offset),
                (link.GetProperty("frames").GetInt64(), link.GetProperty("bytesLost").GetInt64(),
                    link.GetProperty("firstDamageOffsetBytes").GetInt64()));
        }
    }

    private JsonElement Link(out JsonDocument document)
    {
        document = JsonDocument.Parse(File.ReadAllText(_summary));
        return document.RootElement.GetProperty("links")[0];
    }

    private static byte[] Record(int n)
    {
        long stamp = TestLog.Start + (n * 10_000L);
        return [.. Enumerable.Range(0, 8).Select(i => (byte)(stamp >> (56 - (8 * i)))),
            .. Frames.Heartbeat(sequence: (byte)n)];
    }

    private static int LengthOfLastRecord(byte[] flight)
    {
        using var stream = new MemoryStream(flight);
        var reader = new Rabit.Mavlink.TlogReader(stream, Rabit.Mavlink.MavlinkDialect.All);
        long last = 0;
        while (reader.TryRead(out _, out Rabit.Mavlink.TlogRecord record))
            last = record.Offset;
        return (int)(flight.Length - last);
    }

    private static string Count(JsonElement c) => SidecarFacts.Line(
        c.GetProperty("messageId").GetInt32(), c.GetProperty("systemId").GetInt32(),
        c.GetProperty("componentId").GetInt32(), c.GetProperty("version").GetInt32(),
        c.GetProperty("count").GetInt64());

    private static string Source(JsonElement s) => SidecarFacts.Line(
        s.GetProperty("systemId").GetInt32(), s.GetProperty("componentId").GetInt32(),
        s.GetProperty("frames").GetInt64(), s.GetProperty("missing").GetInt64(),
        s.GetProperty("outOfOrder").GetInt64());
}
