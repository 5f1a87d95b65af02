using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Core;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Camera;

public sealed class CameraRecorderTests : IDisposable
{
    private static readonly DateTimeOffset StartUtc = new(2026, 3, 2, 10, 0, 0, TimeSpan.Zero);

    private readonly string _folder = Path.Combine(Path.GetTempPath(), "rabit-" + Guid.NewGuid().ToString("N"));

    public void Dispose()
    {
        if (Directory.Exists(_folder))
            Directory.Delete(_folder, recursive: true);
    }

    [Fact]
    public void Recorder_Folder_IsTheSameCameraForWhoeverReadsIt()
    {
        SimulatedCameraOptions options = Options();
        CameraFolder folder = CameraFolder.Create(_folder, options.Camera, new CameraMount());
        var direct = new Taker(new SimulatedCamera(options, Hover(), [], seed: 5));
        Run(direct);
        var recorder = new CameraRecorderManager(
            new SimulatedCamera(options, Hover(), [], seed: 5), new PictureFolderWriter(folder));
        Run(recorder);

        var read = new Taker(new FolderCamera(CameraFolder.Open(_folder)));
        Run(read);

        Assert.Equal((6, 0), (recorder.PicturesWritten, recorder.PicturesDropped));
        Assert.Equal([0, 1, 2, 3, 4, 5], read.Frames.Select(f => f.Number));
        Assert.Equal(
            direct.Frames.Select(f => (f.Number, f.FrameStart, f.Exposure)),
            read.Frames.Select(f => (f.Number, f.FrameStart, f.Exposure)));
        for (int i = 0; i < 6; i++)
            Assert.Equal(direct.Pictures[i], read.Pictures[i]);
    }

    [Fact]
    public void Recorder_FolderGone_SaysSoInTheLogAndCountsTheRest()
    {
        SimulatedCameraOptions options = Options();
        CameraFolder folder = CameraFolder.Create(_folder, options.Camera, new CameraMount());
        Directory.Delete(_folder, recursive: true);
        var camera = new SimulatedCamera(options, Hover(), [], seed: 5);
        var recorder = new CameraRecorderManager(camera, new PictureFolderWriter(folder));

        List<RabitLogEntry> log = Run(recorder);

        Assert.Equal((0, 5), (recorder.PicturesWritten, recorder.PicturesDropped));
        Assert.Contains(
            "cannot be written", string.Join("\n", log.Where(e => e.Kind == RabitLogKind.Fault)),
            StringComparison.Ordinal);
        Assert.Equal(0, camera.FramesWithoutBuffer);
        Assert.Empty(camera.BufferHolders());
    }

    private static List<RabitLogEntry> Run(RabitManager manager)
    {
        var log = new List<RabitLogEntry>();
        var reactor = new RabitReactor(
            new ReactorOptions
            {
                Time = new VirtualTime(3, StartUtc),
                Log = log.Add,
                StopsOnSignals = false
            }) { manager };
        reactor.Start();
        reactor.RunFor(TimeSpan.FromSeconds(3.5));
        reactor.Stop();
        reactor.Finish();
        return log;
    }

    private static TruthHistory Hover()
    {
        var truth = new TruthHistory(10);
        for (int second = 0; second < 10; second++)
        {
            TruePose pose = Scene.Pose(30, yaw: 20 * second);
            pose.Time = TimeSpan.FromSeconds(second);
            truth.Add(pose);
        }

        return truth;
    }

    private static SimulatedCameraOptions Options() => new()
    {
        Camera = new CameraModel { Width = 64, Height = 48, FocalX = 53, FocalY = 53, CentreX = 31.5, CentreY = 23.5 },
    };

    private sealed class Taker : RabitManager
    {
        private readonly BlockingReader<CameraFrame> _reader;

        public Taker(IReaderSource<CameraFrame> camera)
            : base("taker") => _reader = AttachReader("camera", camera);

        public List<CameraFrame> Frames { get; } = [];

        public List<byte[]> Pictures { get; } = [];

        protected override void ExecuteUnitOfWork()
        {
            while (_reader.TryPop(out CameraFrame frame))
            {
                Frames.Add(frame);
                Pictures.Add(frame.Pixels.Span.Slice(0, frame.Width * frame.Height * 3).ToArray());
                frame.Dispose();
            }
        }
    }
}
