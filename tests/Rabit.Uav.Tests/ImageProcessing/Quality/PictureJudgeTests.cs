using System;
using Rabit.Geodesy;
using Rabit.Tests.Shared;
using Rabit.Uav.ImageProcessing.Quality;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing.Quality;

/// <summary>Each quality by a picture that has it, and by one that nearly has.</summary>
public class PictureJudgeTests
{
    private const int Width = 320;
    private const int Height = 240;

    private readonly PictureJudge _judge = new();
    private readonly GaussianNoise _noise = new(new Random(7));
    private double _north;

    [Theory]
    [InlineData(4, PictureQuality.Black)]
    [InlineData(60, PictureQuality.Uniform)]
    [InlineData(255, PictureQuality.White)]
    public void Judge_OneLevelAndNoise_IsNamedByItsLevel(int level, PictureQuality expected)
    {
        var picture = new double[Width * Height];
        for (int i = 0; i < picture.Length; i++)
            picture[i] = level == 255 ? 400 : level;
        Assert.Equal(expected, Judge(picture));
    }

    [Theory]
    [InlineData(0.2, PictureQuality.Usable)]
    [InlineData(0.5, PictureQuality.Saturated)]
    public void Judge_PartOverexposed_IsSaturated(double part, PictureQuality expected)
    {
        double[] picture = Ground();

        // A slanted edge: one along the rows would lie between those of the grid.
        for (int i = 0; i < picture.Length; i++)
            picture[i] += (i / Width) + (0.3 * ((i % Width) - (Width / 2))) < part * Height ? 400 : 0;
        Assert.Equal(expected, Judge(picture));
    }

    [Theory]
    [InlineData(0.15, PictureQuality.Usable)]
    [InlineData(0.5, PictureQuality.Covered)]
    public void Judge_PartCovered_IsCovered(double part, PictureQuality expected)
    {
        double[] picture = Ground();
        for (int i = 0; i < picture.Length; i++)
            picture[i] = i % Width < part * Width ? 30 : picture[i];
        Assert.Equal(expected, Judge(picture));
    }

    [Theory]
    [InlineData(0, PictureQuality.Usable)]
    [InlineData(3, PictureQuality.Defocused)]
    public void Judge_BlurredInAllDirections_IsDefocusedByWhatTheFlightHad(int reach, PictureQuality expected)
    {
        Learn();
        double[] picture = Ground();
        for (int pass = 0; pass < 2 && reach > 0; pass++)
            picture = Blur(Blur(picture, reach, 1), reach, Width);
        Assert.Equal(expected, Judge(picture));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(Width)]
    [InlineData(Width + 1)]
    public void Judge_BlurredInOneDirection_IsMotionBlurred(int direction)
    {
        Learn();
        Assert.Equal(PictureQuality.MotionBlurred, Judge(Blur(Ground(), 8, direction)));
    }

    [Fact]
    public void Judge_SamePictureAgain_IsFrozenOnlyWhereTheCameraHasMovedAndUntilItDiffers()
    {
        double[] ground = Ground();
        Assert.Equal(PictureQuality.Usable, Judge(ground));
        Assert.Equal(PictureQuality.Usable, Judge(ground, metresOn: 0.5));
        Assert.Equal(PictureQuality.Frozen, Judge(ground, metresOn: 3));
        Assert.Equal(PictureQuality.Frozen, Judge(ground, metresOn: 0));
        Assert.Equal(PictureQuality.Usable, Judge(Ground(), metresOn: 0));
        Assert.Equal(PictureQuality.Usable, Judge(Ground(), metresOn: 3));
    }

    // Its position sways by 0.7 m to each side: 35 pixels of 2 cm.
    [Fact]
    public void Judge_SamePictureOfAStabilisedCameraThatHovers_IsUsableUntilItFliesOn()
    {
        double[] ground = Ground();
        Assert.Equal(PictureQuality.Usable, Judge(ground, sampling: 0.02));
        for (int i = 0; i < 10; i++)
            Assert.Equal(
                PictureQuality.Usable, Judge(ground, metresOn: i == 0 ? 0.7 : i % 2 == 0 ? 1.4 : -1.4, sampling: 0.02));
        Assert.Equal(PictureQuality.Frozen, Judge(ground, metresOn: 3, sampling: 0.02));
    }

