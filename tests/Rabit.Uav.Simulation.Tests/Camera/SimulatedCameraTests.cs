using System;
using System.Linq;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Camera;

public class SimulatedCameraTests
{
    [Fact]
    public void Read_EvenFlight_DeliversAtTheRightTimesWithTheRightStamps()
    {
        using var run = new CameraRun(SimulatedCameraOptions.CreateLowResolution());

        run.Fly(3.2);

        Assert.Equal([0, 1, 2, 3, 4, 5], run.Taken.Select(t => t.Frame.Number));
        Assert.Equal([500, 1000, 1500, 2000, 2500, 3000], run.Taken.Select(t => t.Frame.FrameStart.TotalMilliseconds));
        Assert.Equal([620, 1120, 1620, 2120, 2620, 3120], run.Taken.Select(t => t.Time.TotalMilliseconds));
        Assert.All(run.Taken, t => Assert.Equal(TimeSpan.FromMilliseconds(2), t.Frame.Exposure));
        Assert.All(run.Taken, t => Assert.Equal((320, 240), (t.Frame.Width, t.Frame.Height)));
        Assert.Equal(6, run.Camera.FramesDelivered);
        Assert.Empty(run.Camera.BufferHolders());
    }

    [Fact]
    public void Read_OddRate_DoesNotDrift()
    {
        SimulatedCameraOptions options = Small();
        options.FramesPerSecond = 3;
        using var run = new CameraRun(options);

        run.Fly(20.2);

        Assert.Equal(60, run.Taken.Count);
        Assert.Equal(20_000, run.Taken[59].Frame.FrameStart.TotalMilliseconds);
    }

    [Fact]
    public void Read_FastFlight_ShowsTheMiddleOfTheExposure()
    {
        // 50 m/s and an exposure of 20 ms: at the start of it the vehicle is half a metre (3.3 px) south of where it is
        // in the middle, at the delivery 5 m north.
        SimulatedCameraOptions options = Scene.Pinhole();
        (options.Exposure, options.NoiseSigma) = (TimeSpan.FromMilliseconds(20), 0);
        using var run = new CameraRun(options, speed: 50, Scene.Panel(50 * 0.51, 0));

        run.Fly(0.7);

        int[] rows = Enumerable.Range(0, 240).Where(v => run.LastPicture[((v * 320) + 160) * 3] > 175).ToArray();
        Assert.NotEmpty(rows);
        Assert.Equal(120, rows.Average(), 0.6);
        Assert.Equal(TimeSpan.FromMilliseconds(510), run.Taken[0].Frame.MidExposure);
    }

    [Fact]
    public void Read_Frozen_GivesNothingAndLosesTheNumbers()
    {
        SimulatedCameraOptions options = Small();
        options.Freezes =
        [
            new CameraFreeze(TimeSpan.FromSeconds(1), TimeSpan.FromSeconds(1)),
            new CameraFreeze(TimeSpan.FromSeconds(2.9), TimeSpan.FromSeconds(0.2))
        ];
        using var run = new CameraRun(options);

        run.Fly(4.2);

        Assert.Equal([0, 3, 4, 6, 7], run.Taken.Select(t => t.Frame.Number));
        Assert.Equal([0.5, 2, 2.5, 3.5, 4], run.Taken.Select(t => t.Frame.FrameStart.TotalSeconds));
        Assert.Equal((5, 3, 0, 0), (run.Camera.FramesDelivered, run.Camera.FramesFrozen, run.Camera.FramesOvertaken,
            run.Camera.FramesWithoutBuffer));
    }

    [Fact]
    public void Read_NoBufferFree_LosesPicturesAndGoesOnWhenOneIsGivenBack()
    {
        SimulatedCameraOptions options = Small();
        options.Buffers = 2;
        using var run = new CameraRun(options) { KeepsPictures = true };

        run.Fly(2.2);
        Assert.Equal((2, 2), (run.Camera.FramesDelivered, run.Camera.FramesWithoutBuffer));
        Assert.Equal(2, run.Camera.BufferHolders().Count);
        run.Taken[0].Frame.Dispose();
        run.Fly(1);

        Assert.Equal([0, 1, 4], run.Taken.Select(t => t.Frame.Number));
        Assert.Equal(3, run.Camera.FramesWithoutBuffer);
        Assert.Equal(
            new CameraStatistics
            {
                Delivered = 3,
                WithoutBuffer = 3,
                TimeSource = "clock of the simulation, standard deviation 0 ms",
            },
            run.Camera.Statistics);
    }

    [Fact]
    public void Read_TruthNotKnown_LosesPicturesAndDoesNotHang()
    {
        using var run = new CameraRun(Small());

        run.Wait(2);
        Assert.Empty(run.Taken);
        run.Fly(2.2);

        Assert.Equal([3, 4, 5, 6, 7], run.Taken.Select(t => t.Frame.Number).Where(n => n >= 3));
        Assert.Equal(8, run.Camera.FramesDelivered + run.Camera.FramesOvertaken);
    }

    [Fact]
    public void Read_AgainAndAgain_AllocatesNothing()
    {
        using var run = new CameraRun(Small(), isMetered: true);

        run.Fly(5);

        Assert.Equal(0, run.Meter.LastAllocated);
    }

    private static SimulatedCameraOptions Small() => new()
    {
        Camera = new CameraModel { Width = 64, Height = 48, FocalX = 53, FocalY = 53, CentreX = 31.5, CentreY = 23.5 },
    };
}
