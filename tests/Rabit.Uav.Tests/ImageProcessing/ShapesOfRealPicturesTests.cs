using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.IO;
using System.Linq;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Vision;
using Rabit.Vision.Tests;
using VisionBench;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>
/// The detector of shapes on photos of drones and crops of them that show none of its targets: at their own scale, and
/// the crops also as if a pixel were 5, 10 and 15 cm.
/// </summary>
[Trait("Category", "Long")]
public sealed class ShapesOfRealPicturesTests(ITestOutputHelper output)
{
    private static readonly Dictionary<string, double> MetresPerPixelOf = new(StringComparer.Ordinal)
    {
        ["brighton"] = 0.018,
        ["caliterra"] = 0.016,
        ["seneca"] = 0.022,
        ["copr"] = 0.0033,
    };

    private readonly TargetDetection[] _found = new TargetDetection[64];

    [RealPicturesFact("background")]
    public void Detect_DefaultClasses_FindsNone()
    {
        (int crops, int photos) = CountAll(TargetClass.Defaults);
        Assert.Equal((0, 0), (crops, photos));
    }

    // The limit of white panels and white cars, which light roofs and stones are like, is what was measured.
    [RealPicturesFact("background")]
    public void Detect_WhitePanelsCarsAndPersonsToo_FindsFew()
    {
        (int crops, int photos) = CountAll(BenchClasses.All);
        output.WriteLine($"{crops} in the crops, {photos} in the photos");
        Assert.InRange(crops, 0, 4);
        Assert.InRange(photos, 0, 3);
    }

    private static string PlaceOf(string file, int part) => Path.GetFileName(file).Split('_')[part];

    private (int Crops, int Photos) CountAll(ImmutableArray<TargetClass> classes)
    {
        var detector = new ShapeTargetDetector(classes);
        string[] crops = Directory.GetFiles(RealPicturesFactAttribute.FolderOf("background")!, "bg_*");
        string[] photos = [.. Directory.GetFiles(
                Path.Combine(RealPicturesFactAttribute.FolderOf("aerial")!, "small"), "*_s.jpg")
            .Where(f => PlaceOf(f, 0) is "brighton" or "caliterra" or "seneca")];
        Assert.Equal((30, 22), (crops.Length, photos.Length));
        return (
            crops.Sum(f => new[] { MetresPerPixelOf[PlaceOf(f, 1)], 0.05, 0.1, 0.15 }
                .Sum(m => Count(detector, classes, f, m))),
            photos.Sum(f => Count(detector, classes, f, 4 * MetresPerPixelOf[PlaceOf(f, 0)])));
    }

    private int Count(
        ShapeTargetDetector detector, ImmutableArray<TargetClass> classes, string file, double metresPerPixel)
    {
        RgbPicture picture = PictureFile.Load(file);
        DetectorResult result = detector.Detect(
            new DetectorInput(
                picture.Pixels, picture.Width, picture.Height, classes, PictureGroundScale.Uniform(metresPerPixel)),
            _found);
        Assert.Null(result.Refusal);
        foreach (TargetDetection one in _found.Take(result.Count))
        {
            output.WriteLine(FormattableString.Invariant(
                $"{Path.GetFileName(file)} at {metresPerPixel} m: {one.Class}, {one.SideMetres:0.00} m"));
        }

        return result.Count;
    }
}