    // An attitude that is wrong by 1.5 degrees in a turn: the place has moved by 20 pixels, the picture by one or two.
    [Fact]
    public void Judge_PictureThatMovedLessThanItsPose_IsUsable()
    {
        double[] ground = Ground();
        double[] moved = (double[])ground.Clone();
        Array.Copy(ground, 2, moved, 0, ground.Length - 2);
        Assert.Equal(PictureQuality.Usable, Judge(ground));
        Assert.Equal(PictureQuality.Usable, Judge(moved, metresOn: 2));
    }

    [Theory]
    [InlineData(0.1, 0.01, PictureQuality.Usable)]
    [InlineData(0.16, 0.01, PictureQuality.TooCoarse)]
    [InlineData(0.149, 0.1, PictureQuality.Usable)]
    [InlineData(0.1, 0.16, PictureQuality.MotionBlurred)]
    [InlineData(0.077, 0.2, PictureQuality.Usable)]
    [InlineData(0.077, 0.25, PictureQuality.MotionBlurred)]
    public void Judge_PixelsOrSmearTooLarge_IsNotUsable(double sampling, double smear, PictureQuality expected)
    {
        var view = new PictureView
        {
            Centre = GeodeticPosition.FromRadians(0.8, 0.1, 500),
            GroundSamplingMetres = sampling,
            SmearMetres = smear,
            NeededSamplingMetres = 0.15,
        };
        Assert.Equal(expected, _judge.Judge(Pixels(Ground()), Width, Height, view));
    }

    [Fact]
    public void Judge_AnyPicture_AllocatesNothing()
    {
        byte[] pixels = Pixels(Ground());
        var view = new PictureView { GroundSamplingMetres = 0.1, NeededSamplingMetres = 1 };
        _judge.Judge(pixels, Width, Height, view);
        Assert.Equal(0, Allocated.By(() => _judge.Judge(pixels, Width, Height, view)));
    }

    private void Learn()
    {
        for (int i = 0; i < 10; i++)
            Assert.Equal(PictureQuality.Usable, Judge(Ground()));
    }

    private PictureQuality Judge(double[] picture, double metresOn = 3, double sampling = 0.1)
    {
        _north += metresOn;
        var view = new PictureView
        {
            Centre = GeodeticPosition.FromRadians(0.8 + (_north / 6_378_000), 0.1, 500),
            GroundSamplingMetres = sampling,
            NeededSamplingMetres = 0.15,
        };
        return _judge.Judge(Pixels(picture), Width, Height, view);
    }

    // Detail at all sizes, as ground has it: noise that was blurred by more and more, the coarser the stronger.
    private double[] Ground()
    {
        var picture = new double[Width * Height];
        foreach (int reach in new[] { 0, 1, 2, 4, 8 })
        {
            double[] octave = new double[picture.Length];
            for (int i = 0; i < octave.Length; i++)
                octave[i] = _noise.Next() * 5 * ((2 * reach) + 1) / (reach == 0 ? 1.5 : 1);
            octave = Blur(Blur(octave, reach, 1), reach, Width);
            for (int i = 0; i < octave.Length; i++)
                picture[i] += octave[i];
        }

        for (int i = 0; i < picture.Length; i++)
            picture[i] += 100;
        return picture;
    }

    private static double[] Blur(double[] picture, int reach, int direction)
    {
        var blurred = new double[picture.Length];
        for (int k = -reach; k <= reach; k++)
        {
            int from = ((k * direction) + picture.Length) % picture.Length;
            for (int i = 0; i < picture.Length; i++)
            {
                blurred[i] += picture[from];
                from = from + 1 == picture.Length ? 0 : from + 1;
            }
        }

        for (int i = 0; i < blurred.Length; i++)
            blurred[i] /= (2 * reach) + 1;
        return blurred;
    }

    // The noise of the sensor comes last.
    private byte[] Pixels(double[] picture)
    {
        var pixels = new byte[picture.Length * 3];
        for (int i = 0; i < pixels.Length; i++)
        {
            double level = picture[i / 3] + (2.5 * _noise.Next());
            pixels[i] = (byte)Math.Max(0, Math.Min(255, Math.Round(level)));
        }

        return pixels;
    }
}
