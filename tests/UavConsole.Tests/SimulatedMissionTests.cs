using System;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Xml.Linq;
using Rabit.Tests.Shared;
using Rabit.Uav.Tests.Communications;
using Rabit.Uav.Tests;
using Xunit;

namespace UavConsole.Tests;

/// <summary>The simulated search, as a user starts it.</summary>
public sealed class SimulatedMissionTests : IDisposable
{
    private readonly TestLog _folder = new();

    [Fact]
    public void NoArguments_FliesTheSearchAndLeavesAReport()
    {
        using ConsoleProcess console = ConsoleProcess.RunIn(
            _folder.Folder, out int exitCode, "--summary", "summary.json", "--export", "flight.geojson", "--export",
            "flight.kml", "--export", "flight.CSV");

        Assert.True(exitCode == 0, console.ToString());
        Assert.Empty(console.Errors);
        Assert.Contains("mission search of a meadow: ACCOMPLISHED", console.Output);
        string report = Directory.GetFiles(_folder.Folder, "search-of-a-meadow-*-report.html").Single();
        Assert.Contains("report: " + report, console.Output);
        string page = File.ReadAllText(report);
        Assert.InRange(page.Length, 100_000, 2_000_000);
        Assert.Contains("5 of 5 targets found", page);
        Assert.DoesNotContain("no picture", page);
        CheckSummary();
        CheckExports();
    }

    [Theory]
    [InlineData("heading", true)]
    [InlineData("body", false)]
    public void Gimbal_Stabilised_IsPointedByTheMission(string gimbal, bool isPointed)
    {
        using ConsoleProcess console = ConsoleProcess.RunIn(
            _folder.Folder, out int exitCode, "--headless", "--mission", SmallMission.WriteTo(_folder.Folder),
            "--targets", "0", "--gimbal", gimbal);

        Assert.True(exitCode == 0, console.ToString());
        Assert.Equal(
            isPointed,
            console.Output.Any(
                l => l.Contains("DO_GIMBAL_MANAGER_PITCHYAW (1000): ACCEPTED", StringComparison.Ordinal)));
    }

    [Fact]
    public void Interrupt_InTheMiddle_IsAFailedMissionWithItsReport()
    {
        using ConsoleProcess console = ConsoleProcess.Start(
            "--headless", "--realtime", "--report", InFolder("cut.html"), "--targets", "0");
        console.WaitFor("mission control: command 2: take off");

        console.Signal(ConsoleProcess.Interrupt);

        Assert.Equal(1, console.WaitForEnd());
        Assert.Contains("  failed: it ", string.Join("\n", console.Output));
        Assert.Contains("Mission failed", File.ReadAllText(InFolder("cut.html")));
    }

    [Fact]
    public void Plan_BatteryCannotFlyIt_IsRefusedByNameOfTheSwitchOrBegunWithIt()
    {
        // 0.6 km x 0.6 km in lanes of 12 m at 6 m/s: more than an hour.
        File.WriteAllText(InFolder("large.json"), """
            {
              "name": "large",
              "area": [[47.3972, 8.5446], [47.4026, 8.5446], [47.4026, 8.5526], [47.3972, 8.5526]],
              "heightMetres": 40, "speedMetresPerSecond": 6, "laneSpacingMetres": 12,
              "targets": ["red"]
            }
            """);
        using ConsoleProcess refused = ConsoleProcess.RunIn(
            _folder.Folder, out int exitCode, "--headless", "--mission", "large.json", "--report", "refused.html");
        Assert.Equal(1, exitCode);
        Assert.Contains(refused.Output, l => l.Contains("the plan takes ") && l.Contains("--allow-partial-search"));

        using ConsoleProcess begun = ConsoleProcess.Start(
            "--headless", "--mission", InFolder("large.json"), "--allow-partial-search", "--report",
            InFolder("begun.html"));
        Assert.Contains("the plan takes ", begun.WaitFor(": begun all the same, it returns in time"));
        begun.WaitFor("take off");
        begun.Signal(ConsoleProcess.Interrupt);
        Assert.Equal(1, begun.WaitForEnd());
    }

    // The same seed, by default or by the switch, is the same flight, to the byte of its log.
    [Fact]
    public void SameSeed_FlownAgain_GivesTheSameLogAndKeepsTheFilesUnderTheirDate()
    {
        string mission = SmallMission.WriteTo(_folder.Folder);
        using ConsoleProcess first = ConsoleProcess.RunIn(
            _folder.Folder, out int _, "--mission", mission, "--targets", "2", "--log", "first.log", "--summary",
            "s.json", "--report", "r.html");
        string summary = File.ReadAllText(InFolder("s.json"));
        string report = File.ReadAllText(InFolder("r.html"));

        using ConsoleProcess again = ConsoleProcess.RunIn(
            _folder.Folder, out int _, "--mission", mission, "--targets", "2", "--log", "second.log", "--summary",
            "s.json", "--report", "r.html", "--seed", "1");

        string kept = Assert.Single(Directory.GetFiles(_folder.Folder, "s.2*.json"));
        Assert.Equal(summary, File.ReadAllText(kept));
        Assert.Equal(report, File.ReadAllText(Assert.Single(Directory.GetFiles(_folder.Folder, "r.2*.html"))));
        Assert.Contains("\"phases\"", File.ReadAllText(InFolder("s.json")));
        string log = File.ReadAllText(InFolder("first.log"));
        Assert.Contains("Landing -> Done", log);
        Assert.Equal(log, File.ReadAllText(InFolder("second.log")));
    }

