using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Threading;
using Rabit.Core;
using Rabit.Tests.Shared;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Uav.Tests.ImageProcessing.VideoDevices;
using Rabit.Vision;
using Rabit.Vision.Tests.Pictures;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing.Pictures;

/// <summary>A shell stands in for the program of a camera, so on systems that have one.</summary>
public sealed partial class ProcessCameraTests : IDisposable
{
    private static readonly string Jpegs = Path.Combine(Repository.Root, "tests", "data", "jpeg");
    private static readonly TimeSpan MaxWait = TimeSpan.FromSeconds(30);

    private readonly SamplePictures.TemporaryFolder _folder = new();
    private readonly ConcurrentQueue<string> _log = new();

    public void Dispose() => _folder.Dispose();

    [ShellFact]
    public void Read_Mjpeg_GivesThePictures()
    {
        List<byte[]> pictures = Run(
            Options(
                $"cat \"$1\"; {UntilRead(1)} cat \"$1\"; {UntilRead(2)} cat \"$1\"; sleep 60",
                Path.Combine(Jpegs, "420.jpg")),
            3, out ProcessCamera camera);

        Assert.Equal((3, 0, 0), (camera.PicturesDelivered, camera.PicturesRefused, camera.Restarts));
        Assert.All(pictures, p => Assert.Equal(PictureFile.Load(Path.Combine(Jpegs, "420.jpg")).Pixels, p));
    }

    // $1 is the picture, $2 the pipe: a shell with the two of rpicam-vid's metadata that count, and one that does not.
    [LinuxFact]
    public void Read_ProgramThatReportsTimes_GivesThoseOfTheSensor()
    {
        ProcessCameraOptions options = Options(
            "exec 3>\"$2\"; echo \"pipe=$2\" >&2; read up rest < /proc/uptime; "
                + "ms=$(expr ${up%.*} \\* 1000 + ${up#*.} \\* 10 - 300); "
                + $"cat \"$1\"; printf 'ExposureTime=4000\\nSensorTimestamp=%s000000\\n\\n' $ms >&3; {UntilRead(1)} "
                + "sleep 0.3; cat \"$1\"; printf 'SensorTimestamp=%s000000\\nGain=1\\nExposureTime=2000\\n\\n' "
                + "$(expr $ms + 100) >&3; sleep 60",
            Path.Combine(Jpegs, "420.jpg"), "{metadata}");
        var frames = new List<CameraFrame>();

        Run(options, 2, out ProcessCamera camera, () => _log.Any(line => line.Contains("pipe=")), frames: frames);

        Assert.Equal([4.0, 2.0], frames.Select(f => f.Exposure.TotalMilliseconds));
        Assert.All(frames, f => Assert.Equal(options.MetadataTimeNoise, f.TimeNoise));
        TimeSpan between = frames[1].FrameStart - frames[0].FrameStart;   // 102 ms in the metadata, 300 in the pipe
        Assert.InRange(between.TotalMilliseconds, 52, 152);
        Assert.Equal((2, 0), (camera.PicturesDelivered, camera.Statistics.WithoutTime));
        Assert.Equal("the program's metadata, standard deviation 1 ms", camera.Statistics.TimeSource);
        string pipe = _log.First(line => line.Contains("pipe=")).Split('=')[1];
        Assert.StartsWith(Path.Combine(Path.GetTempPath(), "rabit-metadata-"), pipe, StringComparison.Ordinal);
        Assert.False(File.Exists(pipe), pipe);
    }

    [Fact]
    public void Constructor_TimeByArrivalThatIsTooGood_IsRefused()
    {
        ProcessCameraOptions options = Options("sleep 60");
        options.TimeNoise = TimeSpan.FromMilliseconds(19);

        Assert.Contains(
            "TimeNoise is 19 ms; a time by arrival is not known better than to 20 ms",
            Assert.Throws<ArgumentException>(() => new ProcessCamera(options)).Message, StringComparison.Ordinal);
    }

