using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Links;
using Rabit.Tests.Shared;
using Rabit.Uav.Simulation.Tests.Sample;
using Xunit;

namespace Rabit.Tool.Tests.Simulate;

/// <summary><c>rabit simulate</c>, over UDP in real time.</summary>
public class SimulateCommandTests
{
    [Fact]
    public void Udp_GroundStationComesLate_IsConnectedAnsweredAndStoppedInOrder()
    {
        int port = FreePort.Udp();
        string truth = Path.Combine(Path.GetTempPath(), $"rabit-truth-{Guid.NewGuid():N}.json");
        using var vehicle = new SampleProcess(
            "Rabit.Tool", "simulate", "--link", $"udpout:127.0.0.1:{port}", "--seed", "3", "--truth-out", truth);
        Assert.False(vehicle.EndsWithin(TimeSpan.FromSeconds(2.5)), vehicle.Output);

        using (UdpListenLink ground = UdpListenLink.Open("127.0.0.1", port))
        {
            Await<Heartbeat>(ground);
            Send(
                ground,
                new CommandLong { TargetSystem = 1, TargetComponent = 1, Command = MavCmd.NavTakeoff, Param7 = 10 });
            CommandAck ack = Await<CommandAck>(ground);
            Assert.Equal((MavCmd.NavTakeoff, MavResult.Failed), (ack.Command, ack.Result));
        }

        vehicle.Interrupt();
        Assert.Equal(0, vehicle.WaitForEnd());
        Assert.Contains("STABILIZE, disarmed, on the ground", vehicle.Output, StringComparison.Ordinal);
        using JsonDocument document = JsonDocument.Parse(File.ReadAllText(truth));
        Assert.Equal(3, document.RootElement.GetProperty("seed").GetInt64());
        Assert.Equal(JsonValueKind.Null, document.RootElement.GetProperty("flight").ValueKind);
        Assert.Equal(5, document.RootElement.GetProperty("targets").GetArrayLength());
        File.Delete(truth);
    }

    // The line is written as soon as the program takes signals, before the vehicle runs.
    [Fact]
    public void Interrupt_RightAfterTheStart_EndsIt()
    {
        using var vehicle = new SampleProcess("Rabit.Tool", "simulate", "--link", $"udpout:127.0.0.1:{FreePort.Udp()}");
        vehicle.WaitUntil(() => vehicle.Output.Contains("Ctrl-C ends it", StringComparison.Ordinal));
        vehicle.Interrupt();
        Assert.Equal(0, vehicle.WaitForEnd());
    }

    // As SITL: the ground station connects to TCP port 5760.
    [Fact]
    public void TcpServerAndSystemId_StationsConnectOneAfterTheOther_HeartbeatsOfThatSystem()
    {
        int port = FreePort.Tcp();
        using var vehicle = new SampleProcess(
            "Rabit.Tool", "simulate", "--link", $"tcpin:127.0.0.1:{port}", "--system-id", "3", "--autopilot", "px4");
        vehicle.WaitUntil(() => vehicle.Output.Contains("Ctrl-C ends it", StringComparison.Ordinal));
        for (int station = 0; station < 2; station++)
        {
            using IByteLink ground = ReopeningLink.Open(LinkUrl.Parse($"tcp:127.0.0.1:{port}"));
            Assert.Equal(3, AwaitFrame<Heartbeat>(ground).SystemId);
        }

        vehicle.Interrupt();
        int code = vehicle.WaitForEnd();
        Assert.True(code == 0, $"exit code {code}: {vehicle.Output}");
    }

    [Theory]
    [InlineData("--link", "udp:1", "--link")]
    [InlineData("--link", "tlog:flight.tlog", "live link")]
    [InlineData("--targets", "many", "--targets many")]
    [InlineData("--wind", "-3", "0 to 25")]
    [InlineData("--target-kinds", "person,tank", "'tank' is no kind of target; there are coloured, white,")]
    [InlineData("--partly-hidden", "-1", "--partly-hidden -1")]
    [InlineData("--system-id", "255", "1 to 254")]
    [InlineData("--group", "1", "2 to 8")]
    [InlineData("--mission", "no-such-file.json", "no-such-file.json")]
    public void BadInput_IsOneLineAndExitCode2(string option, string value, string named)
    {
        using var vehicle = new SampleProcess("Rabit.Tool", "simulate", option, value);
        Assert.Equal(2, vehicle.WaitForEnd());
        Assert.StartsWith("rabit simulate: ", vehicle.Output, StringComparison.Ordinal);
        Assert.Contains(named == "--link" ? "udp:1" : named, vehicle.Output, StringComparison.Ordinal);
        Assert.DoesNotContain("\n", vehicle.Output, StringComparison.Ordinal);
    }

