using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Camera;

/// <summary>What makes the simulated pictures worse: by itself, and all of it together.</summary>
public sealed class PictureEffectTests
{
    private static readonly SimulatedTarget[] Things = [Scene.Panel(1, 1)];

    [Fact]
    public void Render_NoEffects_IsThePictureWithoutThem()
        => Assert.Equal(Shoot(new SimulatedPictureEffects()), Shoot(effects: null));

    [Fact]
    public void MotionBlur_CameraStandsStill_ChangesNothing()
        => Assert.Equal(Shoot(effects: null), Shoot(new SimulatedPictureEffects { HasMotionBlur = true }));

    // 265 px from 20 m: half a metre between a quarter and three quarters is a metre in all, 13 px.
    [Fact]
    public void MotionBlur_CameraMoves_SmearsByTheWayOfTheWholeExposure()
    {
        var blur = new SimulatedPictureEffects { HasMotionBlur = true };
        (byte[] still, byte[] none) = (Shoot(effects: null), Shoot(effects: null, things: []));
        (byte[] smeared, byte[] smearedNone) = (Shoot(blur, 0.5), Shoot(blur, 0.5, things: []));

        Assert.InRange(RowsOf(still, none), 13, 15);
        Assert.InRange(RowsOf(smeared, smearedNone), 25, 28);
        Assert.Equal(ColumnsOf(still, none), ColumnsOf(smeared, smearedNone), 1.0);
    }

    [Fact]
    public void MotionBlur_CameraRolls_SmearsAcross()
    {
        SimulatedCameraOptions camera = Options(new SimulatedPictureEffects { HasMotionBlur = true });
        (TruePose middle, TruePose left, TruePose right) =
            (Scene.Pose(20), Scene.Pose(20, roll: -1), Scene.Pose(20, roll: 1));
        byte[] pixels = Render(camera, middle, left, right, Things);

        // 4 degrees in all, 18 px.
        Assert.InRange(ColumnsOf(pixels, Render(camera, middle, left, right, [])), 29, 34);
    }

    [Fact]
    public void Vignetting_Corners_AreDarkerAndTheMiddleIsNot()
    {
        byte[] plain = Shoot(effects: null);
        byte[] dark = Shoot(new SimulatedPictureEffects { Vignetting = 0.5 });

        Assert.Equal(1, MeanIn(dark, 150, 110, 20) / MeanIn(plain, 150, 110, 20), 0.02);
        Assert.Equal(0.5, MeanIn(dark, 0, 0, 10) / MeanIn(plain, 0, 0, 10), 0.06);
    }

    [Fact]
    public void Gains_TintAndExposure_AreMultiplesAndClipped()
    {
        var effects = new SimulatedPictureEffects { RedGain = 1.5, BlueGain = 0.5, ExposureGain = 1.2 };
        byte[] pixels = Enumerable.Repeat(new byte[] { 100, 100, 100, 200, 10, 0 }, 50).SelectMany(p => p).ToArray();
        new LightGain(effects, 10, 10).Apply(pixels);

        Assert.Equal([180, 120, 60, 255, 12, 0], pixels.Take(6));
    }

    [Fact]
    public void Shade_Ground_IsDarkerInHalfOfItAtTheSamePlaces()
    {
        SimulatedCameraOptions camera = Scene.Pinhole();
        var shade = new CloudShade(new LensRays(camera.Camera), darkness: 0.6, seed: 2);
        var levels = new List<int>();
        for (int i = 0; i < 20; i++)
            levels.AddRange(Shaded(shade, camera, 137 * i, -89 * i, 300).Select(l => (int)l));

        Assert.All(levels, l => Assert.InRange(l, 79, 200));   // 0.4 of 200 at least
        Assert.InRange(levels.Count(l => l < 140) / (double)levels.Count, 0.4, 0.6);

        // The ground under one camera is 26.5 px to the left for another one 6 m to the east, at 60 m.
        (double off, double moved) = (0, 0);
        for (int i = 0; i < 10; i++)
        {
            byte[] one = Shaded(shade, camera, 137 * i, -89 * i, 60);
            byte[] other = Shaded(shade, camera, 137 * i, 6 - (89 * i), 60);
            foreach (int at in Enumerable.Range(0, 320 * 240).Where(at => at % 320 is > 30 and < 310))
            {
                off += Math.Abs((0.5 * (other[at - 26] + other[at - 27])) - one[at]);
                moved += Math.Abs(other[at] - one[at]);
            }
        }

        Assert.True(off < 0.15 * moved, $"{off} off where it moved by {moved}");
    }

    [Fact]
    public void Jpeg_LowerQuality_TakesMore()
    {
        byte[] plain = Shoot(effects: null);
        double[] errors = [.. new[] { 95, 75, 40, 5 }.Select(q => Rms(plain, Shoot(new() { JpegQuality = q })))];

        Assert.InRange(errors[0], 0.3, 4);
        Assert.Equal(errors.OrderBy(e => e), errors);
        Assert.InRange(errors[3], 2 * errors[0], 30);
    }

    [Theory]
    [InlineData(32, 24)]
    [InlineData(31, 17)]   // neither whole blocks nor an even number
    [InlineData(9, 9)]
    public void Jpeg_EvenColour_StaysTheSame(int width, int height)
    {
        byte[] pixels = new byte[width * height * 3];
        for (int at = 0; at < pixels.Length; at += 3)
            (pixels[at], pixels[at + 1], pixels[at + 2]) = (90, 120, 60);
        new JpegLoss(width, height, quality: 90).Apply(pixels);

        for (int at = 0; at < pixels.Length; at++)
            Assert.InRange(pixels[at] - (at % 3 == 0 ? 90 : at % 3 == 1 ? 120 : 60), -3, 3);
    }

