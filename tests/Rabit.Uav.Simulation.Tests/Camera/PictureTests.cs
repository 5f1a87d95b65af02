using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Tests.Shared;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Camera;

public class PictureTests(ITestOutputHelper output)
{
    private static readonly IReadOnlyList<SimulatedTarget> Things =
        TargetField.Place(9, Scene.Corners((-60, -80), (60, -80), (60, 80), (-60, 80)), targets: 5, distractors: 10);

    [Fact]
    public void Render_SameSeedAndPose_GivesTheSameBytes()
    {
        SimulatedCameraOptions options = SimulatedCameraOptions.CreateLowResolution();
        byte[] first = Render(options, seed: 4, number: 17);

        Assert.Equal(first, Render(options, seed: 4, number: 17));
        Assert.NotEqual(first, Render(options, seed: 5, number: 17));
        Assert.NotEqual(first, Render(options, seed: 4, number: 18));
    }

    [Fact]
    public void Render_SeedOne_IsThePictureItAlwaysWas()
    {
        // The same on every runtime: no function but + - * / and square root has a part in it that could differ by a
        // bit.
        ulong hash = 14_695_981_039_346_656_037;
        foreach (byte level in Render(SimulatedCameraOptions.CreateLowResolution(), seed: 1, number: 0))
            hash = (hash ^ level) * 1_099_511_628_211;

        output.WriteLine($"{hash:X16}");
        Assert.Equal("E83BA18537E583AF", $"{hash:X16}");
    }

    [Fact]
    public void Render_Noise_HasTheDeviationThatWasAskedFor()
    {
        SimulatedCameraOptions noisy = SimulatedCameraOptions.CreateLowResolution();
        noisy.NoiseSigma = 3;
        SimulatedCameraOptions clean = SimulatedCameraOptions.CreateLowResolution();
        clean.NoiseSigma = 0;

        byte[] a = Render(noisy, seed: 1, number: 1);
        byte[] b = Render(clean, seed: 1, number: 1);
        double[] noise = a.Zip(b, (x, y) => (double)x - y).ToArray();

        double mean = noise.Average();
        double deviation = Math.Sqrt(noise.Average(n => (n - mean) * (n - mean)));
        output.WriteLine($"mean {mean:F3}, deviation {deviation:F3}");
        Assert.InRange(mean, -0.1, 0.1);
        Assert.InRange(deviation, 2.9, 3.1);

        // No pattern from one pixel to the next, or from one row to the next.
        Assert.InRange(Correlation(noise, 3), -0.02, 0.02);
        Assert.InRange(Correlation(noise, 320 * 3), -0.02, 0.02);
    }

    [Fact]
    public void Render_Ground_HasNoColourOfATarget()
    {
        SimulatedCameraOptions options = SimulatedCameraOptions.CreateLowResolution();
        for (ulong seed = 1; seed <= 10; seed++)
        {
            byte[] picture = Render(options, seed, number: 0, things: [], height: 100);
            for (int at = 0; at < picture.Length; at += 3)
            {
                int most = Math.Max(picture[at], Math.Max(picture[at + 1], picture[at + 2]));
                int least = Math.Min(picture[at], Math.Min(picture[at + 1], picture[at + 2]));
                Assert.True(
                    most < 200 && (most - least) < 0.62 * most + 12,
                    $"seed {seed}: {picture[at]}, {picture[at + 1]}, {picture[at + 2]}");
            }
        }
    }

    [Fact]
    public void Render_Ground_LiesStillInTheWorld()
    {
        SimulatedCameraOptions options = Scene.Pinhole();
        options.NoiseSigma = 0;
        var renderer = new PictureRenderer(options, [], seed: 2);

        // 26.5 m above, a pixel is 0.1 m: 4 m to the east are 40 pixels, across the seam of the texture at 256 m too.
        byte[] here = Shoot(renderer, options, Scene.Pose(26.5), 0, 254);
        byte[] there = Shoot(renderer, options, Scene.Pose(26.5), 0, 258);

        double sum = 0;
        for (int v = 60; v < 180; v++)
        {
            for (int u = 100; u < 180; u++)
                sum += Math.Abs(here[((v * 320) + u + 40) * 3] - there[((v * 320) + u) * 3]);
        }

        Assert.InRange(sum / (120 * 80), 0, 2.5);   // the corners are a little darker
    }

    [Fact]
    public void Render_LookingForward_ShowsTheHorizonWhereItIs()
    {
        SimulatedCameraOptions options = Scene.Pinhole();
        options.NoiseSigma = 0;
        var renderer = new PictureRenderer(options, [], seed: 2);
        byte[] level = Shoot(renderer, options, Scene.Pose(40, cameraPitch: 0), 0, 0);
        byte[] banked = Shoot(renderer, options, Scene.Pose(40, roll: 20, cameraPitch: 0), 0, 0);
        byte[] noseUp = Shoot(renderer, options, Scene.Pose(40, pitch: 10, cameraPitch: 0), 0, 0);

        for (int u = 0; u < 320; u += 8)
        {
            AssertHorizon(level, u, 120);

            // Right side down: the horizon stands the other way round, higher at the right.
            AssertHorizon(banked, u, 120 - ((u - 160) * Math.Tan(Scene.Degrees(20))));
            AssertHorizon(noseUp, u, 120 + (265 * Math.Tan(Scene.Degrees(10))));
        }
    }