    // A full disk: the flight goes on to its end, and what can be written is complete.
    [Theory, Trait("Category", "Long")]
    [InlineData(">&-")]
    [InlineData("> /dev/full")]
    public void OutputAlone_CannotBeWritten_FlightGoesOnAndItsFilesAreComplete(string redirection)
        => Output_CannotBeWritten_FlightGoesOnAndItsFilesAreComplete(redirection);

    [Theory]
    [InlineData("> /dev/full 2> /dev/full")]
    [InlineData("| head -1")]
    public void Output_CannotBeWritten_FlightGoesOnAndItsFilesAreComplete(string redirection)
    {
        int exitCode = ConsoleProcess.RunInShell(
            _folder.Folder, redirection, out string errors, "--headless", "--mission",
            SmallMission.WriteTo(_folder.Folder), "--targets", "0", "--summary", "s.json", "--report", "r.html");
        using JsonDocument summary = JsonDocument.Parse(File.ReadAllText(InFolder("s.json")));
        Assert.Equal("Done", summary.RootElement.GetProperty("mission").GetProperty("phase").GetString());
        Assert.EndsWith("</html>", File.ReadAllText(InFolder("r.html")).TrimEnd());
        if (redirection is "> /dev/full" or "| head -1")
            Assert.Contains("standard output: ", errors);
        Assert.NotEqual(134, exitCode);
        Assert.DoesNotContain("Unhandled", errors);
    }

    [Theory]
    [InlineData("{", "it is not JSON")]
    [InlineData("""{"name":"x"}""", "area")]
    public void Mission_BadFile_IsOneLineAndExitCode2(string json, string expected)
    {
        File.WriteAllText(InFolder("bad.json"), json);
        string line = Assert.Single(
            CommandLineRun.Refuse("--mission", InFolder("bad.json"), "--report", InFolder("r.html")));
        Assert.StartsWith($"UavConsole: --mission {InFolder("bad.json")}: ", line, StringComparison.Ordinal);
        Assert.Contains(expected, line);
        Assert.False(File.Exists(InFolder("r.html")));
    }

    [Fact]
    public void Mission_NoSuchFile_IsOneLineAndExitCode2()
        => Assert.StartsWith(
            "UavConsole: --mission /nowhere/m.json cannot be read: ",
            Assert.Single(CommandLineRun.Refuse("--mission", "/nowhere/m.json")), StringComparison.Ordinal);

    [Fact]
    public void RealLink_IsOnlyObservedAndSaysSo()
    {
        using ConsoleProcess console = ConsoleProcess.Start(
            "--headless", "--link", $"udpin:127.0.0.1:{FreePort.Udp()}");

        console.WaitFor("observing only: nothing is commanded; --mission FILE --fly flies");
        console.WaitForStart();
        console.Signal(ConsoleProcess.Terminate);
        Assert.Equal(0, console.WaitForEnd());
    }

    public void Dispose() => _folder.Dispose();

    private void CheckExports()
    {
        using JsonDocument json = JsonDocument.Parse(File.ReadAllText(InFolder("flight.geojson")));
        JsonElement[] features = [.. json.RootElement.GetProperty("features").EnumerateArray()];
        Assert.Equal(
            5, features.Count(f => f.GetProperty("properties").GetProperty("kind").GetString() == "ellipse95"));
        XDocument kml = XDocument.Load(InFolder("flight.kml"));
        Assert.Equal(6, kml.Descendants().Count(e => e.Name.LocalName == "name" && e.Value.Contains("ellipse"))
            + kml.Descendants().Count(e => e.Name.LocalName == "name" && e.Value == "path"));
        Assert.StartsWith("kind,number,", File.ReadAllText(InFolder("flight.CSV")), StringComparison.Ordinal);
    }

    private void CheckSummary()
    {
        using JsonDocument document = JsonDocument.Parse(File.ReadAllText(InFolder("summary.json")));
        JsonElement mission = document.RootElement.GetProperty("mission");
        JsonElement score = mission.GetProperty("score");

        Assert.True(mission.GetProperty("passed").GetBoolean());
        Assert.Equal((5, 5, 0), (score.GetProperty("targets").GetInt32(), score.GetProperty("found").GetInt32(),
            score.GetProperty("false").GetInt32()));
        Assert.InRange(score.GetProperty("rmseMetres").GetDouble(), 0, 3);
        Assert.InRange(mission.GetProperty("coveragePercent").GetDouble(), 98, 100);
        Assert.InRange(mission.GetProperty("distanceFromHomeMetres").GetDouble(), 0, 3);
        Assert.InRange(mission.GetProperty("batteryUsedPercent").GetDouble(), 5, 60);
        Assert.Equal("Done", mission.GetProperty("phase").GetString());
        Assert.Equal(1, mission.GetProperty("seed").GetInt64());
        Assert.Equal(5, mission.GetProperty("targets").GetArrayLength());
        Assert.All(
            mission.GetProperty("targets").EnumerateArray(),
            t => Assert.InRange(t.GetProperty("ellipse95HalfMajorAxisMetres").GetDouble(), 0.1, 8));
        Assert.Equal(
            ["communications", "autopilot", "image processing", "sensor fusion", "mission control", "simulated vehicle",
                "health", "recorder"],
            mission.GetProperty("managers").EnumerateArray().Select(m => m.GetProperty("name").GetString()));
        Assert.All(
            mission.GetProperty("managers").EnumerateArray(),
            m => Assert.InRange(m.GetProperty("runs").GetInt64(), 100, 1_000_000));
    }

    private string InFolder(string file) => Path.Combine(_folder.Folder, file);
}
