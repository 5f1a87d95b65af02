using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Geodesy.Tests;
using Rabit.Uav.ImageProcessing.Quality;
using Rabit.Uav.Messages;
using StbImageSharp;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing.Quality;

/// <summary>
/// Pictures of ground, dark and bright, from 41 to 144 m: none of them is taken for a fault of the camera, and the
/// limits of <see cref="PictureJudge"/> keep their margins.
/// </summary>
public class PictureSetTests
{
    // What the limits are set by: the least and the most in each set, rounded outwards.
    public static readonly TheoryData<string, int, int, double, double, double, double> Figures = new()
    {
        // set, least bright level, most dark level, most clipped, least coarse detail, least sharpness, most flat
        { "stills_640", 100, 113, 0.006, 16.5, 0.122, 0.021 },
        { "stills_1640", 110, 109, 0.001, 29, 0.084, 0.042 },
        { "sequence_01", 92, 78, 0.001, 31, 0.115, 0.042 },
    };

    [Theory]
    [MemberData(nameof(Figures))]
    public void Figures_OfASet_AreFarFromTheLimits(
        string set, int bright, int dark, double clipped, double coarse, double sharpness, double flat)
    {
        Assert.NotEmpty(set);
        Assert.InRange(bright, 2 * PictureJudge.MaxBlackLevel, 255);
        Assert.InRange(dark, 0, PictureJudge.MinWhiteLevel / 2);
        Assert.InRange(clipped, 0, PictureJudge.MaxClippedShare / 10);
        Assert.InRange(coarse, 8 * PictureJudge.MinCoarseDetail, double.PositiveInfinity);
        Assert.InRange(sharpness, 1.4 * PictureJudge.MinSharpness, double.PositiveInfinity);
        Assert.InRange(flat, 0, PictureJudge.MaxFlatShare / 4);
    }

    [PictureSetTheory]
    [MemberData(nameof(Figures))]
    public void Measure_ASet_GivesTheFiguresHere(
        string set, int bright, int dark, double clipped, double coarse, double sharpness, double flat)
    {
        var meter = new PictureMeter();
        PictureStatistics[] measured = PicturesOf(set).Select(p => meter.Measure(p.Data, p.Width, p.Height)).ToArray();
        Assert.InRange(measured.Min(m => m.BrightLevel), bright, 255);
        Assert.InRange(measured.Max(m => m.DarkLevel), 0, dark);
        Assert.InRange(measured.Max(m => m.ClippedShare), 0, clipped);
        Assert.InRange(measured.Min(m => m.CoarseDetail), coarse, double.PositiveInfinity);
        Assert.InRange(measured.Min(m => m.FineDetail / m.CoarseDetail), sharpness, double.PositiveInfinity);
        Assert.InRange(measured.Max(m => m.FlatShare), 0, flat);
    }

    [PictureSetTheory]
    [InlineData("stills_640")]
    [InlineData("stills_1640")]
    [InlineData("sequence_01")]
    public void Judge_ASet_AllAreUsable(string set)
    {
        var judge = new PictureJudge();
        int number = 0;
        var unusable = new List<string>();
        foreach (ImageResult picture in PicturesOf(set))
        {
            // 18 m/s at 5 Hz and 0.2 m for a pixel; each still is of a place of its own.
            var view = new PictureView
            {
                Centre = GeodeticPosition.FromRadians(0.8 + (number * 3.6 / 6_378_000), 0.1, 500),
                GroundSamplingMetres = 0.2,
                NeededSamplingMetres = double.PositiveInfinity,
            };
            PictureQuality quality = judge.Judge(picture.Data, picture.Width, picture.Height, view);
            if (quality != PictureQuality.Usable)
                unusable.Add($"{number}: {quality}");
            number++;
        }

        Assert.NotEqual(0, number);
        Assert.Empty(unusable);
    }

    private static IEnumerable<ImageResult> PicturesOf(string set)
    {
        string folder = Vectors.FolderOf(Path.Combine("imagery", set))!;
        string frames = Path.Combine(folder, "frames");
        return Directory.GetFiles(Directory.Exists(frames) ? frames : folder, "*.jpg")
            .OrderBy(f => f, StringComparer.Ordinal)
            .Select(f => ImageResult.FromMemory(File.ReadAllBytes(f), ColorComponents.RedGreenBlue));
    }
}