    [Fact]
    public void Group_SystemIdThatIsNoneOfThem_IsNamed()
    {
        using var vehicle = new SampleProcess("Rabit.Tool", "simulate", "--group", "2", "--system-id", "3");
        Assert.Equal(2, vehicle.WaitForEnd());
        Assert.Equal(
            "rabit simulate: --group 2: the vehicles have the system ids 1 to 2, not 3.", vehicle.Output.Trim());
    }

    [Fact]
    public void Group_TwoOfIt_HaveTheTargetsOfOneWorldAndStartApart()
    {
        JsonElement[] truths = [.. new[] { "1", "2" }.Select(Truth)];

        string Targets(JsonElement truth) => string.Join(
            " ", truth.GetProperty("targets").EnumerateArray().Select(
                t => FormattableString.Invariant($"{t.GetProperty("latitudeDegrees").GetDouble():0.000000}")));
        Assert.NotEmpty(Targets(truths[0]));
        Assert.Equal(Targets(truths[0]), Targets(truths[1]));
        Assert.NotEqual(
            truths[0].GetProperty("home").GetProperty("longitudeDegrees").GetDouble(),
            truths[1].GetProperty("home").GetProperty("longitudeDegrees").GetDouble(), 6);
    }

    private static JsonElement Truth(string systemId)
    {
        string file = Path.Combine(Path.GetTempPath(), $"rabit-truth-{Guid.NewGuid():N}.json");
        using var vehicle = new SampleProcess(
            "Rabit.Tool", "simulate", "--link", $"udpout:127.0.0.1:{FreePort.Udp()}", "--group", "2",
            "--system-id", systemId, "--truth-out", file);
        vehicle.WaitUntil(() => vehicle.Output.Contains("on the ground", StringComparison.Ordinal));
        vehicle.Interrupt();
        Assert.Equal(0, vehicle.WaitForEnd());
        JsonElement truth = JsonDocument.Parse(File.ReadAllText(file)).RootElement.Clone();
        File.Delete(file);
        return truth;
    }

    private static void Send<T>(UdpListenLink link, T message)
        where T : struct, IMavlinkMessage
    {
        byte[] bytes = new byte[MavlinkFrame.MaxWireLength];
        link.Write(bytes, 0, MavlinkFrame.Create(message, 255, 190, 0).WriteTo(bytes));
    }

    private static T Await<T>(UdpListenLink link)
        where T : struct, IMavlinkMessage
    {
        var clock = Stopwatch.StartNew();
        byte[] bytes = new byte[2048];
        while (clock.Elapsed < TestTimeout.Limit)
        {
            // One datagram is one frame.
            LinkRead read = link.Read(bytes);
            var reader = new MavlinkFrameReader(MavlinkDialect.All);
            var rest = new ReadOnlySpan<byte>(bytes, 0, read.Count);
            if (reader.TryRead(ref rest, out MavlinkFrame frame, out _) && frame.TryDecode(out T message))
                return message;
        }

        throw new Xunit.Sdk.XunitException($"no {typeof(T).Name}");
    }

    private static MavlinkFrame AwaitFrame<T>(IByteLink link)
        where T : struct, IMavlinkMessage
    {
        var clock = Stopwatch.StartNew();
        byte[] bytes = new byte[2048];
        var reader = new MavlinkFrameReader(MavlinkDialect.All);
        while (clock.Elapsed < TestTimeout.Limit)
        {
            LinkRead read = link.Read(bytes);
            var rest = new ReadOnlySpan<byte>(bytes, 0, read.Count);
            while (reader.TryRead(ref rest, out MavlinkFrame frame, out _))
            {
                if (frame.TryDecode(out T _))
                    return frame;
            }
        }

        throw new Xunit.Sdk.XunitException($"no {typeof(T).Name}");
    }
}
