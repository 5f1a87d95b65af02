using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using Rabit.Core;
using Rabit.Tests.Shared;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.VideoDevices;
using Rabit.Uav.Messages;
using Rabit.Vision;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing.VideoDevices;

/// <summary>A video device, against a kernel that is made up; and what there is of a real one.</summary>
public sealed class V4l2CameraTests : IDisposable
{
    private static readonly string Picture = Path.Combine(Repository.Root, "tests", "data", "jpeg", "420.jpg");
    private static readonly byte[] Jpeg = File.ReadAllBytes(Picture);
    private static readonly TimeSpan MaxWait = TimeSpan.FromSeconds(30);

    private readonly ConcurrentQueue<string> _log = new();
    private readonly ConcurrentQueue<(CameraFrame Frame, byte[] Pixels, TimeSpan Now)> _taken = new();
    private FakeVideoSystem _system = new(8);
    private V4l2Camera? _camera;
    private RabitReactor? _reactor;
    private MeasuringSource? _source;

    public void Dispose()
    {
        Stop();
        _system.Dispose();
    }

    [Theory]
    [InlineData(4)]
    [InlineData(8)]
    public void Read_Mjpeg_GivesThePictureInBothLayouts(int pointerBytes)
    {
        _system = new FakeVideoSystem(pointerBytes);
        Start(Options());
        _system.Deliver([.. Jpeg, 0, 0, 0, 0], sequence: 1);   // drivers pad
        Take(1);
        _system.Deliver(Jpeg, sequence: 2);
        Take(2);
        _system.Deliver(Jpeg, sequence: 5);
        Take(3);

        Assert.All(_taken, t => Assert.Equal(PictureFile.Load(Picture).Pixels, t.Pixels));
        Assert.Equal([0, 1, 4], _taken.Select(t => t.Frame.Number));
        CameraStatistics counts = _camera!.Statistics;
        Assert.Equal((3, 0, null), (counts.Delivered, counts.Refused, counts.Fault));
        Assert.Contains("/dev/video0: Made-up camera", _log);
    }

    [Theory]
    [InlineData(4)]
    [InlineData(8)]
    public void Read_Yuyv_GivesThePictureInBothLayouts(int pointerBytes)
    {
        _system = new FakeVideoSystem(pointerBytes) { Offers = (4, 2, FakeVideoSystem.Yuyv), RowBytes = 12 };
        V4l2CameraOptions options = Options();
        (options.Format, options.Width, options.Height) = (V4l2PixelFormat.Yuyv, 4, 2);
        Start(options);

        _system.Deliver([.. Enumerable.Repeat<byte[]>([235, 128], 6).SelectMany(b => b),
            .. Enumerable.Repeat<byte[]>([16, 128], 4).SelectMany(b => b)]);
        Take(1);

        Assert.Equal(
            [.. Enumerable.Repeat((byte)255, 12), .. Enumerable.Repeat((byte)0, 12)], _taken.Single().Pixels);
    }

    // The clock of the driver says how old the picture is.
    [Theory]
    [InlineData(4, FakeVideoSystem.StartOfExposure, 30_000, 30, 5)]
    [InlineData(8, FakeVideoSystem.StartOfExposure, 30_000, 30, 5)]
    [InlineData(8, FakeVideoSystem.EndOfFrame, 30_000, 30 + 4 + 15, 5)]
    [InlineData(8, FakeVideoSystem.NoClock, 30_000, 50 + 4, 20)]
    [InlineData(8, FakeVideoSystem.StartOfExposure, -1_000_000, 50 + 4, 20)]
    [InlineData(8, FakeVideoSystem.StartOfExposure, 60_000_000, 50 + 4, 20)]
    public void Read_Stamp_IsMappedToTheClockOfTheRun(
        int pointerBytes, uint flags, long ageMicroseconds, double earlierMilliseconds, double noiseMilliseconds)
    {
        _system = new FakeVideoSystem(pointerBytes) { Controls = { [0x9A_0902] = (1, 5000, 100) } };
        V4l2CameraOptions options = Options();
        options.Readout = TimeSpan.FromMilliseconds(15);
        options.Exposure = TimeSpan.FromMilliseconds(4);
        Start(options);

        TimeSpan before = _reactor!.Now;
        _system.Deliver(Jpeg, flags, ageMicroseconds);
        Take(1);

        (CameraFrame frame, _, TimeSpan now) = _taken.Single();
        TimeSpan arrival = frame.FrameStart + TimeSpan.FromTicks((long)(earlierMilliseconds * 10_000));
        Assert.InRange(arrival, before, now);
        Assert.Equal((4.0, noiseMilliseconds), (frame.Exposure.TotalMilliseconds, frame.TimeNoise.TotalMilliseconds));
        Assert.Equal(
            noiseMilliseconds < 20
                ? "time of the driver, standard deviation 5 ms"
                : "arrival less 50 ms, standard deviation 20 ms",
            _camera!.Statistics.TimeSource);
    }