    [LinuxTheory]
    [InlineData(":")]                                                                        // never opens the pipe
    [InlineData("printf 'SensorTimestamp=%s\\n\\n' 900000000000000000 > \"$2\"")]            // from the future
    [InlineData("printf 'SensorTimestamp=1\\n\\n' > \"$2\"")]                                // of another clock
    [InlineData("printf 'Gain=1\\n\\n' > \"$2\"")]                                           // without the time
    [InlineData("read up rest < /proc/uptime; printf 'ExposureTime=5000001\\nSensorTimestamp=%s000000\\n\\n' "
        + "$(expr ${up%.*} \\* 1000 + ${up#*.} \\* 10 - 2000) > \"$2\"")]                     // for 5 s
    [InlineData("read up rest < /proc/uptime; printf 'ExposureTime=999999999999999999\\nSensorTimestamp=%s000000\\n\\n' "
        + "$(expr ${up%.*} \\* 1000 + ${up#*.} \\* 10 - 2000) > \"$2\"")]                     // for 31 000 years
    public void Read_ProgramThatReportsNoTime_GivesThatOfTheArrival(string report)
    {
        ProcessCameraOptions options = Options(
            $"cat \"$1\"; {report}; sleep 60", Path.Combine(Jpegs, "420.jpg"), "{metadata}");
        var frames = new List<CameraFrame>();

        Run(options, 1, out ProcessCamera camera, frames: frames);

        Assert.Equal((options.TimeNoise, options.Exposure), (frames[0].TimeNoise, frames[0].Exposure));
        Assert.Equal((1, 1), (camera.PicturesDelivered, camera.Statistics.WithoutTime));
        Assert.Equal("arrival less 50 ms, standard deviation 20 ms", camera.Statistics.TimeSource);
        Assert.Contains("sh: no time of a picture in its metadata; that of the arrival is taken", _log);
    }

    [LinuxFact]
    public void Read_OneTimeThatCannotBe_DoesNotSpoilTheNext()
    {
        ProcessCameraOptions options = Options(
            $"exec 3>\"$2\"; cat \"$1\"; printf 'SensorTimestamp=900000000000000000\\n\\n' >&3; {UntilRead(1)} "
                + "read up rest < /proc/uptime; cat \"$1\"; "
                + "printf 'SensorTimestamp=%s000000\\n\\n' $(expr ${up%.*} \\* 1000 + ${up#*.} \\* 10 - 50) >&3; "
                + "sleep 60",
            Path.Combine(Jpegs, "420.jpg"), "{metadata}");
        var frames = new List<CameraFrame>();

        Run(options, 2, out ProcessCamera camera, frames: frames);

        Assert.Equal([options.TimeNoise, options.MetadataTimeNoise], frames.Select(f => f.TimeNoise));
        Assert.Equal(1, camera.Statistics.WithoutTime);
    }

    [LinuxTheory]
    [InlineData("[\\n{\\n", "its metadata are JSON; it needs --metadata-format txt")]
    [InlineData("Gain=1\\n", "it wrote no metadata for 0.4 s")]
    public void Read_MetadataThatNeverEnd_AreAFaultThatIsNamed(string metadata, string fault)
    {
        ProcessCameraOptions options = Options(
            $"exec 3>\"$2\"; cat \"$1\"; printf '{metadata}' >&3; sleep 60", Path.Combine(Jpegs, "420.jpg"),
            "{metadata}");
        options.StallTimeout = TimeSpan.FromSeconds(0.4);

        Run(options, 0, out ProcessCamera camera, () => _log.Count(line => line.Contains(fault)) >= 2);

        Assert.Equal($"sh: {fault}", camera.LastFault);
        Assert.True(camera.Restarts >= 1, $"{camera.Restarts} restarts");
    }

    [LinuxFact]
    public void Read_PicturesThatAreNotWanted_TheirMetadataAreReadToo()
    {
        // More than a pipe holds, for pictures of which one in many is wanted.
        ProcessCameraOptions options = Options(
            "exec 3>\"$2\"; line=$(printf '%04000d' 0); i=0; while [ $i -lt 100 ]; do cat \"$1\"; "
                + "printf 'X=%s\\n\\n' $line >&3; i=$((i+1)); done; echo done >&2; sleep 60",
            Path.Combine(Jpegs, "420.jpg"), "{metadata}");
        options.MaxFramesPerSecond = 0.1;

        Run(options, 1, out ProcessCamera camera, () => _log.Contains("sh: done"));

        Assert.Equal(0, camera.Restarts);
    }

    [ShellFact]
    public void Read_PicturesThatCannotBeUsed_AreCountedAndTheRestGoesOn()
    {
        ProcessCameraOptions options = Options(
            $"cat \"$1\"; {UntilRead(1)} cat \"$2\"; {UntilRead(2)} cat \"$3\"; sleep 60",
            Path.Combine(Jpegs, "arithmetic.jpg"), Path.Combine(Jpegs, "420-best.jpg"),
            Path.Combine(Jpegs, "420.jpg"));

        Run(options, 1, out ProcessCamera camera);

        Assert.Equal((1, 2), (camera.PicturesDelivered, camera.PicturesRefused));
        Assert.Contains("a picture is 96 x 64; 61 x 43 are wanted", camera.LastFault, StringComparison.Ordinal);
    }

