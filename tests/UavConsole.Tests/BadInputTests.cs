using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Net;
using System.Net.Sockets;
using System.Text;
using Rabit.Tests.Shared;
using Rabit.Uav.Tests.Communications;
using Rabit.Uav.Tests;
using Xunit;

namespace UavConsole.Tests;

/// <summary>Bad input is one clear line, exit code 2, and nothing left behind.</summary>
public sealed class BadInputTests : IDisposable
{
    private readonly TestLog _log = new("empty.tlog");
    private readonly string _summary;

    public BadInputTests() => _summary = Path.Combine(_log.Folder, "summary.json");

    [Theory]
    [InlineData("--bogus", "'--bogus'")]
    [InlineData("extra", "'extra'")]
    [InlineData("--link", "'--link'")]
    [InlineData("--link ftp:host:1", "link 'ftp:host:1': the scheme 'ftp' is unknown; write udpin:ADDRESS:PORT")]
    [InlineData("--link tlog:x?speed=fast",
        "the speed 'fast' is not a positive number or max; write tlog:FILE[?speed=10|max]")]
    [InlineData("--link tlog:x?speed=0", "the speed '0' is not a positive number or max")]
    [InlineData("--link udpin:0.0.0.0:70000",
        "the port '70000' is not a number from 1 to 65535; write udpin:ADDRESS:PORT")]
    [InlineData("--link tlog:/nowhere/a.tlog", "link tlog:/nowhere/a.tlog: no such file")]
    [InlineData("--link tlog:/proc/self/mem", "link tlog:/proc/self/mem: the file cannot be read: ")]
    [InlineData("--link serial:/dev/null:57600", "this is not a serial device")]
    [InlineData("--system-id 0", "--system-id 0: it must be a number from 1 to 255.")]
    [InlineData("--system-id 256", "--system-id 256: it must be a number from 1 to 255.")]
    [InlineData("--link tlog:a?speed=10 --link udpin:127.0.0.1:14550",
        "tlog:a?speed=10 plays at another pace than udpin:127.0.0.1:14550")]
    [InlineData("--link tlog:a --link tlog:a", "link tlog:a is given 2 times.")]
    [InlineData("--fly", "--fly commands a real vehicle: it needs --link URL and --mission FILE")]
    [InlineData("--fly --mission a.json", "--fly commands a real vehicle: it needs --link URL and --mission FILE")]
    [InlineData("--camera pictures", "--camera needs --link URL")]
    [InlineData("--truth truth.json", "--truth needs --link URL")]
    [InlineData("--terrain grid.asc", "--terrain needs --link URL: the ground of the simulation is level.")]
    [InlineData("--link udpin:127.0.0.1:14550 --terrain grid.asc",
        "--terrain gives a mission its heights: it needs --mission FILE --fly.")]
    [InlineData("--link udpin:127.0.0.1:14550 --fly", "--fly needs --mission FILE")]
    [InlineData("--link udpin:127.0.0.1:14550 --seed 3", "--seed is for the simulation")]
    [InlineData("--link udpin:127.0.0.1:14550 --moving 1", "--moving is for the simulation")]
    [InlineData("--link udpin:127.0.0.1:14550 --picture-effects harsh", "--picture-effects is for the simulation")]
    [InlineData("--link udpin:127.0.0.1:14550 --gimbal north", "--gimbal is for the simulation")]
    [InlineData("--link udpin:127.0.0.1:14550 --targets 3", "--targets is for the simulation")]
    [InlineData("--link udpin:127.0.0.1:14550 --realtime", "--realtime is for the simulation")]
    [InlineData("--link udpin:127.0.0.1:14550 --truth a.json",
        "--truth scores a mission: it needs --mission FILE --fly.")]
    [InlineData("--link tlog:a --mission a.json --fly",
        "--fly needs a live vehicle: a recorded flight is only replayed. --mission needs a live vehicle")]
    [InlineData("--link tlog:a --camera pictures", "--camera needs a live vehicle")]
    [InlineData("--link udpin:127.0.0.1:14550 --mission /nowhere/a.json --fly --without-detection",
        "--mission /nowhere/a.json cannot be read: ")]
    [InlineData("--link udpin:127.0.0.1:14550 --mission a.json --fly",
        "--fly needs --camera DIR: a search without pictures finds nothing; --without-detection flies all the same.")]
    [InlineData("--link udpin:127.0.0.1:14550 --mission a.json --fly --camera b --without-detection",
        "--without-detection does not go with --camera.")]
    [InlineData("--fixed-wing 80", "--fixed-wing commands a real vehicle: it goes with --link URL --mission FILE --fly.")]
    [InlineData("--fixed-wing 5", "--fixed-wing 5: it must be the radius of its circles, 20 to 400 m.")]
    [InlineData("--set-failsafes", "--set-failsafes goes with --mission FILE --fly.")]
    [InlineData("--link udpin:127.0.0.1:14550 --upload-fence", "--upload-fence goes with --mission FILE --fly.")]
    [InlineData("--link udpin:127.0.0.1:14550 --override disk", "--override goes with --mission FILE --fly.")]
    [InlineData("--override FS_GCS", "Overrides has 'FS_GCS', which no line of the pre-flight checklist has")]
    [InlineData("--return-if-abandoned a.json", "--return-if-abandoned needs --link URL of a live vehicle.")]
    [InlineData("--sign-key /nowhere/key", "Signing key /nowhere/key: ")]
    [InlineData("--link udpin:127.0.0.1:14550 --trust-link 0", "--trust-link needs --sign-key FILE")]
    [InlineData("--link tlog:a --sign-key key", "--sign-key needs a live vehicle")]
    [InlineData("--seed -1", "--seed -1: it must be a whole number, 0 or more.")]
    [InlineData("--seed x", "--seed x: it must be a whole number, 0 or more.")]
    [InlineData("--resume /nowhere/p.json", "--resume: Progress file '/nowhere/p.json': it cannot be read: ")]
    [InlineData("--progress /nowhere/p.json", "--progress /nowhere/p.json cannot be written: ")]
    [InlineData("--progress /dev/null", "--progress /dev/null cannot be written: it is a device.")]
    [InlineData("--link udpin:127.0.0.1:14550 --allow-partial-search",
        "--allow-partial-search goes with a mission that is flown: --mission FILE --fly.")]
    [InlineData("--export flight.gpx", "--export flight.gpx: its name must end in .geojson, .kml or .csv.")]
    [InlineData("--export /nowhere/flight.kml", "--export /nowhere/flight.kml cannot be written: ")]
    [InlineData("--export a.csv --export a.csv", "--export and --export are the same file a.csv.")]
    [InlineData("--operator  ", "--operator: a name has 1 to 100 characters.")]
    [InlineData("--px4-events a.json", "--px4-events needs --link URL")]
    [InlineData("--link udpin:127.0.0.1:14550 --px4-events /nowhere/e.json",
        "--px4-events /nowhere/e.json cannot be read: ")]
    [InlineData("--moving 51", "--moving 51: it must be a number from 0 to 50.")]
    [InlineData("--target-kinds coloured,tank",
        "--target-kinds: 'tank' is no kind of target; there are coloured, white, black, two-coloured, person, "
        + "car, aruco, apriltag.")]
    [InlineData("--partly-hidden -1", "--partly-hidden -1: it must be a number from 0 to 50.")]
    [InlineData("--occluders many", "--occluders many: it must be a number from 0 to 50.")]
    [InlineData("--link udpin:127.0.0.1:14550 --target-kinds aruco", "--target-kinds is for the simulation")]
    [InlineData("--link udpin:127.0.0.1:14550 --partly-hidden 1", "--partly-hidden is for the simulation")]
    [InlineData("--moving 3 --targets 2", "--moving is more than there are targets")]
    [InlineData("--targets 51", "--targets 51: it must be a number from 0 to 50.")]
    public void CommandLine_BadInput_IsOneLineAndExitCode2(string arguments, string expected)
        => AssertRefused(expected, arguments.Split(' '));