    [Fact]
    public void Render_OnTheGround_SeesNothing()
    {
        SimulatedCameraOptions options = SimulatedCameraOptions.CreateLowResolution();
        options.NoiseSigma = 0;
        var renderer = new PictureRenderer(options, [Scene.Panel(0, 0)], seed: 2);

        byte[] picture = Shoot(renderer, options, Scene.Pose(0), 0, 0);

        Assert.All(picture, level => Assert.InRange(level, 10, 40));
    }

    [Fact]
    public void Render_VeryLowOverAPanel_FillsThePictureWithIt()
    {
        SimulatedCameraOptions options = Scene.Pinhole();
        options.NoiseSigma = 0;
        var renderer = new PictureRenderer(options, [Scene.Panel(0, 0)], seed: 2);

        byte[] picture = Shoot(renderer, options, Scene.Pose(0.3, roll: 30), 0, 0);

        Assert.InRange(
            Enumerable.Range(0, 320 * 240).Count(i => picture[3 * i] > 165 && picture[(3 * i) + 1] < 50), 60_000,
            320 * 240);
    }

    [Fact]
    public void Render_FarAboveAndAway_NeverFails()
    {
        const int Seed = 3;
        output.WriteLine($"seed {Seed}");
        SimulatedCameraOptions options = Scene.Pinhole();
        options.Camera = new CameraModel
        {
            Width = 32,
            Height = 24,
            FocalX = 20,
            FocalY = 20,
            CentreX = 16,
            CentreY = 12
        };
        var renderer = new PictureRenderer(options, Things, seed: 2);
        var random = new Random(Seed);
        for (int run = 0; run < 2000; run++)
        {
            TruePose pose = Scene.Pose(
                Math.Pow(10, (6 * random.NextDouble()) - 2), 360 * random.NextDouble(), 180 * random.NextDouble(),
                360 * random.NextDouble(), 360 * random.NextDouble());
            Shoot(renderer, options, pose, (random.NextDouble() - 0.5) * 1e6, (random.NextDouble() - 0.5) * 1e6);
            Shoot(renderer, options, pose, (random.NextDouble() - 0.5) * 100, (random.NextDouble() - 0.5) * 100);
        }
    }

    [Fact]
    public void Render_AgainAndAgain_AllocatesNothing()
    {
        SimulatedCameraOptions options = SimulatedCameraOptions.CreateLowResolution();
        var renderer = new PictureRenderer(options, Things, seed: 2);
        byte[] pixels = new byte[320 * 240 * 3];
        TruePose pose = Scene.Pose(40);
        void Work()
        {
            var cameraPose = new CameraPose(pose, options);
            renderer.Render(cameraPose, cameraPose, cameraPose, 5, pixels);
        }

        Work();

        Assert.Equal(0, Allocated.By(Work));
    }

    [Fact]
    public void Options_OutOfRange_AreAllNamed()
    {
        var options = new SimulatedCameraOptions
        {
            Camera = new CameraModel { Width = 2, Height = 480, FocalX = 0, FocalY = 1 },
            FramesPerSecond = 0,
            Delay = TimeSpan.FromMilliseconds(1),
            NoiseSigma = double.NaN,
            Buffers = 0,
        };

        string text = Assert.Throws<ArgumentException>(
            () => new SimulatedCamera(options, new TruthHistory(2), [], seed: 1)).Message;

        Assert.All(
            ["Width is 2", "focal lengths", "FramesPerSecond", "Delay", "NoiseSigma", "Buffers"],
            part => Assert.Contains(part, text, StringComparison.Ordinal));
    }

    private static void AssertHorizon(byte[] picture, int u, double row)
    {
        // Haze hides the horizon itself; a little above it the sky is blue, a little below it the ground is not.
        int above = (int)row - 45;
        int below = (int)row + 45;
        if (above is >= 0 and < 240)
            Assert.True(
                Channel(picture, u, above, 2) > Channel(picture, u, above, 0) + 12, $"no sky at ({u}, {above})");
        if (below is >= 0 and < 240)
            Assert.True(
                Channel(picture, u, below, 2) < Channel(picture, u, below, 0) + 4, $"no ground at ({u}, {below})");
    }

    private static int Channel(byte[] picture, int u, int v, int channel) => picture[(((v * 320) + u) * 3) + channel];

    private static byte[] Shoot(
        PictureRenderer renderer, SimulatedCameraOptions options, TruePose pose, double north, double east)
    {
        pose.Position = pose.Position with { North = north, East = east };
        var cameraPose = new CameraPose(pose, options);
        byte[] pixels = new byte[options.Camera.Width * options.Camera.Height * 3];
        renderer.Render(cameraPose, cameraPose, cameraPose, 0, pixels);
        return pixels;
    }

    private static byte[] Render(
        SimulatedCameraOptions options, ulong seed, long number, IReadOnlyList<SimulatedTarget>? things = null,
        double height = 60)
    {
        var cameraPose = new CameraPose(Scene.Pose(height), options);
        byte[] pixels = new byte[options.Camera.Width * options.Camera.Height * 3];
        new PictureRenderer(options, things ?? Things, seed).Render(cameraPose, cameraPose, cameraPose, number, pixels);
        return pixels;
    }

    private static double Correlation(double[] noise, int distance)
    {
        (double product, double square) = (0, 0);
        for (int at = 0; at < noise.Length - distance; at++)
        {
            product += noise[at] * noise[at + distance];
            square += noise[at] * noise[at];
        }

        return product / square;
    }
}
