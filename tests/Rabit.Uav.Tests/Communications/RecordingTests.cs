using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>
/// The recording of the links: each frame once, whole records whatever the disk does, and all counted.
/// </summary>
public sealed class RecordingTests : IDisposable
{
    private readonly string _folder = Path.Combine(Path.GetTempPath(), "recording-" + Guid.NewGuid().ToString("N"));

    public void Dispose()
    {
        if (Directory.Exists(_folder))
            Directory.Delete(_folder, recursive: true);
    }

    [Fact]
    public void Frames_OfTwoLinks_AreRecordedOnceEachWithOursAmongThem()
    {
        using (CommunicationsRig rig = Rig(2).As(1))
        {
            rig.Send(0, Frames.Heartbeat());
            rig.Send(1, Frames.Of(new Heartbeat { Type = MavType.Gcs, MavlinkVersion = 3 }, 255, 190));
            rig.Run(TimeSpan.FromSeconds(1));
            rig.SendOwn(new Heartbeat { Type = MavType.OnboardController, MavlinkVersion = 3 });
            rig.Send(1, Frames.Of(Frames.Command(1, 1), 255, 190, sequence: 1));
            rig.Send(0, Frames.Raw(Frames.UnknownId, [1, 2]));
        }

        Assert.Equal(
            ["1/1 0 #0", "255/190 0 #0", "1/191 0 #0", "255/190 76 #1", $"1/1 {Frames.UnknownId} #7"],
            Read(Files().Single()).Select(Describe));
    }

    [Fact]
    public void Frames_ThatAreCopiesOrFilteredOrRejected_AreNotRecorded()
    {
        var settings = new Dictionary<int, Rabit.Links.LinkSettings>
        {
            [1] = Rabit.Links.LinkUrl.Parse("udpin:127.0.0.1:1,deny-in=30").Settings,
        };
        using (CommunicationsRig rig = Rig(2, o => o.LinkSettings = settings).As(1))
        {
            byte[] heartbeat = Frames.Heartbeat();
            rig.Send(0, heartbeat);
            rig.Send(1, heartbeat);
            rig.Send(1, Frames.Of(new Attitude(), system: 9));
        }

        Assert.Equal(["1/1 0 #0"], Read(Files().Single()).Select(Describe));
    }

    [Fact]
    public void Records_HaveTheTimesOfTheFrames_AndTheFileTheDateOfTheFirst()
    {
        DateTimeOffset start = new(2026, 5, 4, 3, 2, 1, TimeSpan.Zero);
        using (CommunicationsRig rig = Rig(1, start: start))
        {
            rig.Run(TimeSpan.FromSeconds(5));
            rig.Send(0, Frames.Heartbeat());
            rig.Run(TimeSpan.FromSeconds(2));
            rig.Send(0, Frames.Heartbeat(sequence: 1));
        }

        string file = Files().Single();
        Assert.Equal("test-20260504-030206.tlog", Path.GetFileName(file));
        using FileStream stream = File.OpenRead(file);
        var log = new TlogReader(stream, MavlinkDialect.All);
        Assert.True(log.TryRead(out _, out TlogRecord first));
        Assert.True(log.TryRead(out _, out TlogRecord second));
        Assert.Equal(start.UtcDateTime.AddSeconds(5), first.TimeUtc);
        Assert.Equal(2_000_000, second.TimeMicroseconds - first.TimeMicroseconds);
    }

    [Fact]
    public void Files_AtTheirLimit_RotateAndTheOldestGo()
    {
        const int count = 11_000;
        RecordingStatus status;
        using (CommunicationsRig rig = Rig(
            1, o => (o.Recording!.MaxFileBytes, o.Recording.MaxFiles) = (RecordingOptions.MinFileBytes, 3)))
        {
            for (int n = 0; n < count; n++)
            {
                rig.Put(0, Frames.Of(new Heartbeat { CustomMode = (uint)n, MavlinkVersion = 3 }, sequence: (byte)n));
                rig.Run(TimeSpan.FromMilliseconds(1));
            }

            rig.Finish();
            status = rig.Manager.SummariseRecording()!.Value;
        }

        string[] files = Files().OrderBy(File.GetLastWriteTimeUtc).ThenBy(f => f, StringComparer.Ordinal).ToArray();
        Assert.Equal((3, 1, (long)count, 0L, 0L), (
            status.Files, status.FilesDeleted, status.Frames, status.FramesDropped, status.FramesLost));
        Assert.Equal(3, files.Length);
        Assert.All(files, f => Assert.InRange(new FileInfo(f).Length, 1, RecordingOptions.MinFileBytes));
        Assert.All(files, f => Assert.True(Read(f).Count > 0));
        Assert.EndsWith("-4.tlog", status.File, StringComparison.Ordinal);
    }