    // One of each place that refuses: the parser, the options together, the flight, the flight of a group.
    [Theory]
    [InlineData("--bogus", "'--bogus'")]
    [InlineData("--moving 3 --targets 2", "--moving is more than there are targets")]
    [InlineData("--progress /nowhere/p.json", "--progress /nowhere/p.json cannot be written: ")]
    [InlineData("--vehicles 8", "vehicle 6: Mission Control: Mission in layer 5, 100.0 m above layer 0: heightMetres ")]
    public void Program_BadInput_WritesOneLineToStandardErrorAndNothingElse(string arguments, string expected)
    {
        using ConsoleProcess process = ConsoleProcess.RunIn(_log.Folder, out int exitCode, arguments.Split(' '));
        Assert.Equal(2, exitCode);
        Assert.Contains(expected, Assert.Single(process.Errors));
        Assert.Empty(process.Output);
        Assert.Equal([_log.Path], Directory.GetFiles(_log.Folder));
    }

    [Fact]
    public void Mission_HomeFarFromTheArea_IsSaidBeforeTheStart()
    {
        string mission = Path.Combine(_log.Folder, "far.json");
        string folder = Path.GetDirectoryName(typeof(BadInputTests).Assembly.Location)!;
        File.WriteAllText(
            mission,
            File.ReadAllText(Path.Combine(folder, "missions", "search.json")).Replace("47.396970", "46.396970"));

        AssertRefused($"--mission {mission}: home is 111.2 km from the area; the limit is 5 km.", "--mission", mission);
    }

