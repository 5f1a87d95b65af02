using System;
using System.IO;
using System.Linq;
using Rabit.Links;
using Rabit.Tests.Shared;
using Rabit.Uav.Communications;
using Rabit.Uav.MissionControl;
using Xunit;

namespace UavConsole.Tests;

/// <summary>--config: a service's configuration file flies the same here, and the command line counts more.</summary>
public sealed class ConfigFileTests : IDisposable
{
    private static readonly string Mission
        = Path.Combine(Repository.Root, "samples", "UavConsole", "missions", "search.json");

    private static readonly string Flight
        = Path.Combine(Repository.Root, "tests", "data", "mavlink", "ardupilot-flight.tlog");

    private readonly string _folder = Path.Combine(Path.GetTempPath(), "config-" + Guid.NewGuid().ToString("N"));

    public ConfigFileTests() => Directory.CreateDirectory(_folder);

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void File_OfAService_IsWhatIsFlown()
    {
        ConsoleOptions options = Read(Service);

        Assert.Equal("udpout:127.0.0.1:9", Assert.Single(options.Links).ToString());
        Assert.True(options.Flies);
        Assert.Equal(Mission, options.MissionFile);
        Assert.Equal((byte)7, options.SystemId);
        Assert.True(options.Preflight.SetsFailsafes);
        Assert.True(options.Preflight.UploadsFence);
        Assert.Equal("own.json", options.Preflight.OriginalsFile);
        Assert.True(options.Preflight.IsWithoutDetection);
        Assert.Equal(["disk"], options.Preflight.Overrides);
        Assert.Equal(OnStop.Return, options.Operator.OnStop);
        Assert.Equal("p.json", options.Operator.ProgressFile);
        Assert.Equal(new byte[] { 254 }, options.Operator.GroundCommands!.SystemIds);
        RecordingOptions recording = options.Recording.ToOptions(isByDefault: true, "meadow")!;
        Assert.Equal(("logs", "meadow", true), (recording.Folder, recording.Name, recording.IsRequired));
        Assert.Equal(0.3, options.Config!.Options.Health.BatteryLowFraction);
    }

    [Fact]
    public void CommandLine_SaysOtherwise_CountsMore()
    {
        ConsoleOptions options = Read(
            Service.Replace("udpout:127.0.0.1:9", "nonsense").Replace("p.json", "/nowhere/p.json"), "--link",
            "udpout:127.0.0.1:10", "--system-id", "9", "--originals", "o.json", "--override", "clock", "--on-stop",
            "hold", "--progress", "q.json", "--commanders", "253", "--tlog-dir", "there");

        Assert.Equal("udpout:127.0.0.1:10", Assert.Single(options.Links).ToString());
        Assert.Equal((byte)9, options.SystemId);
        Assert.Equal("o.json", options.Preflight.OriginalsFile);
        Assert.Equal(["clock"], options.Preflight.Overrides);
        Assert.Equal(OnStop.Hold, options.Operator.OnStop);
        Assert.Equal("q.json", options.Operator.ProgressFile);
        Assert.Equal(new byte[] { 253 }, options.Operator.GroundCommands!.SystemIds);
        Assert.Equal("there", options.Recording.ToOptions(isByDefault: true, "meadow")!.Folder);
        Assert.Null(Read(Service, "--no-tlog").Recording.ToOptions(isByDefault: true, "meadow"));
    }

    [Fact]
    public void File_WithoutMayCommand_OnlyObserves()
    {
        ConsoleOptions options = Read("""{ "Uav": { "Links": [ "udpout:127.0.0.1:9" ], "Seed": 4 } }""");

        Assert.False(options.Flies);
        Assert.Null(options.MissionFile);
        Assert.Equal(4, options.Seed);
        Assert.Null(options.Operator.ProgressFile);
    }

    // What else is wrong with the file must not keep a vehicle from coming home.
    [Fact]
    public void File_OfAnAbandonedFlight_GivesItsLinks()
    {
        ConsoleOptions options = Read(
            Service.Replace("search.json", "gone.json"), "--return-if-abandoned", "progress.json");

        Assert.Equal("udpout:127.0.0.1:9", Assert.Single(options.Links).ToString());
        Assert.Equal((byte)7, options.SystemId);
        Assert.False(options.Flies);
        Assert.Equal("progress.json", options.AbandonedStateFile);
    }

