using System;
using System.IO;
using Rabit.Uav.Tests.Communications;
using Xunit;

namespace UavConsole.Tests;

/// <summary>Several simulated vehicles, as a user starts them.</summary>
public sealed class GroupTests : IDisposable
{
    private readonly TestLog _folder = new();

    [Fact]
    public void Vehicles_Two_SearchTogetherAndLeaveAReportOfTheGroupAndOneEach()
    {
        string mission = Path.Combine(_folder.Folder, SmallMission.WriteTo(_folder.Folder));
        const string Colours = "\"red\", \"orange\", \"blue\", \"yellow\", \"magenta\"";
        string text = File.ReadAllText(mission).Replace("24", "12");
        File.WriteAllText(mission, text.Replace("\"red\"", Colours));

        using ConsoleProcess console = ConsoleProcess.RunIn(
            _folder.Folder, out int exitCode, "--headless", "--vehicles", "2", "--targets", "1", "--mission", mission,
            "--report", "r.html", "--command", "0:2:return", "--command", "30:all:hold", "--command", "33:all:continue",
            "--command", "2000:2:land");

        // All was done but two commands: one came before any vehicle was received, one too late.
        Assert.True(exitCode == 2, console.ToString());
        Assert.Equal(2, console.Errors.Count);
        Assert.Contains(
            "UavConsole: --command 0:2:return was obeyed by no vehicle: no vehicle was received yet.", console.Errors);
        Assert.Single(console.Errors, e => e.StartsWith(
            "UavConsole: --command 2000:2:land was not given: the flight was over after ", StringComparison.Ordinal));
        Assert.Contains("--- summary of 2 vehicles ---", console.Output);
        Assert.Contains("mission: ACCOMPLISHED", console.Output);
        Assert.Contains("1 of 1 targets found, 0 false", string.Join("\n", console.Output));
        Assert.Single(console.Output, l => l.Contains(": found by vehicle ")
            && l.EndsWith(" confirmed", StringComparison.Ordinal));
        foreach (string command in new[] { "hold", "continue" })
        {
            Assert.Single(
                console.Output, l => l.StartsWith("station 255: ", StringComparison.Ordinal)
                    && l.EndsWith($"{command} of all: accepted by 1, 2", StringComparison.Ordinal));
        }

        string group = File.ReadAllText(Path.Combine(_folder.Folder, "r.html"));
        Assert.Contains("Mission accomplished", group);
        Assert.Contains("confirmed</dd>", group);
        for (int vehicle = 1; vehicle <= 2; vehicle++)
        {
            string page = File.ReadAllText(Path.Combine(_folder.Folder, $"r-vehicle-{vehicle}.html"));
            Assert.Contains($"vehicle {vehicle} of 2", page);
            Assert.Contains($"href=\"r-vehicle-{vehicle}.html\"", group);
        }
    }

    [Fact]
    public void Terminate_InTheMiddle_IsAFailedMissionWithItsReports()
    {
        using ConsoleProcess console = ConsoleProcess.StartIn(
            _folder.Folder, "--headless", "--realtime", "--vehicles", "2", "--targets", "0", "--report", "cut.html");
        console.WaitFor("mission control: vehicle 1 is in the group");

        console.Signal(ConsoleProcess.Terminate);

        Assert.Equal(1, console.WaitForEnd());
        Assert.Empty(console.Errors);
        const string Stopped = "the run was stopped before its end: SIGTERM";
        Assert.Contains("  failed: " + Stopped, console.Output);
        Assert.Contains(Stopped, File.ReadAllText(Path.Combine(_folder.Folder, "cut.html")));
        Assert.Contains("Mission failed", File.ReadAllText(Path.Combine(_folder.Folder, "cut-vehicle-2.html")));
    }

