using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Net;
using System.Net.Sockets;
using System.Text.Json;
using System.Threading.Tasks;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Links;
using Rabit.Tests.Shared;
using Rabit.Uav.Tests.Communications;
using Rabit.Uav.Tests;
using Xunit;

namespace UavConsole.Tests;

/// <summary>UavConsole on a live link, and how it ends.</summary>
public sealed class LiveLinkTests : IDisposable
{
    private static readonly TimeSpan OneSecond = TimeSpan.FromSeconds(1);

    private readonly TestLog _folder = new();
    private readonly string _summary;
    private readonly int _port = FreePort.Udp();

    public LiveLinkTests() => _summary = Path.Combine(_folder.Folder, "summary.json");

    [Theory]
    [InlineData("ardupilot-flight", 20, "GUIDED")]
    [InlineData("px4-flight", 6, "AUTO.TAKEOFF")]
    public void LiveSender_FirstSeconds_IsSeenAndAnswered(string flight, int seconds, string mode)
        => Fly(flight, TimeSpan.FromSeconds(seconds), mode);

    [Fact]
    [Trait("Category", "Long")]
    public void LiveSender_WholeFlight_IsSeenAndAnswered() => Fly("ardupilot-flight", TimeSpan.FromHours(1), "RTL");

    [Fact]
    public void Link_StaysSilent_IsSaidWhileTheProgramGoesOn()
    {
        using ConsoleProcess console = Start();

        Assert.Contains($"udpin:127.0.0.1:{_port}", console.WaitFor("nothing received yet"));
        console.WaitFor("Waiting: 0 frames in");
        using (var aircraft = new LiveFlight(_port))
        {
            aircraft.Send(Frames.Heartbeat());
            console.WaitFor("autopilot: autopilot Ardupilotmega of a Quadrotor, system 1, component 1");
        }

        console.Signal(ConsoleProcess.Interrupt);
        Assert.Equal(0, console.WaitForEnd());
        Assert.Contains("no autopilot detected yet", string.Join("\n", console.Output));
    }

    [Fact]
    public void Link_HostRefusesClosesAndComesBack_IsSaidAndConnectedAgain()
    {
        int port = FreePort.Tcp();
        using ConsoleProcess console = ConsoleProcess.Start("--headless", "--link", $"tcp:127.0.0.1:{port}");
        console.WaitFor($"link tcp:127.0.0.1:{port} is not open, and is tried again");

        using (TcpClient connected = Accept(port))
        {
            byte[] heartbeat = Frames.Heartbeat();
            connected.GetStream().Write(heartbeat, 0, heartbeat.Length);
            console.WaitFor("autopilot: autopilot Ardupilotmega of a Quadrotor, system 1, component 1");
        }

        using TcpClient again = Accept(port);
        console.Signal(ConsoleProcess.Interrupt);
        Assert.Equal(0, console.WaitForEnd());
    }

    [Theory]
    [InlineData(ConsoleProcess.Interrupt, "Ctrl-C")]
    [InlineData(ConsoleProcess.Terminate, "SIGTERM")]
    public void Signal_EndsWithinASecondWithTheSummary(int signal, string reason)
    {
        Stopwatch clock = Stopwatch.StartNew();
        using (ConsoleProcess console = Start())
        {
            TimeSpan start = clock.Elapsed;
            clock.Restart();
            console.Signal(signal);
            int exitCode = console.WaitForEnd();
            TimeSpan took = clock.Elapsed;

            // The start shows how busy the machine is: an idle one takes less than a third of a second for it.
            TimeSpan limit = new[] { start + start + start, OneSecond }.Max();

            Assert.True(exitCode == 0, console.ToString());
            Assert.Contains($"--- summary: {reason} ---", console.Output);
            Assert.Contains("no autopilot was connected", console.Output);
            Assert.InRange(took, TimeSpan.Zero, limit);
            Assert.Empty(console.Errors);
        }

        using JsonDocument summary = JsonDocument.Parse(File.ReadAllText(_summary));
        Assert.Equal(reason, summary.RootElement.GetProperty("run").GetProperty("stopReason").GetString());
        Assert.Equal(JsonValueKind.Null, summary.RootElement.GetProperty("autopilot").ValueKind);
        Assert.Equal(
            JsonValueKind.Null,
            summary.RootElement.GetProperty("globalPositionInt").GetProperty("latitudeDegE7").ValueKind);
        using UdpListenLink again = UdpListenLink.Open("127.0.0.1", _port);
    }