    // The first start writes such pictures without end, the second one that can be used.
    [ShellFact]
    public void Read_OnlyPicturesThatCannotBeUsed_IsStartedAgain()
    {
        ProcessCameraOptions options = Options(
            "if [ -e \"$3\" ]; then cat \"$2\"; sleep 60; fi; touch \"$3\"; while :; do cat \"$1\"; sleep 0.05; done",
            Path.Combine(Jpegs, "arithmetic.jpg"), Path.Combine(Jpegs, "420.jpg"), _folder.File("started"));
        options.StallTimeout = TimeSpan.FromSeconds(0.4);

        Run(options, 1, out ProcessCamera camera);

        Assert.Contains(
            _log,
            line => line.StartsWith(
                "sh: it gave only pictures that cannot be used for 0.4 s (", StringComparison.Ordinal));
        Assert.True(camera.Restarts >= 1, $"{camera.Restarts} restarts");
    }

    [ShellFact]
    public void Read_ProgramThatIsMissing_IsAFaultThatIsTriedAgain()
    {
        string program = _folder.File("camera program");
        ProcessCameraOptions options = Options(string.Empty);
        (options.Program, options.Arguments) = (program, []);
        options.FirstRestartDelay = options.MaxRestartDelay = TimeSpan.FromSeconds(0.3);
        string? fault = null;

        Run(options, 1, out ProcessCamera camera, before: c =>
        {
            Assert.True(SpinWait.SpinUntil(() => c.Statistics.Fault is not null, MaxWait));
            fault = c.Statistics.Fault;
            File.WriteAllText(program, $"#!/bin/sh\ncat '{Path.Combine(Jpegs, "420.jpg")}'\nsleep 60\n");
            Process.Start("chmod", $"+x \"{program}\"")!.WaitForExit();
        });

        Assert.Equal($"{program}: there is no such program", fault);
        Assert.Contains($"{fault}; it is tried again in 0.3 s", _log);
        Assert.True(camera.Restarts >= 1, $"{camera.Restarts} restarts");
        Assert.Null(camera.Statistics.Fault);
    }

    [ShellFact]
    public void Read_FileThatIsNoProgram_IsAFault()
    {
        string program = _folder.File("photo");
        File.WriteAllText(program, "no program");
        ProcessCameraOptions options = Options(string.Empty);
        (options.Program, options.Arguments) = (program, []);

        Run(options, 0, out ProcessCamera camera, until: () => _log.Count > 2);

        Assert.StartsWith($"{program}: it cannot be started: ", camera.Statistics.Fault, StringComparison.Ordinal);
    }

    [ShellFact]
    public void Read_MorePicturesThanWanted_PassesOverTheRest()
    {
        ProcessCameraOptions options = Options(
            "while :; do cat \"$1\" \"$1\" \"$1\" \"$1\"; sleep 0.02; done", Path.Combine(Jpegs, "420.jpg"));
        options.MaxFramesPerSecond = 5;
        var frames = new List<CameraFrame>();

        Run(options, 4, out ProcessCamera camera, frames: frames);

        TimeSpan took = frames[3].FrameStart - frames[0].FrameStart;
        Assert.True(took > TimeSpan.FromSeconds(0.45), $"{took} for four pictures");
        Assert.True(camera.PicturesSkipped > 3, $"{camera.PicturesSkipped} passed over");
        Assert.Equal([0, 1, 2, 3], frames.Take(4).Select(f => f.Number));
        Assert.All(frames, f => Assert.Equal(options.TimeNoise, f.TimeNoise));
    }

    [ShellFact]
    public void Read_ProgramThatTalks_IsCutShortInTheLog()
    {
        ProcessCameraOptions options = Options(
            "i=0; while [ $i -lt 500 ]; do echo line >&2; i=$((i+1)); done; cat \"$1\"; sleep 60",
            Path.Combine(Jpegs, "420.jpg"));

        Run(options, 1, out _, until: () => _log.Count >= 20);

        Assert.InRange(_log.Count, 20, 60);
    }

    [ShellFact]
    public void Stop_ProgramThatWouldGoOn_EndsIt()
    {
        string alive = _folder.File("alive");
        ProcessCameraOptions options = Options(
            "cat \"$1\"; while :; do echo x >> \"$2\"; sleep 0.05; done", Path.Combine(Jpegs, "420.jpg"), alive);

        Run(options, 1, out _);

        Thread.Sleep(300);
        long bytes = File.Exists(alive) ? new FileInfo(alive).Length : 0;
        Thread.Sleep(500);
        Assert.Equal(bytes, File.Exists(alive) ? new FileInfo(alive).Length : 0);
    }