    [Fact]
    public void Disk_FullInMidRecord_CutsTheRecordOffAndGoesOnOnceThereIsRoom()
    {
        long room = 1000;
        RecordingStatus full = default;
        RecordingStatus end;
        var log = new List<string>();
        using (CommunicationsRig rig = Rig(
            1, o => o.Recording!.CreatesFile = path => new FailingStream(File.Create(path), () => room)))
        {
            for (int n = 0; n < 100; n++)
                rig.Send(0, Frames.Heartbeat(sequence: (byte)n));
            rig.Run(TimeSpan.FromSeconds(2));
            full = rig.Manager.SummariseRecording()!.Value;
            room = long.MaxValue;
            for (int n = 100; n < 200; n++)
                rig.Send(0, Frames.Heartbeat(sequence: (byte)n));
            rig.Finish();
            end = rig.Manager.SummariseRecording()!.Value;
            log.AddRange(rig.Log.Select(l => l.ToString()));
        }

        Assert.Equal("No space left on device", full.Fault);
        Assert.Equal(100, full.Frames + full.FramesLost);
        Assert.Null(end.Fault);
        Assert.Equal(200, end.Frames + end.FramesLost);
        Assert.InRange(end.Frames, 100, 199);
        List<MavlinkFrame> frames = Read(Files().Single(), out long lostBytes);
        Assert.Equal((end.Frames, 0L), (frames.Count, lostBytes));
        Assert.Contains(log, l => l.Contains("frames so far could not be written (No space left on device)"));
    }

    [Fact]
    public void Disk_ThatFailsForGood_NeverEndsTheRun()
    {
        using CommunicationsRig rig = Rig(
            1, o => o.Recording!.CreatesFile = _ => throw new UnauthorizedAccessException("read-only"));
        for (int n = 0; n < 50; n++)
            rig.Send(0, Frames.Heartbeat(sequence: (byte)n));
        rig.Run(TimeSpan.FromSeconds(3));
        RecordingStatus status = rig.Manager.SummariseRecording()!.Value;
        Assert.Equal((0L, 50L, "read-only"), (status.Frames, status.FramesLost, status.Fault));
        Assert.Equal(50, rig.Autopilot.Taken.Count);
        Assert.Null(rig.Finish().Failure);
    }

    [Fact]
    public async System.Threading.Tasks.Task Disk_ThatIsSlow_NeverDelaysTheManagerAndWhatHasNoRoomIsCounted()
    {
        using var gate = new System.Threading.ManualResetEvent(false);
        RecordingOptions options = Options();
        options.FramesWaiting = 16;
        options.CreatesFile = path =>
        {
            gate.WaitOne();
            return File.Create(path);
        };
        var pair = new Rabit.Links.MemoryLinkPair("slow", 64 * 1024);
        var manager = new CommunicationsManager(new CommunicationsOptions { Links = [pair.A], Recording = options });
        var reactor = new RabitReactor(new ReactorOptions { StopsOnSignals = false })
        {
            manager, new FakeAutopilot(1024),
        };
        reactor.Workspace.Publish(MessageNames.OwnAddress, new OwnAddress { ComponentId = 191 });
        reactor.Workspace.Publish<VehicleState>(MessageNames.VehicleState);
        System.Threading.Tasks.Task<ReactorResult> run = reactor.RunAsync();
        for (int n = 0; n < 200; n++)
            pair.B.Write(Frames.Heartbeat(sequence: (byte)n), 0, Frames.Heartbeat().Length);
        Assert.True(System.Threading.SpinWait.SpinUntil(
            () => manager.SummariseRecording()!.Value.FramesDropped >= 200 - 17, TimeSpan.FromSeconds(20)));
        gate.Set();
        reactor.Stop();
        await run;
        RecordingStatus status = manager.SummariseRecording()!.Value;
        Assert.Equal(200, status.Frames + status.FramesDropped);
        Assert.Equal(status.Frames, Read(Files().Single()).Count);
    }

    [Fact]
    public void Options_FolderThatCannotBeWritten_IsAnErrorAtTheStart()
    {
        Directory.CreateDirectory(_folder);
        string file = Path.Combine(_folder, "file");
        File.WriteAllText(file, "no folder");
        var options = new CommunicationsOptions
        {
            Links = [new Rabit.Links.MemoryLinkPair("x", 100).A],
            Recording = new RecordingOptions { Folder = Path.Combine(file, "below") },
        };
        string text = Assert.Throws<ArgumentException>(() => new CommunicationsManager(options)).Message;
        Assert.StartsWith($"the folder of the recording, {Path.Combine(file, "below")}, cannot be written: ", text);

        options.Recording = new RecordingOptions { Folder = "", Name = "a/b", MaxFileBytes = 1, MaxFiles = 0 };
        text = Assert.Throws<ArgumentException>(() => new CommunicationsManager(options)).Message;
        Assert.All(["Folder", "Name", "MaxFileBytes", "MaxFiles"], n => Assert.Contains("Recording." + n, text));
    }

