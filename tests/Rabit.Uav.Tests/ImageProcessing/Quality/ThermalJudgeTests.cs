using System;
using System.Linq;
using System.Runtime.InteropServices;
using Rabit.Geodesy;
using Rabit.Tests.Shared;
using Rabit.Uav.ImageProcessing.Quality;
using Rabit.Uav.Messages;
using Rabit.Vision.Tests.Thermal;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing.Quality;

/// <summary>Thermal pictures of a camera that works, and of one that does not.</summary>
public class ThermalJudgeTests
{
    private readonly ThermalJudge _judge = new();
    private double _north;

    [Fact]
    public void Judge_NewGroundInEachPicture_IsUsable()
    {
        for (int seed = 1; seed <= 20; seed++)
            Assert.Equal(PictureQuality.Usable, Judge(Ground(seed)));
    }

    [Fact]
    public void Judge_SameGroundWithNewNoise_IsANewPicture()
    {
        for (int seed = 1; seed <= 20; seed++)
            Assert.Equal(PictureQuality.Usable, Judge(Ground(seed)));
        Assert.Equal(PictureQuality.Usable, Judge(Ground(20, offset: 40)));
    }

    [Fact]
    public void Judge_SamePictureAgain_IsFrozenOnlyWhereTheCameraHasMovedAndUntilItDiffers()
    {
        ushort[] ground = Ground(1);
        Assert.Equal(PictureQuality.Usable, Judge(ground));
        Assert.Equal(PictureQuality.Usable, Judge(ground, metresOn: 0.5));
        Assert.Equal(PictureQuality.Frozen, Judge(ground));
        Assert.Equal(PictureQuality.Frozen, Judge(ground, metresOn: 0));
        Assert.Equal(PictureQuality.Usable, Judge(Ground(2), metresOn: 0));
        Assert.Equal(PictureQuality.Usable, Judge(Ground(3)));
    }

    [Fact]
    public void Judge_RepeatedWithTheNoiseOfACompression_IsFrozen()
    {
        ushort[] ground = Ground(1);
        var random = new Random(1);
        Assert.Equal(PictureQuality.Usable, Judge(ground));
        Assert.Equal(PictureQuality.Frozen, Judge([.. ground.Select(c => (ushort)(c + random.Next(-3, 4)))]));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(7300)]
    [InlineData(65535)]
    public void Judge_OneValue_IsUniform(int count)
        => Assert.Equal(
            PictureQuality.Uniform,
            Judge([.. Enumerable.Repeat((ushort)count, ThermalScene.Width * ThermalScene.Height)]));

    [Theory]
    [InlineData(1)]
    [InlineData(8)]
    [InlineData(200)]
    public void Judge_NothingButNoise_IsUniform(double sigma)
    {
        var random = new Random(5);
        for (int i = 0; i < 10; i++)
            Assert.Equal(PictureQuality.Uniform, Judge(Noise(random, sigma)));
    }

    [Theory]
    [InlineData(0.1, 0.01, PictureQuality.Usable)]
    [InlineData(0.16, 0.01, PictureQuality.TooCoarse)]
    [InlineData(0.1, 0.16, PictureQuality.MotionBlurred)]
    public void Judge_PixelsOrSmearTooLarge_IsNotUsable(double sampling, double smear, PictureQuality expected)
    {
        var view = new PictureView
        {
            GroundSamplingMetres = sampling,
            SmearMetres = smear,
            NeededSamplingMetres = 0.15,
        };
        Assert.Equal(expected, _judge.Judge(Ground(1), ThermalScene.Width, ThermalScene.Height, view));
    }

    [Theory]
    [InlineData(1, 1)]
    [InlineData(2, 9)]
    [InlineData(3, 3)]
    public void Judge_TinyPicture_IsUniform(int width, int height)
        => Assert.Equal(PictureQuality.Uniform, _judge.Judge(new ushort[width * height], width, height, default));

    [Fact]
    public void Judge_AnyPicture_AllocatesNothing()
    {
        ushort[] ground = Ground(1);
        void Work() => Judge(ground);
        Work();
        Assert.Equal(0, Allocated.By(Work));
    }

    private static ushort[] Ground(int seed, double offset = 0)
        => MemoryMarshal.Cast<byte, ushort>(new ThermalScene(seed).Finish(offset: offset)).ToArray();

    private static ushort[] Noise(Random random, double sigma)
    {
        var counts = new ushort[ThermalScene.Width * ThermalScene.Height];
        for (int i = 0; i < counts.Length; i++)
            counts[i] = (ushort)(7300.5 + (sigma * Enumerable.Range(0, 12).Sum(_ => random.NextDouble() - 0.5)));
        return counts;
    }

    private PictureQuality Judge(ushort[] counts, double metresOn = 3)
    {
        _north += metresOn;
        var view = new PictureView
        {
            Centre = GeodeticPosition.FromRadians(0.8 + (_north / 6_378_000), 0.1, 500),
            GroundSamplingMetres = ThermalScene.MetresPerPixel,
            NeededSamplingMetres = 0.15,
        };
        return _judge.Judge(counts, ThermalScene.Width, ThermalScene.Height, view);
    }
}