    // The reports of the vehicles have names beside that of a file; beside a device there is no room.
    [Theory]
    [InlineData("/dev/null", 1)]
    [InlineData("r.html", 3)]
    public void Reports_OfTwoVehicles_AreBesideThatOfTheGroupUnlessItIsADevice(string report, int expected)
    {
        string path = Path.Combine(_folder.Folder, report);
        using RunFiles files = RunFiles.Open(new ConsoleOptions { Vehicles = 2, ReportFile = path }, mission: null);
        Assert.Equal(expected, files.Reports.Count);
    }

    // The simulated camera shows the smallest target of the bundled mission from 75 m or less.
    [Theory]
    [InlineData(2, null, 40)]
    [InlineData(3, null, 35)]
    [InlineData(3, 19.0, 35)]
    public void Open_Vehicles_TheLayersBeginSoLowThatTheThirdSeesTheSmallestTarget(
        int vehicles, double? spacingMetres, double heightMetres)
    {
        using GroupFlight flight = GroupFlight.Open(
            new ConsoleOptions { Vehicles = vehicles, LayerSpacingMetres = spacingMetres }, log: null);
        Assert.Equal(heightMetres, flight.Mission.HeightMetres);
    }

    [Theory]
    [InlineData("--vehicles 0", "--vehicles 0: it must be a number from 1 to 8.")]
    [InlineData("--vehicles 3 --web", "--web is for one vehicle; it does not go with --vehicles.")]
    [InlineData("--vehicles 2 --link udpin:127.0.0.1:14599", "--vehicles is for the simulation;")]
    [InlineData("--vehicles 2 --layer-spacing 18", "--layer-spacing 18: it must be a number of metres from 19 to 100: "
        + "15 m of separation, and the errors of heights.")]
    [InlineData("--vehicles 2 --system-id 7", "--system-id is for one vehicle; it does not go with --vehicles.")]
    [InlineData("--vehicles 2 --bell", "--bell is for one vehicle; it does not go with --vehicles.")]
    [InlineData("--vehicles 2 --on-stop return", "--on-stop is for one vehicle; it does not go with --vehicles.")]
    [InlineData("--vehicles 1 --link udpin:127.0.0.1:14599", "--vehicles is for the simulation;")]
    [InlineData("--vehicles 2 --report a.html --log a-vehicle-2.html", "--report and --log are the same file "
        + "a-vehicle-2.html.")]
    [InlineData("--layer-spacing 20", "--layer-spacing needs --vehicles 2 or more, or --group-layer.")]
    [InlineData("--vehicles 1 --layer-spacing 20", "--layer-spacing needs --vehicles 2 or more, or --group-layer.")]
    [InlineData("--command 5:1:hold", "--command needs --vehicles 2 or more:")]
    [InlineData("--vehicles 2 --command 5:0:hold", "--command 5:0:hold: it must be SECONDS:VEHICLE:COMMAND with")]
    [InlineData("--vehicles 2 --command 5:all:reject=1", "--command 5:all:reject=1: it must be")]
    [InlineData("--vehicles 2 --command NaN:1:hold", "--command NaN:1:hold: it must be")]
    [InlineData("--vehicles 2 --command 5:3:hold", "--command 5:3:hold: there is no vehicle 3; --vehicles 2 has the "
        + "vehicles 1 to 2.")]
    [InlineData("--vehicles 8", "vehicle 6: Mission Control: Mission in layer 5, 100.0 m above layer 0: heightMetres "
        + "is 135; it must be 5 to 120; with 20.0 m from one layer to the next there is room for 5 vehicles, in layers "
        + "0 to 4.")]
    [InlineData("--group-layer 1 --fixed-wing 60", "--fixed-wing does not go with --group-layer.")]
    [InlineData("--group-layer 1", "--group-layer needs --link URL, --mission FILE and --fly;")]
    [InlineData("--group-layer 9", "--group-layer 9: it must be a number from 0 to 7.")]
    public void Options_ThatMakeNoSense_AreNamed(string arguments, string expected)
        => Assert.Contains(expected, Assert.Single(CommandLineRun.Refuse(arguments.Split(' '))));

    public void Dispose() => _folder.Dispose();
}