    [Fact]
    public void Recording_WithoutAFrame_LeavesNoFile()
    {
        using (CommunicationsRig rig = Rig(1))
            rig.Run(TimeSpan.FromSeconds(1));
        Assert.Empty(Files());
    }

    [Fact]
    public void Replay_OfARecording_CountsWhatTheLinkCounted()
    {
        LinkSummary flown;
        using (CommunicationsRig rig = Rig(1).As(1))
        {
            for (int n = 0; n < 300; n++)
            {
                rig.Send(
                    0, Frames.Of(new Attitude { Roll = n }, sequence: (byte)(n * 2)),
                    Frames.Heartbeat(sequence: (byte)((n * 2) + 1)));
                rig.SendOwn(new Heartbeat { Type = MavType.OnboardController, MavlinkVersion = 3 });
            }

            flown = rig.Manager.SummariseLinks()[0];
        }

        using RecordedFile file = RecordedFile.Open(
            Rabit.Links.LinkUrl.Parse($"tlog:{Files().Single()}?speed=max"));
        using CommunicationsRig replay = new CommunicationsRig(0, o => o.RecordedFiles = [file]).As(1);
        replay.Run(TimeSpan.FromMinutes(2));
        LinkSummary played = replay.Manager.SummariseLinks()[0];
        Assert.Equal(
            flown.Counts.Select(c => (c.MessageId, c.Count)),
            played.Counts.Where(c => c.ComponentId == 1).Select(c => (c.MessageId, c.Count)));
        Assert.Equal(300, played.Counts.Single(c => c.ComponentId == 191 && c.MessageId == 0).Count);
        Assert.All(played.Sources, s => Assert.Equal(0, s.Missing + s.OutOfOrder));
    }

    [Theory]
    [InlineData(-3600)]
    [InlineData(3600)]
    [InlineData(365.25 * 24 * 3600 * 20)]
    [InlineData(-365.25 * 24 * 3600 * 20)]
    public void WallClock_ThatSteps_KeepsNoFrameAndNoRecordBack(double seconds)
    {
        int forwarded = 0;
        using (CommunicationsRig rig = Rig(2).As(1))
        {
            for (int n = 0; n < 20; n++)
            {
                if (n == 10)
                    rig.Time.StepWallClock(TimeSpan.FromTicks((long)(seconds * TimeSpan.TicksPerSecond)));
                rig.Send(0, Frames.Heartbeat(sequence: (byte)n));
                rig.Run(TimeSpan.FromSeconds(0.5));
                forwarded += rig.ReceivedFrames(1).Count(f => f.SystemId == 1 && f.ComponentId == 1);
            }

            Assert.Equal(LinkState.Receiving, rig.LastStatus(0).State);
            Assert.All(rig.Log, l => Assert.Null(l.Exception));
            Assert.Null(rig.Finish().Failure);
        }

        Assert.Equal(20, forwarded);
        IEnumerable<int> recorded = Files().SelectMany(f => Read(f)).Select(f => (int)f.Sequence);
        Assert.Equal(Enumerable.Range(0, 20), recorded.OrderBy(n => n));
    }

    private RecordingOptions Options() => new() { Folder = _folder, Name = "test" };

    private CommunicationsRig Rig(
        int links, Action<CommunicationsOptions>? configure = null, DateTimeOffset? start = null)
        => new(
            links,
            o =>
            {
                (o.Recording, o.PositionRateHz) = (Options(), 0);
                configure?.Invoke(o);
            },
            startUtc: start);

    private string[] Files() => Directory.Exists(_folder) ? Directory.GetFiles(_folder) : [];

    private static List<MavlinkFrame> Read(string path) => Read(path, out _);

    private static List<MavlinkFrame> Read(string path, out long lostBytes)
    {
        using FileStream stream = File.OpenRead(path);
        var log = new TlogReader(stream, MavlinkDialect.All);
        var frames = new List<MavlinkFrame>();
        while (log.TryRead(out MavlinkFrame frame, out _))
            frames.Add(frame);
        lostBytes = log.LostBytes;
        return frames;
    }

    private static string Describe(MavlinkFrame frame)
        => $"{frame.SystemId}/{frame.ComponentId} {frame.MessageId} #{frame.Sequence}";
}