    // Written down once; the same on each runtime.
    [Fact]
    public void Render_AllEffects_GivesTheBytesThatItAlwaysGave()
    {
        byte[] picture = Shoot(SimulatedPictureEffects.CreateHarsh(), movesNorth: 0.1);
        ulong hash = picture.Aggregate(14_695_981_039_346_656_037UL, (h, b) => (h ^ b) * 1_099_511_628_211UL);

        Assert.Equal(12_600_917_134_056_149_544UL, hash);
    }

    [Fact]
    public void Render_AllEffects_AllocatesNothing()
    {
        SimulatedCameraOptions camera = Options(SimulatedPictureEffects.CreateHarsh());
        var renderer = new PictureRenderer(camera, Things, seed: 2);
        byte[] pixels = new byte[320 * 240 * 3];
        (CameraPose a, CameraPose b) =
            (new CameraPose(Scene.Pose(20), camera), new CameraPose(Scene.Pose(20, roll: 1), camera));
        void Work() => renderer.Render(a, a, b, 5, pixels);
        Work();

        Assert.Equal(0, Allocated.By(Work));
    }

    [Fact]
    public void Render_AnyPose_Ends()
    {
        SimulatedCameraOptions camera = Options(SimulatedPictureEffects.CreateHarsh());
        camera.Camera = new() { Width = 33, Height = 25, FocalX = 20, FocalY = 20, CentreX = 16, CentreY = 12 };
        var renderer = new PictureRenderer(camera, Things, seed: 2);
        byte[] pixels = new byte[33 * 25 * 3];
        var random = new Random(4);
        for (int run = 0; run < 300; run++)
        {
            CameraPose[] poses =
            [
                .. Enumerable.Range(0, 3).Select(_ => new CameraPose(
                    Scene.Pose(
                        Math.Pow(10, (6 * random.NextDouble()) - 2), 360 * random.NextDouble(),
                        180 * random.NextDouble(), 360 * random.NextDouble(), 360 * random.NextDouble()),
                    camera)),
            ];
            renderer.Render(poses[0], poses[1], poses[2], run, pixels);
        }
    }

    [Fact]
    public void Options_OutOfRange_AreAllNamed()
    {
        var camera = new SimulatedCameraOptions
        {
            Effects = new SimulatedPictureEffects
            {
                Vignetting = -1,
                Shade = double.NaN,
                RedGain = 9,
                BlueGain = 0,
                ExposureGain = 5,
                JpegQuality = 0,
            },
        };

        string text = Assert.Throws<ArgumentException>(
            () => new SimulatedCamera(camera, new TruthHistory(2), [], seed: 1)).Message;

        Assert.All(
            ["Effects.Vignetting is -1", "Shade is NaN", "RedGain is 9", "BlueGain is 0", "ExposureGain is 5",
                "JpegQuality is 0"],
            part => Assert.Contains(part, text, StringComparison.Ordinal));
    }

    private static SimulatedCameraOptions Options(SimulatedPictureEffects? effects)
    {
        SimulatedCameraOptions camera = Scene.Pinhole();
        camera.Effects = effects ?? camera.Effects;
        return camera;
    }

    private static byte[] Shoot(
        SimulatedPictureEffects? effects, double movesNorth = 0, SimulatedTarget[]? things = null)
    {
        (TruePose middle, TruePose early, TruePose late) = (Scene.Pose(20), Scene.Pose(20), Scene.Pose(20));
        early.Position = new NedPosition(-movesNorth / 2, 0, -20);
        late.Position = new NedPosition(movesNorth / 2, 0, -20);
        return Render(Options(effects), middle, early, late, things ?? Things);
    }

    private static byte[] Render(
        SimulatedCameraOptions camera, TruePose middle, TruePose early, TruePose late, SimulatedTarget[] things)
    {
        byte[] pixels = new byte[320 * 240 * 3];
        new PictureRenderer(camera, things, seed: 2).Render(
            new CameraPose(middle, camera), new CameraPose(early, camera), new CameraPose(late, camera), 1, pixels);
        return pixels;
    }

    // A picture of an even ground, grey 200.
    private static byte[] Shaded(
        CloudShade shade, SimulatedCameraOptions camera, double north, double east, double height)
    {
        byte[] pixels = new byte[320 * 240 * 3];
        pixels.AsSpan().Fill(200);
        TruePose pose = Scene.Pose(height);
        pose.Position = new NedPosition(north, east, -height);
        shade.Apply(new CameraPose(pose, camera), pixels);
        return [.. Enumerable.Range(0, 320 * 240).Select(i => pixels[3 * i])];
    }

    private static double MeanIn(byte[] pixels, int left, int top, int side)
        => Enumerable.Range(0, side * side)
            .Average(i => pixels[((((top + (i / side)) * 320) + left + (i % side)) * 3) + 1]);

    private static double Rms(byte[] a, byte[] b)
        => Math.Sqrt(Enumerable.Range(0, a.Length).Average(i => Math.Pow(a[i] - b[i], 2)));

    // Where the picture with the panel differs from the one without it.
    private static int RowsOf(byte[] with, byte[] without)
        => Enumerable.Range(0, 240).Count(v => Enumerable.Range(0, 320).Any(u => Differs(with, without, u, v)));

    private static int ColumnsOf(byte[] with, byte[] without)
        => Enumerable.Range(0, 320).Count(u => Enumerable.Range(0, 240).Any(v => Differs(with, without, u, v)));

    private static bool Differs(byte[] with, byte[] without, int u, int v)
    {
        int at = ((v * 320) + u) * 3;
        return Enumerable.Range(at, 3).Any(i => Math.Abs(with[i] - without[i]) > 8);
    }
}