    [Fact]
    public void File_OfAReplay_IsPlayed()
    {
        File.WriteAllText(
            Config,
            $$"""{ "Uav": { "Links": [ "tlog:{{Flight}}?speed=max" ], "Health": { "BatteryLowFraction": 0.4 } } }""");
        using ConsoleProcess process = ConsoleProcess.RunIn(
            _folder, out int exitCode, "--config", Config, "--headless");

        Assert.True(exitCode == 0, process.ToString());
        Assert.Contains(process.Output, l => l.Contains("ardupilot-flight.tlog"));
    }

    [Theory]
    [InlineData("""{ "Uav": { "Helth": 1 } }""", "", "FILE: Uav:Helth is not known; there are: Autopilot, ")]
    [InlineData("""{ "Uav": { "SystemId": 300 } }""", "", "FILE: Uav:SystemId is '300'; it must be a whole number")]
    [InlineData("""{ "Uav": { "Links": [ "udp:1" ] } }""", "", "FILE: Uav:Links:0 is 'udp:1'; ")]
    [InlineData("""{ "Uav": { "Mission": "/nowhere/m.json" } }""", "", "FILE: Uav:Mission is '/nowhere/m.json'; ")]
    [InlineData("""{ "Uav": { "Without": "Health" } }""", "", "FILE: Uav:Without")]
    [InlineData("""{ "Uav": { "Health": { "BatteryLowFraction": 3 } } }""", "",
        "FILE: Uav:Health:BatteryLowFraction is 3")]
    [InlineData("""{ "Uav": { "MayCommand": true } }""", "--link udpout:127.0.0.1:9",
        "FILE: Uav:MayCommand needs --mission FILE: what to fly.")]
    [InlineData("""{ "Uav": { "MayCommand": true, "Seed": 1 } }""", "--link udpout:127.0.0.1:9 --mission MISSION",
        "FILE: Uav:MayCommand needs --camera DIR: ")]
    [InlineData("""{ "Uav": { "MayCommand": true } }""", "--link tlog:a",
        "FILE: Uav:MayCommand needs a live vehicle: a recorded flight is only replayed.")]
    [InlineData("""{ "Uva": { } }""", "", "--config FILE has no section Uav")]
    [InlineData("""{ "Uav": { } }""", "", "--config FILE has no section Uav, or nothing in it.")]
    [InlineData("""{ "Uav": { "Links": [ } }""", "", "--config FILE: line 1: '}' is an invalid start of a value.")]
    [InlineData("[ 1 ]", "", "--config FILE: Top-level JSON element must be an object.")]
    [InlineData("", "", "--config FILE: ")]
    [InlineData(null, "", "--config FILE cannot be read: ")]
    public void File_Wrong_IsOneLineWithFileAndKey(string? text, string arguments, string expected)
    {
        if (text is not null)
            File.WriteAllText(Config, text);
        string[] given = arguments.Replace("MISSION", Mission).Split([' '], StringSplitOptions.RemoveEmptyEntries);

        Assert.Contains(
            expected.Replace("FILE: Uav", Config + ": Uav").Replace("--config FILE", "--config " + Config),
            Assert.Single(CommandLineRun.Refuse(["--config", Config, .. given])));
    }

    private string Config => Path.Combine(_folder, "flight.json");

    private static string Service =>
        """
        {
          "Simulation": { "Enabled": false },
          "Uav": {
            "Links": [ "udpout:127.0.0.1:9" ], "SystemId": 7, "MayCommand": true, "Mission": "MISSION",
            "UploadsFence": true,
            "Autopilot": { "Setup": { "SetsFailsafes": true, "OriginalsFile": "own.json" } },
            "MissionControl": { "RequiresCamera": false, "OnStop": "Return", "ProgressFile": "p.json" },
            "GroundCommands": { "SystemIds": [ 254 ] },
            "Health": { "BatteryLowFraction": 0.3 }, "Preflight": { "Overrides": [ "disk" ] },
            "Communications": { "Recording": { "Folder": "logs" } }
          }
        }
        """.Replace("MISSION", Mission);

    private ConsoleOptions Read(string text, params string[] arguments)
    {
        File.WriteAllText(Config, text);
        return CommandLineRun.Read(["--config", Config, .. arguments]);
    }
}
