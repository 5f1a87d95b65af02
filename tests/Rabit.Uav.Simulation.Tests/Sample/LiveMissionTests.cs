using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Net;
using System.Net.Sockets;
using System.Text.Json;
using Rabit.Mavlink;
using Rabit.Tests.Shared;
using Rabit.Uav.Simulation.Tests.Missions;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Sample;

/// <summary>
/// UavConsole flies "rabit simulate", two processes in real time, with UDP and a folder of pictures between them.
/// </summary>
[Trait("Category", "Long")]
public sealed class LiveMissionTests(ITestOutputHelper output) : IDisposable
{
    private static readonly TimeSpan MissionTimeout = TimeSpan.FromMinutes(5);

    private readonly string _folder =
        Directory.CreateDirectory(Path.Combine(Path.GetTempPath(), $"rabit-live-{Guid.NewGuid():N}")).FullName;

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Mission_OverUdp_IsFlownAndScored(bool isSigned)
    {
        string[] signing = isSigned
            ? ["--sign-key", Write("key", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad")]
            : [];
        string mission = Write("mission.json", SearchFlight.SmallMission);
        string truth = In("truth.json");
        string summary = In("summary.json");
        int port = FreePort.Udp();
        using var vehicle = new SampleProcess(
            "Rabit.Tool",
            ["simulate", .. signing, "--link", $"udpout:127.0.0.1:{port}", "--mission", mission, "--targets", "2", "--seed", "5",
            "--camera-out", In("pictures"), "--truth-out", truth]);
        vehicle.WaitUntil(
            () => File.Exists(In("pictures/camera.json")) && File.Exists(truth) && new FileInfo(truth).Length > 0);

        using var console = new SampleProcess(
            "UavConsole",
            [.. signing, "--link", $"udpin:127.0.0.1:{port}", "--mission", mission, "--fly", "--camera", In("pictures"),
            "--truth", truth, "--headless", "--summary", summary, "--report", In("report.html")]);
        int exitCode = console.WaitForEnd(MissionTimeout);
        output.WriteLine(console.Output);
        vehicle.Interrupt();

        Assert.Equal(0, vehicle.WaitForEnd());
        Assert.Equal(0, exitCode);
        using JsonDocument document = JsonDocument.Parse(File.ReadAllText(truth));
        JsonElement flight = document.RootElement.GetProperty("flight");
        Assert.False(flight.GetProperty("isAirborne").GetBoolean());
        Assert.False(flight.GetProperty("hasCrashed").GetBoolean());
        Assert.True(File.Exists(summary));
        Assert.True(File.Exists(In("report.html")));
        Assert.Equal(isSigned, File.Exists(In("key.clock.0")));
    }

    // GroundCommandFlightTests flies the same story in virtual time.
    [Theory]
    [InlineData("ardupilot")]
    [InlineData("px4")]
    public void Story_OfAGroundStationOverUdp_IsAnsweredAndFlown(string autopilot)
    {
        string mission = Write("mission.json", SearchFlight.SmallMission);
        int port = FreePort.Udp();
        using var vehicle = new SampleProcess(
            "Rabit.Tool",
            ["simulate", "--autopilot", autopilot, "--link", $"udpout:127.0.0.1:{port}", "--mission", mission, "--targets", "2",
            "--seed", "5", "--camera-out", In("pictures")]);
        vehicle.WaitUntil(() => File.Exists(In("pictures/camera.json")));
        using var station = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        station.Bind(new IPEndPoint(IPAddress.Loopback, 0));
        int stationPort = ((IPEndPoint)station.LocalEndPoint!).Port;
        using var console = new SampleProcess(
            "UavConsole",
            ["--link", $"udpin:127.0.0.1:{port}", "--link", $"udpout:127.0.0.1:{stationPort}", "--mission", mission,
            "--fly", "--camera", In("pictures"), "--headless"]);

        var reader = new MavlinkFrameReader(MavlinkDialect.All);
        var buffer = new byte[64 * 1024];
        EndPoint from = new IPEndPoint(IPAddress.Loopback, 0);
        bool isKnown = false;
        var waiting = new List<MavlinkFrame>();
        Stopwatch clock = Stopwatch.StartNew();
        var story = new GroundStationStory(
            bytes =>
            {
                if (isKnown)
                    station.SendTo(bytes, from);
            },
            () =>
            {
                MavlinkFrame[] taken = [.. waiting];
                waiting.Clear();
                return taken;
            },
            () =>
            {
                TimeSpan until = clock.Elapsed + TimeSpan.FromSeconds(0.1);
                while (clock.Elapsed < until)
                {
                    if (!station.Poll(10_000, SelectMode.SelectRead))
                        continue;
                    var rest = new ReadOnlySpan<byte>(buffer, 0, station.ReceiveFrom(buffer, ref from));
                    isKnown = true;
                    while (reader.TryRead(ref rest, out MavlinkFrame frame, out _))
                        waiting.Add(frame);
                }

                return clock.Elapsed < MissionTimeout;
            },
            () => console.Output);
        try
        {
            story.Play();
        }
        finally
        {
            output.WriteLine(string.Join("\n", story.Answers));
            output.WriteLine(string.Join("\n", story.Texts));
            output.WriteLine(console.Output);
        }

        // The operator gave the mission up.
        Assert.Equal(1, console.WaitForEnd(MissionTimeout));
        Assert.DoesNotContain(story.Texts, t => t.Contains("stuck"));
        vehicle.Interrupt();
        Assert.Equal(0, vehicle.WaitForEnd());
    }

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    private string In(string name) => Path.Combine(_folder, name);

    private string Write(string name, string text)
    {
        File.WriteAllText(In(name), text);
        return In(name);
    }
}