    [Fact]
    public void Link_EmptyFile_SaysSo() => AssertRefused($"link {_log.Url}: the file is empty", "--link", _log.Url);

    [Fact]
    public void Link_Folder_SaysSo()
        => AssertRefused($"link tlog:{_log.Folder}: that is a folder", "--link", "tlog:" + _log.Folder);

    [Fact]
    public void Link_FileWithoutOneRecord_SaysSo()
    {
        _log.Raw(Encoding.ASCII.GetBytes(string.Concat(Enumerable.Repeat("This is prose, not a log.\n", 500))));

        AssertRefused($"link {_log.Url}: no intact record in it: it is no telemetry log", "--link", _log.Url);
    }

    [Fact]
    public void Link_PortInUse_SaysSo()
    {
        using var taken = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        taken.SetSocketOption(SocketOptionLevel.Socket, SocketOptionName.ReuseAddress, false);
        taken.Bind(new IPEndPoint(IPAddress.Loopback, 0));
        string url = $"udpin:127.0.0.1:{((IPEndPoint)taken.LocalEndPoint!).Port}";

        AssertRefused($"link {url}: cannot listen: the port is in use by another program", "--link", url);
    }

    [Fact]
    public void Link_UnknownHost_SaysSo()
        => AssertRefused("link tcp:no-such-host.invalid:5760: the ", "--link", "tcp:no-such-host.invalid:5760");

    [Theory]
    [InlineData("/nowhere/summary.json")]
    [InlineData("/proc/self")]
    [InlineData("")]
    public void Summary_CannotBeWritten_IsSaidBeforeTheRun(string path)
    {
        string log = TestData.PathOf("px4-flight.tlog");
        using ConsoleProcess process = ConsoleProcess.Run(
            out int exitCode, "--link", $"tlog:{log}?speed=max", "--headless", "--summary", path);

        Assert.Equal(2, exitCode);
        Assert.Contains($"--summary {path} cannot be written: ", Assert.Single(process.Errors));
        Assert.Empty(process.Output);
    }

    [Fact]
    public void Summary_DiskFull_IsOneLineAndExitCode2()
    {
        _log.Record(0, Frames.Heartbeat());
        using ConsoleProcess process = ConsoleProcess.Run(
            out int exitCode, "--link", _log.Url + "?speed=max", "--headless", "--summary", "/dev/full");

        Assert.Equal(2, exitCode);
        Assert.Contains("--summary /dev/full cannot be written: ", Assert.Single(process.Errors));
        Assert.Contains(process.Output, l => l.StartsWith("--- summary", StringComparison.Ordinal));
    }

