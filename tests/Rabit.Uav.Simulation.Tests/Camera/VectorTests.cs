#if NET
using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Camera;

/// <summary>
/// Where the processor has AVX2, several pixels are made at a time: the bytes must be those of one at a time, which
/// Mono and other processors make.
/// </summary>
public class VectorTests(ITestOutputHelper output)
{
    private static readonly GroundTexture Texture = new(seed: 3);

    // Sizes that leave a rest, of rows and of the picture.
    [Theory]
    [InlineData(320, 240)]
    [InlineData(321, 7)]
    [InlineData(5, 3)]
    [InlineData(1, 1)]
    public void Paint_ByVectors_GivesTheSameBytes(int width, int height)
    {
        Random random = NewRandom();
        SimulatedCameraOptions options = Camera(width, height);
        var lens = new LensRays(options.Camera);
        var painter = new GroundPainter(lens, Texture);
        byte[] byVectors = new byte[(width * height * 3) + 8];
        byte[] oneByOne = new byte[byVectors.Length];
        for (int i = 0; i < 20; i++)
        {
            CameraPose pose = RandomPose(random, options);
            painter.UsesVectors = new GroundPainter(lens, Texture).UsesVectors;
            painter.Paint(pose, byVectors);
            painter.UsesVectors = false;
            painter.Paint(pose, oneByOne);
            Assert.Equal(oneByOne, byVectors);
        }
    }

    [Theory]
    [InlineData(320, 240, 2.0)]
    [InlineData(321, 7, 2.0)]
    [InlineData(5, 3, 2.0)]
    [InlineData(64, 64, 25.0)]
    public void Apply_ByVectors_GivesTheSameBytes(int width, int height, double noiseSigma)
    {
        Random random = NewRandom();
        var finish = new SensorFinish(width, height, noiseSigma, seed: 5);
        byte[] byVectors = new byte[width * height * 3];
        random.NextBytes(byVectors);
        byte[] oneByOne = (byte[])byVectors.Clone();
        for (int number = 0; number < 5; number++)
        {
            finish.UsesVectors = new SensorFinish(width, height, noiseSigma, seed: 5).UsesVectors;
            finish.Apply(byVectors, number);
            finish.UsesVectors = false;
            finish.Apply(oneByOne, number);
            Assert.Equal(oneByOne, byVectors);
        }
    }

    private static SimulatedCameraOptions Camera(int width, int height) => new()
    {
        Camera = new CameraModel
        {
            Width = width,
            Height = height,
            FocalX = 0.8 * width,
            FocalY = 0.8 * width,
            CentreX = width / 2.0,
            CentreY = height / 2.0,
            K1 = -0.05,
        },
    };

    // On the ground and far above it, straight down and above the horizon.
    private static CameraPose RandomPose(Random random, SimulatedCameraOptions options)
        => new(
            new TruePose
            {
                Position = new NedPosition(
                    4000 * (random.NextDouble() - 0.5), 4000 * (random.NextDouble() - 0.5),
                    -Math.Pow(10, (3.5 * random.NextDouble()) - 1)),
                Attitude = EulerAngles.FromDegrees(
                    60 * (random.NextDouble() - 0.5), 60 * (random.NextDouble() - 0.5), 360 * random.NextDouble()),
                CameraPitch = Angle.FromDegrees(-90 + (100 * random.NextDouble())),
            },
            options);

    private Random NewRandom()
    {
        int seed = new Random().Next();
        output.WriteLine($"seed {seed}");
        return new Random(seed);
    }
}
#endif