    [Theory]
    [InlineData(FakeVideoSystem.StartOfExposure, 8)]
    [InlineData(FakeVideoSystem.NoClock, 20)]
    public void Read_StatedNoise_IsNoLessThanArrivalAllows(uint flags, double expectedMilliseconds)
    {
        _system = new FakeVideoSystem(8);
        V4l2CameraOptions options = Options();
        options.TimeNoise = TimeSpan.FromMilliseconds(8);
        Start(options);

        _system.Deliver(Jpeg, flags, 30_000);
        Take(1);

        Assert.Equal(expectedMilliseconds, _taken.Single().Frame.TimeNoise.TotalMilliseconds);
    }

    [Fact]
    public void Open_ExposureAndFocus_AreSetAsFarAsTheDeviceCan()
    {
        _system.Controls[0x9A_0901] = (0, 3, 3);
        _system.Controls[0x9A_0902] = (50, 5000, 156);
        _system.Controls[0x9A_0903] = (0, 1, 1);
        V4l2CameraOptions options = Options();
        (options.Exposure, options.Focus, options.FramesPerSecond) = (TimeSpan.FromMilliseconds(2), 30, 7.5);
        Start(options);
        _system.Deliver(Jpeg);
        Take(1);

        Assert.Equal(
            (1, 50, 0),
            (_system.Controls[0x9A_0901].Value, _system.Controls[0x9A_0902].Value, _system.Controls[0x9A_0903].Value));
        Assert.Equal(5, _taken.Single().Frame.Exposure.TotalMilliseconds);   // 50 units is the least that it can
        Assert.Contains("/dev/video0: it has no control of its focus", _log);
        Assert.DoesNotContain("/dev/video0: it has no control of its exposure", _log);
        Assert.Equal((1000u, 7500u), _system.Period);
    }

    [Fact]
    public void Read_Unplugged_IsAFaultAndOpenedAgainWhenItIsBack()
    {
        Start(Options());
        _system.Deliver(Jpeg);
        Take(1);

        _system.Unplug();
        WaitForLog("/dev/video0: it was unplugged; it is opened again in 0.05 s");
        WaitForLog("/dev/video0: there is no such device; it is opened again in 0.1 s");
        Assert.Equal("/dev/video0: there is no such device", _camera!.Statistics.Fault);
        Assert.Equal((_system.Opened, 0), (_system.Closed, _system.MappedNow));

        _system.IsUnplugged = false;
        _system.Deliver(Jpeg);
        Take(2);
        Assert.Null(_camera.Statistics.Fault);
        Assert.True(_camera.Statistics.Restarts >= 2);
        Stop();
        Assert.Equal((_system.Opened, 0), (_system.Closed, _system.MappedNow));
    }

    [Theory]
    [InlineData(13, "permission denied; add the user to the group 'video'")]
    [InlineData(16, "it is in use by another program")]
    [InlineData(24, "opening failed: error 24 of the operating system")]
    public void Open_Fails_SaysWhyAndIsTriedAgain(int error, string reason)
    {
        _system.OpenError = error;
        Start(Options());
        WaitForLog("/dev/video0: " + reason);

        _system.OpenError = 0;
        _system.Deliver(Jpeg);
        Take(1);
    }

    [Fact]
    public void Open_OtherFormat_NamesWhatItGives()
    {
        _system.Offers = (640, 480, FakeVideoSystem.Yuyv);
        Start(Options());

        WaitForLog("/dev/video0: Made-up camera gives 640 x 480 YUYV; 61 x 43 MJPG is wanted; it is opened again in");
        Assert.True(SpinWait.SpinUntil(() => _system.Opened == _system.Closed, MaxWait));
    }