    [Fact]
    public void Summary_IsTheLogItself_LeavesTheLogAlone()
    {
        _log.Record(0, Frames.Heartbeat());
        byte[] before = File.ReadAllBytes(_log.Path);

        AssertRefused(
            "it is the log that is played.", "--link", _log.Url + "?speed=max", "--summary",
            Path.Combine(_log.Folder, ".", "empty.tlog"));

        Assert.Equal(before, File.ReadAllBytes(_log.Path));
    }

    [Fact]
    public void Truth_CannotBeRead_SaysSo()
    {
        string mission = Path.Combine(
            Path.GetDirectoryName(typeof(BadInputTests).Assembly.Location)!, "missions", "search.json");

        AssertRefused(
            "--truth /nowhere/t.json cannot be read: ",
            "--link", $"udpin:127.0.0.1:{FreePort.Udp()}", "--mission", mission, "--fly",
            "--without-detection", "--truth", "/nowhere/t.json");
    }

    [Fact]
    public void Terrain_WrongFile_SaysWhere()
    {
        string mission = Path.Combine(
            Path.GetDirectoryName(typeof(BadInputTests).Assembly.Location)!, "missions", "search.json");
        string grid = Path.Combine(_log.Folder, "grid.asc");
        File.WriteAllText(grid, "ncols 2\nnrows 2\nxllcenter 8\nyllcenter 47\ncellsize 0.01\n1 2\n3 x\n");
        string link = $"udpin:127.0.0.1:{FreePort.Udp()}";

        AssertRefused(
            "--terrain /nowhere/grid.asc cannot be read: ",
            "--link", link, "--mission", mission, "--fly", "--without-detection", "--terrain", "/nowhere/grid.asc");
        AssertRefused(
            $"--terrain {grid}: Line 7 of the grid: 'x' is not a height",
            "--link", link, "--mission", mission, "--fly", "--without-detection", "--terrain", grid);
    }

    [Fact]
    public void Camera_NoSuchFolder_SaysSo()
        => AssertRefused(
            "--camera /nowhere/pictures: no such folder", "--link", $"udpin:127.0.0.1:{FreePort.Udp()}", "--camera",
            "/nowhere/pictures");

    [Theory]
    [InlineData("--summary")]
    [InlineData("--report")]
    [InlineData("--log")]
    public void Output_IsTheMission_SaysSoAndDoesNotTouchIt(string option)
    {
        string mission = Path.Combine(_log.Folder, "field.json");
        File.Copy(
            Path.Combine(Path.GetDirectoryName(typeof(BadInputTests).Assembly.Location)!, "missions", "search.json"),
            mission);
        byte[] before = File.ReadAllBytes(mission);

        AssertRefused(
            $"--mission and {option} are the same file", "--mission", mission, option,
            Path.Combine(_log.Folder, ".", "field.json"));

        Assert.Equal(before, File.ReadAllBytes(mission));
    }

    [Theory]
    [InlineData("--summary")]
    [InlineData("--report")]
    [InlineData("--log")]
    public void Output_IsTheSigningKey_SaysSoAndDoesNotTouchIt(string option)
    {
        string key = Path.Combine(_log.Folder, "key");
        File.WriteAllText(key, new string('a', 64));

        AssertRefused(
            $"--sign-key and {option} are the same file", "--sign-key", key, option,
            Path.Combine(_log.Folder, ".", "key"));

        Assert.Equal(new string('a', 64), File.ReadAllText(key));
    }

    [Fact]
    public void Files_TheSameTwice_SaysSo()
    {
        _log.Record(0, Frames.Heartbeat());

        AssertRefused(
            "--report and --log are the same file", "--link", _log.Url, "--report", _summary + "x", "--log",
            _summary + "x");
    }

    public void Dispose() => _log.Dispose();

    private void AssertRefused(string expected, params string[] arguments)
    {
        IEnumerable<string> all = arguments.Contains("--summary") || arguments.Last() == "--link"
            ? arguments
            : arguments.Concat(["--summary", _summary]);

        string line = Assert.Single(CommandLineRun.Refuse(all.ToArray()));
        Assert.StartsWith("UavConsole: ", line, StringComparison.Ordinal);
        Assert.Contains(expected, line);
        Assert.False(File.Exists(_summary), "It leaves a summary behind.");
    }
}
