using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using Rabit.Core;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Tests.ImageProcessing.VideoDevices;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing.Pictures;

// Programs that end, stall, or give no picture.
public sealed partial class ProcessCameraTests
{
    [ShellFact]
    public void Read_ProgramThatEnds_IsStartedAgainAndItsErrorsAreLogged()
    {
        ProcessCameraOptions options = Options(
            "cat \"$1\"; echo no more film >&2; exit 3", Path.Combine(Jpegs, "420.jpg"));

        Run(options, 3, out ProcessCamera camera);

        Assert.True(camera.Restarts >= 2, $"{camera.Restarts} restarts");
        Assert.Contains("sh: no more film", _log);
        Assert.Contains("sh: it ended with exit code 3; it is started again in 0.05 s", _log);
        Assert.Contains("exit code 3", camera.LastFault, StringComparison.Ordinal);
    }

    [ShellFact]
    public void Read_ProgramThatStalls_IsStartedAgain()
    {
        ProcessCameraOptions options = Options("cat \"$1\"; exec sleep 60", Path.Combine(Jpegs, "420.jpg"));
        options.StallTimeout = TimeSpan.FromSeconds(0.4);

        Run(options, 2, out ProcessCamera camera);

        Assert.Contains(_log, line => line.Contains("it wrote nothing for 0.4 s"));
        Assert.True(camera.Restarts >= 1);
    }

    // $1 is half a picture. Each byte is something, but no picture comes.
    [LinuxTheory]
    [InlineData(ProcessCameraFormat.Mjpeg)]
    [InlineData(ProcessCameraFormat.Yuv420)]
    public void Read_ProgramThatNeverEndsAPicture_IsAFaultAndIsStartedAgain(ProcessCameraFormat format)
    {
        byte[] half = [.. File.ReadAllBytes(Path.Combine(Jpegs, "420.jpg")).Take(500)];
        File.WriteAllBytes(_folder.File("half"), half);
        ProcessCameraOptions options = Options(
            "cat \"$1\"; while :; do printf x; sleep 0.1; done", _folder.File("half"));
        options.Format = format;
        options.StallTimeout = TimeSpan.FromSeconds(0.4);

        Run(options, 0, out ProcessCamera camera, () => _log.Count(line => line.Contains("no whole picture")) >= 2);

        Assert.Equal("sh: it wrote no whole picture for 0.4 s, only bytes that are none", camera.LastFault);
        Assert.True(camera.Restarts >= 1, $"{camera.Restarts} restarts");
        Assert.Contains(_log, line => line.EndsWith("it is started again in 0.1 s", StringComparison.Ordinal));
    }

    // A picture that takes longer than the timeout altogether, but comes in it after the one before, is none.
    [ShellFact]
    public void Read_ProgramWhosePicturesComeInTime_IsLeftAlone()
    {
        ProcessCameraOptions options = Options(
            "for i in 1 2 3 4 5; do cat \"$1\"; sleep 0.4; done; sleep 60", Path.Combine(Jpegs, "420.jpg"));
        options.StallTimeout = TimeSpan.FromSeconds(1.5);

        Run(options, 5, out ProcessCamera camera);

        Assert.Equal((5, 0), (camera.PicturesDelivered, camera.Restarts));
    }

    // A line of 20 MB to the errors, then one that is as others.
    [ShellFact]
    public void Read_LineOfErrorsThatDoesNotEnd_IsCutShort()
    {
        ProcessCameraOptions options = Options(
            "cat \"$1\"; head -c 20000000 /dev/zero | tr '\\0' . >&2; echo >&2; echo behind it >&2; sleep 60",
            Path.Combine(Jpegs, "420.jpg"));
        options.StallTimeout = MaxWait;

        Run(options, 1, out _, until: () => _log.Contains("sh: behind it"));

        string dots = Assert.Single(_log, line => line.StartsWith("sh: ....", StringComparison.Ordinal));
        Assert.Equal("sh: " + new string('.', 500) + " ...", dots.Length > 1000 ? $"{dots.Length} characters" : dots);
    }

    // As a terminal does at Ctrl-C: its signal ends the program, and asks us to stop a little later.
    [ShellFact]
    public void Stop_ProgramThatHasJustEnded_IsNoFault()
    {
        string ended = _folder.File("ended");
        ProcessCameraOptions options = Options(
            $"cat \"$1\"; {UntilRead(1)} touch \"$2\"; exit 130", Path.Combine(Jpegs, "420.jpg"), ended);
        options.EndGrace = TimeSpan.FromSeconds(20);

        Run(options, 1, out ProcessCamera camera, until: () => File.Exists(ended) && Waited(0.3));

        Assert.Null(camera.LastFault);
        Assert.Equal(0, camera.Restarts);
        Assert.DoesNotContain(_log, line => line.Contains("it ended"));
    }

    // What ends the program if this process is killed. That it does is shown by CameraSourceTests of UavConsole.
    [LinuxFact]
    public void Run_Program_IsWatchedWhileItRunsAndNoLonger()
    {
        bool HasWatch(string pid) => Directory.GetDirectories("/proc").Any(p => IsWatch(p, pid));
        ProcessCameraOptions options = Options(
            "echo pid=$$ >&2; cat \"$1\"; sleep 600", Path.Combine(Jpegs, "420.jpg"));

        Run(options, 1, out _, until: () => _log.Any(l => l.Contains("pid=")) && HasWatch(PidOf(_log)));

        Assert.True(SpinWait.SpinUntil(() => !HasWatch(PidOf(_log)), MaxWait));
    }

    // The same while the stop waits for the vehicle to hold.
    [ShellFact]
    public void Stop_ProgramThatEndsWhileTheStopIsDelayed_IsNoFault()
    {
        string end = _folder.File("end");
        ProcessCameraOptions options = Options(
            "cat \"$1\"; until [ -e \"$2\" ]; do sleep 0.02; done; exit 130", Path.Combine(Jpegs, "420.jpg"), end);
        options.EndGrace = TimeSpan.FromSeconds(0.1);
        var camera = new ProcessCamera(options);
        var taker = new FrameTaker(camera, (_, _, _) => { }) { HoldsUpTheStop = true };
        using var reactor = new RabitReactor(
            new ReactorOptions { StopsOnSignals = false, MaxStopDelay = MaxWait }) { taker };
        reactor.Start();
        Assert.True(SpinWait.SpinUntil(() => camera.PicturesDelivered == 1, MaxWait), camera.LastFault);

        reactor.Stop();
        File.Create(end).Dispose();
        Assert.True(Waited(0.8));
        reactor.Stop();
        reactor.Finish();

        Assert.Null(camera.LastFault);
        Assert.Equal(0, camera.Restarts);
    }

    private static string PidOf(IEnumerable<string> log) => log.First(l => l.Contains("pid=")).Split('=')[1];

    private static bool IsWatch(string process, string ofProgram)
    {
        try
        {
            return File.ReadAllText(Path.Combine(process, "cmdline"))
                .EndsWith($"\0rabit-watch\0{ofProgram}\0", StringComparison.Ordinal);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return false;
        }
    }

    private static bool Waited(double seconds)
    {
        Thread.Sleep(TimeSpan.FromSeconds(seconds));
        return true;
    }
}