    [Fact]
    public void Read_NothingComes_IsAFault()
    {
        V4l2CameraOptions options = Options();
        options.StallTimeout = TimeSpan.FromSeconds(0.2);
        Start(options);

        WaitForLog("/dev/video0: it gave no picture for 0.2 s; it is opened again in 0.05 s");
        _system.Deliver(Jpeg);
        Take(1);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Read_OnlyPicturesThatCannotBeUsed_IsAFault(bool areDamaged)
    {
        V4l2CameraOptions options = Options();
        options.StallTimeout = TimeSpan.FromSeconds(0.2);
        Start(options);
        _system.Deliver(Jpeg);
        Take(1);

        string fault = "/dev/video0: it gave only pictures that cannot be used for 0.2 s (";
        bool isFault = SpinWait.SpinUntil(
            () =>
            {
                if (areDamaged)
                    _system.Deliver(Jpeg, FakeVideoSystem.StartOfExposure | 0x40);
                else
                    _system.Deliver([0xFF, 0xD8, 0xFF, 0xD9]);
                return _log.Any(l => l.StartsWith(fault, StringComparison.Ordinal));
            },
            MaxWait);
        Assert.True(isFault, string.Join("\n", _log));
        string line = _log.First(l => l.StartsWith(fault, StringComparison.Ordinal));

        // On a busy machine it may have had no picture for so long before.
        Assert.Matches(@"; it is opened again in 0\.\d+ s$", line);

        Assert.True(
            SpinWait.SpinUntil(
                () => _camera!.Statistics.Restarts > 0 && _camera.Statistics.Restarts == _log.Count(
                    l => l.Contains("it is opened again", StringComparison.Ordinal)),
                MaxWait),
            $"{_camera!.Statistics}");
        _system.Deliver(Jpeg);
        Take(2);
        Assert.Null(_camera.Statistics.Fault);
    }

    [Theory]
    [InlineData(uint.MaxValue, null, "says that a row has 4294967295 bytes")]
    [InlineData(1u << 31, null, "says that a row has 2147483648 bytes")]
    [InlineData(100_000_000u, null, "says that a row has 100000000 bytes")]
    [InlineData(1u << 20, null, "a part of a picture is missing")]
    [InlineData(0u, uint.MaxValue, "says that a buffer has 4294967295 bytes")]
    [InlineData(0u, (1u << 28) + 1, "says that a buffer has 268435457 bytes")]
    public void Read_DriverThatSaysNonsense_IsAFaultByName(uint rowBytes, uint? bytes, string fault)
    {
        (_system.Offers, _system.RowBytes, _system.StatedBytes) = ((60, 43, FakeVideoSystem.Yuyv), rowBytes, bytes);
        V4l2CameraOptions options = Options();
        (options.Format, options.Width) = (V4l2PixelFormat.Yuyv, 60);
        options.StallTimeout = TimeSpan.FromSeconds(0.1);
        Start(options);
        for (int count = 1; fault.StartsWith("a part", StringComparison.Ordinal) && count <= 2; count++)
            _system.Deliver(new byte[60 * 43 * 2]);

        Assert.True(
            SpinWait.SpinUntil(
                () => _camera!.Statistics.LastFault?.Contains(fault, StringComparison.Ordinal) == true, MaxWait),
            _camera!.Statistics.LastFault);
        Assert.Empty(_taken);
    }

    // A reader that ended with an exception would say so instead.
    [Fact]
    public void Read_DriverThatSaysAnExposureOfDays_IsNotTrusted()
    {
        _system.Controls[0x9A_0902] = (int.MaxValue, int.MaxValue, int.MaxValue);
        V4l2CameraOptions options = Options();
        options.Exposure = TimeSpan.FromMilliseconds(2);
        Start(options);
        _system.Deliver(Jpeg);
        Take(1);

        Assert.Equal(2, _taken.Single().Frame.Exposure.TotalMilliseconds);
    }

    [Fact]
    public void Read_OneInThreeCannotBeUsed_IsNotOpenedAgain()
    {
        V4l2CameraOptions options = Options();
        options.StallTimeout = TimeSpan.FromSeconds(0.1);
        Start(options);
        for (int count = 1; _reactor!.Now < TimeSpan.FromSeconds(0.5); count++)
        {
            _system.Deliver([0xFF, 0xD8, 0xFF, 0xD9]);
            long refused = count;
            Assert.True(
                SpinWait.SpinUntil(() => _camera!.Statistics is { } s && s.Refused + s.Skipped >= refused, MaxWait));
            _system.Deliver(Jpeg);
            Take(count);
        }

        Assert.Equal(0, _camera!.Statistics.Restarts);
    }

    [Fact]
    public void Read_DriverInError_IsAFaultAtOnce()
    {
        V4l2CameraOptions options = Options();
        options.StallTimeout = MaxWait;
        _system.IsBroken = true;
        Start(options);

        WaitForLog("/dev/video0: it loses every picture (error 5 of the operating system); it is opened again in");
        _system.IsBroken = false;
        _system.Deliver(Jpeg);
        Take(1);
    }

    [Fact]
    public void Read_PicturesThatCannotBeUsed_AreCountedAndGivenBack()
    {
        Start(Options());
        foreach (byte[] bad in new[] { [], Jpeg.Take(200).ToArray(), [0xFF, 0xD8, 0xFF, 0xD9] })
            _system.Deliver(bad);
        _system.Deliver(Jpeg, FakeVideoSystem.StartOfExposure | 0x40);
        Assert.True(SpinWait.SpinUntil(
            () => _camera!.Statistics is { } s && s.Refused + s.Skipped == 4, MaxWait), $"{_camera!.Statistics}");
        Assert.NotNull(_camera.Statistics.Fault);

        _system.Deliver(Jpeg);
        Take(1);
        Assert.Null(_camera.Statistics.Fault);
        Assert.True(SpinWait.SpinUntil(() => _system.Queued == 4, MaxWait), $"{_system.Queued} buffers");
    }

    [Fact]
    public void Read_AfterTheFirst_AllocatesNothing()
    {
        Start(Options());
        for (int count = 1; count <= 30; count++)
        {
            _system.Deliver(Jpeg, sequence: (uint)count);
            Take(count);
        }

        Stop();
        Assert.Equal(0, _source!.MinAllocated);
    }

    [Fact]
    public void New_OptionsThatAreNone_NamesThem()
    {
        ArgumentException e = Assert.Throws<ArgumentException>(() => new V4l2Camera(
            new V4l2CameraOptions
            {
                Device = "/dev/video0",
                Format = V4l2PixelFormat.Yuyv,
                Width = 61,
                Height = 43,
                FramesPerSecond = 0,
                Exposure = TimeSpan.Zero,
                Buffers = 0,
                StallTimeout = TimeSpan.Zero,
            },
            _system));

        foreach (string name in new[] { "/dev/video0", "Width", "FramesPerSecond", "Exposure", "Buffers", "timeout" })
            Assert.Contains(name, e.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("Exposure")]
    [InlineData("Readout")]
    [InlineData("Latency")]
    [InlineData("TimeNoise")]
    [InlineData("StallTimeout")]
    [InlineData("MaxRestartDelay")]
    public void New_TimeWithoutEnd_IsRefusedByName(string name)
    {
        V4l2CameraOptions options = Options();
        typeof(V4l2CameraOptions).GetProperty(name)!.SetValue(options, TimeSpan.MaxValue);

        Assert.Contains(
            name, Assert.Throws<ArgumentException>(() => new V4l2Camera(options, _system)).Message,
            StringComparison.Ordinal);
    }

    [VideoDeviceFact]
    public void RealDevice_GivesPictures()
    {
        V4l2CameraOptions options = Options();
        (options.Device, options.Format, options.Width, options.Height)
            = (VideoDeviceFactAttribute.Device, V4l2PixelFormat.Yuyv, 640, 480);
        Start(options, new LinuxVideoSystem());

        Take(3);
        Assert.All(_taken, t => Assert.InRange(t.Now - t.Frame.FrameStart, TimeSpan.Zero, TimeSpan.FromSeconds(1)));
        Assert.Contains(_taken, t => t.Pixels.Distinct().Skip(1).Any());
    }

    private static V4l2CameraOptions Options() => new()
    {
        Device = "/dev/video0",
        Width = 61,
        Height = 43,
        FirstRestartDelay = TimeSpan.FromSeconds(0.05),
    };

    private void Start(V4l2CameraOptions options, IVideoSystem? system = null)
    {
        _camera = new V4l2Camera(options, system ?? _system);
        _camera.LogTo(_log.Enqueue);
        _source = new MeasuringSource(_camera);
        _reactor = new RabitReactor(new ReactorOptions { StopsOnSignals = false })
        {
            new FrameTaker(_source, (frame, pixels, now) => _taken.Enqueue((frame, pixels, now))),
        };
        _reactor.Start();
    }

    private void Stop()
    {
        _reactor?.Stop();
        _reactor?.Finish();
        _reactor = null;
    }

    private void Take(int count)
        => Assert.True(
            SpinWait.SpinUntil(() => _taken.Count >= count, MaxWait),
            $"{_taken.Count} pictures; {_camera!.Statistics}");

    private void WaitForLog(string start)
        => Assert.True(
            SpinWait.SpinUntil(() => _log.Any(l => l.StartsWith(start, StringComparison.Ordinal)), MaxWait),
            string.Join("\n", _log));
}
