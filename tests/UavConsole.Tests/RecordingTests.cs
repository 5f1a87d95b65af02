using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Tests.Shared;
using Rabit.Uav.Tests;
using Rabit.Uav.Tests.Communications;
using Xunit;

namespace UavConsole.Tests;

/// <summary>What is recorded of a flight, and that it plays back as it was.</summary>
public sealed class RecordingTests : IDisposable
{
    private readonly TestLog _log = new("unused.tlog");

    public void Dispose() => _log.Dispose();

    [Fact]
    public void Flight_Recorded_PlaysBackWithTheSameSummary()
    {
        string folder = Path.Combine(_log.Folder, "logs");
        string mission = SmallMission.WriteTo(_log.Folder);
        JsonElement flown = Run("flown.json", "--tlog-dir", folder, "--mission", mission, "--targets", "0");
        string file = Assert.Single(Directory.GetFiles(folder));
        JsonElement played = Run("played.json", "--link", $"tlog:{file}?speed=max");

        Assert.Equal(Unnumbered(SummaryFacts.ModeChanges(flown)), Unnumbered(SummaryFacts.ModeChanges(played)));
        Assert.Equal(
            Unnumbered(SummaryFacts.Acknowledgements(flown)), Unnumbered(SummaryFacts.Acknowledgements(played)));
        Assert.Equal(Unnumbered(SummaryFacts.Texts(flown)), Unnumbered(SummaryFacts.Texts(played)));
        Assert.Equal(SummaryFacts.Ranges(flown), SummaryFacts.Ranges(played));
        foreach (string same in new[] { "autopilot", "vehicleType", "firstUtcMicroseconds", "lastUtcMicroseconds" })
            Assert.Equal(flown.GetProperty(same).ToString(), played.GetProperty(same).ToString());

        JsonElement link = Assert.Single(played.GetProperty("links").EnumerateArray());
        JsonElement live = Assert.Single(flown.GetProperty("links").EnumerateArray());
        Assert.Equal(Counts(live.GetProperty("counts")), Counts(link.GetProperty("counts")).Where(c => !IsOurs(c)));
        Assert.Equal(Counts(flown.GetProperty("ownFrames")), Counts(link.GetProperty("counts")).Where(IsOurs));
        Assert.Equal(0, link.GetProperty("bytesLost").GetInt64());
    }

    [Fact]
    public void LiveLink_IsRecordedByDefault_AndNotWithNoTlog()
    {
        string[] arguments = ["--headless", "--link", $"udpin:127.0.0.1:{FreePort.Udp()}"];
        Assert.StartsWith("flight-", Path.GetFileName(Assert.Single(RecordBriefly(arguments))));
        Assert.Empty(RecordBriefly([.. arguments, "--no-tlog"]));
    }

    [Fact]
    public void CurrentFolder_CannotBeWritten_RunGoesOnAndSaysSo()
    {
        string[] arguments = ["--headless", "--link", $"udpin:127.0.0.1:{FreePort.Udp()}"];
        using ConsoleProcess process = ConsoleProcess.StartIn("/proc", arguments);
        using var flight = new LiveFlight(int.Parse(arguments[2].Split(':')[2], CultureInfo.InvariantCulture));
        process.WaitFor("observing");
        flight.Play("ardupilot-flight", TimeSpan.FromSeconds(1));
        process.WaitFor("could not be written");
        process.Signal(ConsoleProcess.Interrupt);
        Assert.Equal(2, process.WaitForEnd());
    }

    [Theory]
    [InlineData("--tlog-dir and --no-tlog contradict each other.", "--link", "udpin:127.0.0.1:1", "--no-tlog", "--tlog-dir", "x")]
    [InlineData("--tlog-size 0: it must be a number of megabytes", "--link", "udpin:127.0.0.1:1", "--tlog-size", "0")]
    [InlineData("the folder of the recording, /proc/nowhere, cannot be written", "--link", "udpin:127.0.0.1:0", "--tlog-dir", "/proc/nowhere")]
    public void Options_ThatCannotBe_AreOneLine(string expected, params string[] arguments)
    {
        string[] given = [.. arguments.Select(a => a.EndsWith(":0", StringComparison.Ordinal)
            ? $"udpin:127.0.0.1:{FreePort.Udp()}"
            : a)];
        Assert.Contains(expected, Assert.Single(CommandLineRun.Refuse(given)));
    }

    private string[] RecordBriefly(string[] arguments)
    {
        string folder = Directory.CreateDirectory(Path.Combine(_log.Folder, Guid.NewGuid().ToString("N"))).FullName;
        using (ConsoleProcess process = ConsoleProcess.StartIn(folder, arguments))
        {
            using var flight = new LiveFlight(int.Parse(arguments[2].Split(':')[2], CultureInfo.InvariantCulture));
            process.WaitFor("observing");
            flight.Play("ardupilot-flight", TimeSpan.FromSeconds(1));
            process.WaitFor("autopilot: autopilot Ardupilotmega");
            process.Signal(ConsoleProcess.Interrupt);
            Assert.Equal(0, process.WaitForEnd());
        }

        return Directory.GetFiles(folder, "*.tlog");
    }

    private JsonElement Run(string name, params string[] arguments)
    {
        string summary = Path.Combine(_log.Folder, name);
        using ConsoleProcess process = ConsoleProcess.RunIn(
            _log.Folder, out _, [.. arguments, "--headless", "--summary", summary]);
        Assert.True(File.Exists(summary), process.ToString());
        using JsonDocument document = JsonDocument.Parse(File.ReadAllText(summary));
        return document.RootElement.Clone();
    }

    // The number of a record is that among all of the log, of a live link that among what came in.
    private static string[] Unnumbered(IEnumerable<string> lines)
        => lines.Select(l => l.Substring(l.IndexOf(' ') + 1)).ToArray();

    private static List<string> Counts(JsonElement counts)
        => counts.EnumerateArray()
            .Select(c => $"{c.GetProperty("systemId")}/{c.GetProperty("componentId")} {c.GetProperty("name")} {c.GetProperty("count")}")
            .OrderBy(l => l, StringComparer.Ordinal).ToList();

    private static bool IsOurs(string count) => count.StartsWith("1/191 ", StringComparison.Ordinal);
}