    [ShellFact]
    public void Arguments_WithBlanksAndQuotes_ArriveAsTheyAre()
    {
        string[] arguments = ["a b", "\"c\"", "d\\", "e\\\"f", "", "$HOME *"];
        string[] all = ["-c", "cat \"$0\"; shift 0; printf '<%s>' \"$@\" >&2; echo >&2; sleep 60",
            Path.Combine(Jpegs, "420.jpg"), .. arguments];
        ProcessCameraOptions options = Options(string.Empty);
        options.Arguments = all;

        // The log has other lines too, of what decodes the pictures.
        Run(options, 1, out _, until: () => _log.Any(line => line.Contains('<')));

        Assert.Contains("sh: " + string.Concat(arguments.Select(a => $"<{a}>")), _log);
    }

    [ShellFact]
    public void Stop_ProgramThatHasStartedOthers_EndsThemToo()
    {
        if (!Directory.Exists("/proc/self"))
            return;   // the programs are looked up there
        ProcessCameraOptions options = Options(
            "cat \"$1\"; (sleep 600 & echo pid=$! >&2; wait); wait", Path.Combine(Jpegs, "420.jpg"));

        Run(options, 1, out _, until: () => _log.Any(line => line.Contains("pid=")));

        string pid = _log.First(line => line.Contains("pid=")).Split('=')[1];
        Assert.True(SpinWait.SpinUntil(() => HasEnded(pid), MaxWait), $"process {pid} goes on");
    }

    [Theory]
    [InlineData("Exposure")]
    [InlineData("Latency")]
    [InlineData("TimeNoise")]
    [InlineData("MetadataTimeNoise")]
    [InlineData("StallTimeout")]
    [InlineData("MaxRestartDelay")]
    public void New_TimeWithoutEnd_IsRefusedByName(string name)
    {
        var options = new ProcessCameraOptions { Program = "sh", Width = 4, Height = 4 };
        typeof(ProcessCameraOptions).GetProperty(name)!.SetValue(options, TimeSpan.MaxValue);

        Assert.Contains(
            $"The camera of sh: {name} is ",
            Assert.Throws<ArgumentException>(() => new ProcessCamera(options)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void New_OptionsThatAreNone_AreRefused()
    {
        Assert.Throws<ArgumentException>(() => new ProcessCamera(new ProcessCameraOptions { Width = 4, Height = 4 }));
        Assert.Throws<ArgumentException>(() => new ProcessCamera(new ProcessCameraOptions { Program = "sh" }));
        Assert.Throws<ArgumentException>(() => new ProcessCamera(
            new ProcessCameraOptions { Program = "sh", Width = 4, Height = 4, StallTimeout = TimeSpan.Zero }));
        Assert.Throws<ArgumentException>(() => new ProcessCamera(
            new ProcessCameraOptions { Program = "sh", Width = 4, Height = 4, MaxFramesPerSecond = 0 }));
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

    private ProcessCameraOptions Options(string script, params string[] arguments) => new()
    {
        Program = "sh",
        Arguments = ["-c", script, "camera", .. arguments],
        Width = 61,
        Height = 43,
        FirstRestartDelay = TimeSpan.FromSeconds(0.05),
        Log = _log.Enqueue,
    };

    // For a shell: waits until the camera has read so many pictures. Of several that wait it takes the newest alone.
    private string UntilRead(int pictures) => $"until [ -e '{ReadMark(pictures)}' ]; do sleep 0.02; done;";

    private string ReadMark(int pictures) => _folder.File($"read {pictures}");

    // Until so many pictures have come.
    private List<byte[]> Run(
        ProcessCameraOptions options, int count, out ProcessCamera camera, Func<bool>? until = null,
        Action<ProcessCamera>? before = null, List<CameraFrame>? frames = null)
    {
        var pictures = new List<byte[]>();
        using var enough = new ManualResetEventSlim(count == 0);
        camera = new ProcessCamera(options);
        using var reactor = new RabitReactor(new ReactorOptions { StopsOnSignals = false })
        {
            new FrameTaker(camera, (frame, pixels, _) =>
            {
                pictures.Add(pixels);
                frames?.Add(frame);
                if (pictures.Count == count)
                    enough.Set();
            }),
        };
        reactor.Start();
        before?.Invoke(camera);
        ProcessCamera read = camera;
        int marked = 0;
        Assert.True(
            SpinWait.SpinUntil(
                () =>
                {
                    while (marked < read.PicturesDelivered + read.PicturesRefused)
                        File.Create(ReadMark(++marked)).Dispose();
                    return enough.IsSet;
                },
                MaxWait),
            $"{pictures.Count} pictures; {camera.LastFault}");
        Assert.True(SpinWait.SpinUntil(() => until?.Invoke() ?? true, MaxWait));
        reactor.Stop();
        reactor.Finish();
        return pictures;
    }
}
