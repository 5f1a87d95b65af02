using System;
using System.IO;
using System.Text.Json;
using System.Threading;
using Rabit.Tests.Shared;
using Rabit.Uav.Tests;
using Rabit.Uav.Tests.Communications;
using Rabit.Uav.Tests.ImageProcessing.Pictures;
using Xunit;

namespace UavConsole.Tests;

/// <summary>--camera with a description whose source is a program; a shell stands in for that.</summary>
public sealed class CameraSourceTests : IDisposable
{
    private readonly TestLog _folder = new();

    public void Dispose() => _folder.Dispose();

    [ShellFact]
    public void Camera_Program_ItsPicturesAreTaken()
    {
        string picture = Path.Combine(Repository.Root, "tests", "data", "jpeg", "420.jpg");
        string description = Describe($$"""
            { "program": "sh", "format": "mjpeg",
              "arguments": ["-c", "echo '{width} by {height}' >&2; while :; do cat \"$1\"; sleep 0.1; done",
                "camera", "{{picture.Replace("\\", "\\\\")}}"] }
            """);

        ConsoleProcess console = Run(description, until: "sh: 61 by 43", out JsonElement camera);

        Assert.Equal("sh", camera.GetProperty("name").GetString());
        Assert.True(camera.GetProperty("taken").GetInt64() > 0, console.ToString());
        const string timeSource = "arrival less 50 ms, standard deviation 20 ms";
        Assert.Equal(timeSource, camera.GetProperty("timeSource").GetString());
        Assert.Contains("  time of a picture: " + timeSource, console.Output);
        Assert.Contains(console.Output, line => line.StartsWith("camera sh: ", StringComparison.Ordinal));
    }

    [ShellFact]
    public void Camera_ProgramIsMissing_IsSaidAndTheFlightGoesOn()
    {
        string description = Describe("""{ "program": "./no-such-camera" }""");
        string program = Path.Combine(_folder.Folder, "./no-such-camera");

        ConsoleProcess console = Run(
            description, until: $"{program}: there is no such program; it is tried again in 1 s",
            out JsonElement camera);

        Assert.True(camera.GetProperty("restarts").GetInt64() > 0, console.ToString());
        Assert.Equal($"{program}: there is no such program", camera.GetProperty("lastRefusal").GetString());
    }

    [Fact]
    public void Camera_SourceIsWrong_NamesOptionFileAndKey()
    {
        string description = Describe("""{ "program": "sh", "format": "h264" }""");

        Assert.Contains(
            $"--camera {description}: source.format is \"h264\"; it must be one of mjpeg, yuv420, yuv420FullRange",
            Assert.Single(
                CommandLineRun.Refuse("--link", $"udpin:127.0.0.1:{FreePort.Udp()}", "--camera", description)),
            StringComparison.Ordinal);
    }

    // It writes nothing, so that no broken pipe ends it; nor its child, which has the pipe too.
    [ShellFact]
    public void Kill_CameraProgramThatWritesNothing_EndsWithItsChildren()
    {
        if (!Directory.Exists("/proc/self"))
            return;   // the programs are looked up there, by the product too
        string description = Describe("""
            { "program": "sh", "stallTimeoutSeconds": 600,
              "arguments": ["-c", "sleep 600 & echo \"pids=$$,$!\" >&2; wait"] }
            """);
        using ConsoleProcess console = ConsoleProcess.Start(
            "--headless", "--link", $"udpin:127.0.0.1:{FreePort.Udp()}", "--camera", description);
        string[] programs = console.WaitFor("sh: pids=").Split('=')[1].Split(',');
        Assert.All(programs, pid => Assert.False(HasEnded(pid), pid));

        console.Signal(ConsoleProcess.KillNow);

        Assert.All(programs, pid => Assert.True(
            SpinWait.SpinUntil(() => HasEnded(pid), TimeSpan.FromSeconds(60)), $"process {pid} goes on"));
    }

    // Also true of one that has ended but was not yet waited for.
    private static bool HasEnded(string pid)
    {
        try
        {
            string stat = File.ReadAllText($"/proc/{pid}/stat");
            return stat[stat.LastIndexOf(')') + 2] is 'Z' or 'X';
        }
        catch (IOException)
        {
            return true;
        }
    }

    // Until the log has a text.
    private ConsoleProcess Run(string description, string until, out JsonElement camera)
    {
        string summary = Path.Combine(_folder.Folder, "summary.json");
        using ConsoleProcess console = ConsoleProcess.Start(
            "--headless", "--summary", summary, "--link", $"udpin:127.0.0.1:{FreePort.Udp()}", "--camera", description);
        console.WaitFor(until);
        console.Signal(ConsoleProcess.Interrupt);
        Assert.True(console.WaitForEnd() == 0, console.ToString());
        using JsonDocument document = JsonDocument.Parse(File.ReadAllText(summary));
        camera = document.RootElement.GetProperty("camera").Clone();
        return console;
    }

    private string Describe(string source)
    {
        string file = Path.Combine(_folder.Folder, "nadir.json");
        File.WriteAllText(file, $$"""
            { "source": {{source}},
              "camera": { "width": 61, "height": 43, "horizontalFieldOfViewDegrees": 62,
                "mount": { "bodyFromCamera": [[0, -1, 0], [1, 0, 0], [0, 0, 1]], "leverArmBodyMetres": [0, 0, 0] } } }
            """);
        return file;
    }
}
