using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Tests.Shared;
using Rabit.Uav.Simulation.Tests.Missions;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Sample;

/// <summary>
/// Three UavConsole fly three "rabit simulate" of one world, six processes in real time, with UDP between all of them:
/// the recipe of docs/how-to.md.
/// </summary>
[Trait("Category", "Long")]
public sealed class GroupOverUdpTests(ITestOutputHelper output) : IDisposable
{
    private const int Vehicles = 3;

    // The flight takes some three minutes; what is longer hangs.
    private static readonly TimeSpan MaxFlight = TimeSpan.FromMinutes(9);

    private readonly string _folder =
        Directory.CreateDirectory(Path.Combine(Path.GetTempPath(), $"rabit-group-{Guid.NewGuid():N}")).FullName;

    private readonly List<SampleProcess> _processes = [];

    [Fact]
    public void Search_ThreePairsOfProcesses_FindEachOtherDivideTheAreaAndValidate()
    {
        File.WriteAllText(
            In("field.json"),
            SearchFlight.SmallMission.Replace("\"heightMetres\": 30", "\"heightMetres\": 20")
                .Replace("\"laneSpacingMetres\": 22", "\"laneSpacingMetres\": 14"));
        int[] telemetry = FreePorts();
        int[] radio = FreePorts();
        SampleProcess[] vehicles = [.. Enumerable.Range(0, Vehicles).Select(i => StartVehicle(i, telemetry[i]))];
        for (int i = 0; i < Vehicles; i++)
        {
            string camera = In($"pictures-{i + 1}/camera.json");
            vehicles[i].WaitUntil(() => File.Exists(camera));
        }

        SampleProcess[] consoles = [.. Enumerable.Range(0, Vehicles).Select(i => StartConsole(i, telemetry[i], radio))];
        int[] exitCodes = [.. consoles.Select(c => c.WaitForEnd(MaxFlight))];
        foreach (SampleProcess console in consoles)
            output.WriteLine(console.Output + "\n\n");
        foreach (SampleProcess vehicle in vehicles)
            vehicle.Interrupt();

        Assert.Equal([0, 0, 0], exitCodes);
        Assert.Equal([0, 0, 0], vehicles.Select(v => v.WaitForEnd()));
        for (int i = 0; i < Vehicles; i++)
        {
            for (int other = 1; other <= Vehicles; other++)
                Assert.Equal(other != i + 1, consoles[i].Output.Contains($": vehicle {other} is in the group"));
            Assert.Contains("divided them among 3", consoles[i].Output);
            Assert.True(File.Exists(In($"report-{i + 1}.html")));
        }

        Assert.Contains(consoles, c => c.Output.Contains(": confirmed") && c.Output.Contains("has validated track"));
    }

    public void Dispose()
    {
        foreach (SampleProcess process in _processes)
            process.Dispose();
        Directory.Delete(_folder, recursive: true);
    }

    private SampleProcess StartVehicle(int number, int telemetry) => Start(
        "Rabit.Tool",
        "simulate", "--group", "3", "--system-id", $"{number + 1}", "--seed", "5", "--targets", "2",
        "--mission", In("field.json"), "--link", $"udpout:127.0.0.1:{telemetry}",
        "--camera-out", In($"pictures-{number + 1}"));

    private SampleProcess StartConsole(int number, int telemetry, int[] radio)
    {
        string settings = $",rate=3600,optional,allow-out=0+33+77+253+385+@{number + 1}/191";
        return Start(
            "UavConsole",
            [
                "--headless", "--no-tlog", "--fly", "--mission", In("field.json"), "--system-id", $"{number + 1}",
                "--group-layer", $"{number}", "--camera", In($"pictures-{number + 1}"),
                "--progress", In($"progress-{number + 1}.json"), "--report", In($"report-{number + 1}.html"),
                "--link", $"udpin:127.0.0.1:{telemetry}", "--link", $"udpin:127.0.0.1:{radio[number]}{settings}",
                .. Enumerable.Range(0, number).SelectMany(
                    other => new[] { "--link", $"udpout:127.0.0.1:{radio[other]}{settings}" }),
            ]);
    }

    private SampleProcess Start(string program, params string[] arguments)
    {
        var process = new SampleProcess(program, arguments);
        _processes.Add(process);
        return process;
    }

    private string In(string name) => Path.Combine(_folder, name);

    private static int[] FreePorts() => [.. Enumerable.Range(0, Vehicles).Select(_ => FreePort.Udp())];
}