    [Theory]
    [InlineData("")]
    [InlineData("?speed=10")]
    public void Signal_InTheMiddleOfAReplay_EndsWithTheSummaryAndExitCode0(string speed)
    {
        using ConsoleProcess console = ConsoleProcess.Start(
            "--headless", "--summary", _summary, "--link", $"tlog:{TestData.PathOf("px4-flight.tlog")}{speed}");
        console.WaitFor("autopilot: autopilot Px4 of a Quadrotor");

        console.Signal(ConsoleProcess.Interrupt);

        Assert.True(console.WaitForEnd() == 0, console.ToString());
        Assert.Contains("--- summary: Ctrl-C ---", console.Output);
        using JsonDocument summary = JsonDocument.Parse(File.ReadAllText(_summary));
        Assert.Equal(0, summary.RootElement.GetProperty("links")[0].GetProperty("framesDroppedIn").GetInt64());
    }

    [Fact]
    public void SecondLinkWithoutAPeer_DoesNotFloodThePlainLines()
    {
        using ConsoleProcess console = ConsoleProcess.Start(
            "--headless", "--link", $"udpin:127.0.0.1:{_port}", "--link", $"udpin:127.0.0.1:{FreePort.Udp()}");
        console.WaitForStart();
        using (var aircraft = new LiveFlight(_port))
            aircraft.Play("px4-flight", TimeSpan.FromSeconds(5));
        console.Signal(ConsoleProcess.Terminate);

        Assert.Equal(0, console.WaitForEnd());
        Assert.InRange(console.Output.Count(l => l.Contains("health: ")), 1, 8);
    }

    public void Dispose() => _folder.Dispose();

    private static TcpClient Accept(int port)
    {
        var server = new TcpListener(IPAddress.Loopback, port);
        server.Server.SetSocketOption(SocketOptionLevel.Socket, SocketOptionName.ReuseAddress, true);
        server.Start();
        Task<TcpClient> accept = server.AcceptTcpClientAsync();
        Assert.True(accept.Wait(TestTimeout.Limit), "no connection");
        server.Stop();
        return accept.Result;
    }

    private ConsoleProcess Start()
    {
        ConsoleProcess console = ConsoleProcess.Start(
            "--headless", "--summary", _summary, "--link", $"udpin:127.0.0.1:{_port}");
        console.WaitForStart();
        return console;
    }

    private void Fly(string flight, TimeSpan length, string mode)
    {
        using ConsoleProcess console = Start();
        using var aircraft = new LiveFlight(_port);
        aircraft.Play(flight, length);
        console.Signal(ConsoleProcess.Interrupt);
        Assert.True(console.WaitForEnd() == 0, console.ToString());

        using JsonDocument document = JsonDocument.Parse(File.ReadAllText(_summary));
        JsonElement summary = document.RootElement;
        JsonElement link = summary.GetProperty("links")[0];
        Assert.Equal((aircraft.Sent, 0L, 0L), (link.GetProperty("frames").GetInt64(),
            link.GetProperty("framesDroppedIn").GetInt64(), link.GetProperty("bytesLost").GetInt64()));
        Assert.Equal(0, link.GetProperty("sources")[0].GetProperty("missing").GetInt64());
        Assert.Contains(
            mode, summary.GetProperty("modeChanges").EnumerateArray().Select(c => c.GetProperty("mode").GetString()));

        Assert.Contains(aircraft.Received, f => f.MessageId == Heartbeat.MavlinkId);
        Assert.Contains(aircraft.Received, f => f.MessageId == CommandLong.MavlinkId);
        Assert.All(aircraft.Received, AssertObservesOnly);
        Assert.Equal(
            Enumerable.Range(0, aircraft.Received.Count).Select(n => (byte)n),
            aircraft.Received.Select(f => f.Sequence));
    }

    // Our heartbeat, position, texts, the state of the computer, questions for the time, answers to PING, requests for
    // message rates and for AUTOPILOT_VERSION in both their forms, and nothing else that could move an aircraft.
    private static void AssertObservesOnly(MavlinkFrame frame)
    {
        Assert.Equal((1, 191), (frame.SystemId, frame.ComponentId));
        if (frame.TryDecode(out Heartbeat heartbeat))
        {
            Assert.Equal((MavType.OnboardController, MavAutopilot.Invalid), (heartbeat.Type, heartbeat.Autopilot));
            return;
        }

        if (frame.MessageId is Timesync.MavlinkId or GlobalPositionInt.MavlinkId or Statustext.MavlinkId
            or OnboardComputerStatus.MavlinkId)
        {
            return;
        }

        if (frame.TryDecode(out Ping ping))
        {
            Assert.Equal((1, 1), ((int)ping.TargetSystem, (int)ping.TargetComponent));
            return;
        }

        Assert.True(frame.TryDecode(out CommandLong command), frame.ToString());
        Assert.Equal((1, 1), ((int)command.TargetSystem, (int)command.TargetComponent));
        if (command.Command == MavCmd.RequestMessage)
            Assert.Equal(AutopilotVersion.MavlinkId, (int)command.Param1);
        else
            Assert.Contains(command.Command, new[] { MavCmd.SetMessageInterval, MavCmd.RequestAutopilotCapabilities });
    }
}
