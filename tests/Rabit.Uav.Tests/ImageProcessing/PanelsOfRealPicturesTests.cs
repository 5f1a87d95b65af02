using System;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Uav.ImageProcessing;
using Rabit.Vision;
using Rabit.Vision.Tests;
using VisionBench;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>
/// Panels of 0.4 m, black and white, in photos of drones, where they are; and photos and crops of bare ground without
/// any.
/// </summary>
[Trait("Category", "Long")]
public sealed class PanelsOfRealPicturesTests(ITestOutputHelper output)
{
    private readonly PanelTargetDetector _detector = new(BenchClasses.BlackAndWhitePanels);
    private readonly TargetDetection[] _found = new TargetDetection[64];

    // The scale is known from the panels' own size, and may be wrong.
    [RealPicturesTheory("aerial")]
    [InlineData(0.85)]
    [InlineData(1)]
    [InlineData(1.15)]
    public void Detect_Photos_FindsAllPanelsAndNothingElse(double scaleError)
    {
        (int found, int of, int wrong) = (0, 0, 0);
        foreach (JsonElement file in FilesOf("aerial").Where(f => f.TryGetProperty("panels_original_px", out _)))
        {
            string name = file.GetProperty("file").GetString()!;
            if (name.StartsWith("orig", StringComparison.Ordinal))
                continue;
            double scale = file.GetProperty("scale").GetDouble();
            (double X, double Y, double Side)[] panels = file.GetProperty("panels_original_px").EnumerateArray()
                .Select(p => (PlaceOf(p, 0, scale), PlaceOf(p, 1, scale), SideOf(p) * scale)).ToArray();
            double side = panels.Average(p => p.Side);
            int count = Find(Load("aerial", name), PhotoManifest.PanelSideMetres / side * scaleError);
            wrong += count;
            foreach ((double x, double y, _) in panels)
            {
                of++;
                int near = _found.Take(count)
                    .Count(f => Math.Max(Math.Abs(f.CentreX - x), Math.Abs(f.CentreY - y)) < side / 4);
                found += Math.Min(near, 1);
                wrong -= Math.Min(near, 1);
            }
        }

        output.WriteLine($"{found} of {of}, {wrong} false");
        Assert.Equal(15, of);
        Assert.True(found >= 14 && wrong <= 1, $"{found} of {of}, {wrong} false");
    }

    [RealPicturesFact("aerial")]
    public void Detect_PhotosWithoutPanels_FindsFewerThanOneInTen()
    {
        string[] names = FilesOf("aerial").Select(f => f.GetProperty("file").GetString()!)
            .Where(n => n.StartsWith("small", StringComparison.Ordinal)
                && PlaceNameOf(n, 0) is "brighton" or "caliterra" or "seneca").ToArray();
        int wrong = names.Sum(n => Find(Load("aerial", n), 4 * PhotoManifest.MetresPerPixelOf[PlaceNameOf(n, 0)]));
        output.WriteLine($"{wrong} false in {names.Length} photos");
        Assert.True(wrong <= 0.1 * names.Length, $"{wrong} false in {names.Length} photos");
    }

    [RealPicturesFact("background")]
    public void Detect_CropsOfBareGround_FindsNone()
    {
        string[] names = FilesOf("background").Select(f => f.GetProperty("file").GetString()!).ToArray();
        int wrong = names.Sum(n => new[] { PhotoManifest.MetresPerPixelOf[PlaceNameOf(n, 1)], 0.05, 0.1, 0.15 }
            .Sum(m => Find(Load("background", n), m)));
        output.WriteLine($"{wrong} false in {names.Length} crops");
        Assert.Equal(0, wrong);
    }

    private static string PlaceNameOf(string file, int part) => Path.GetFileName(file).Split('_')[part];

    private static double PlaceOf(JsonElement panel, int axis, double scale)
        => ((panel.GetProperty("centre")[axis].GetDouble() + 0.5) * scale) - 0.5;

    private static double SideOf(JsonElement panel)
        => (panel.GetProperty("size")[0].GetDouble() + panel.GetProperty("size")[1].GetDouble()) / 2;

    private static JsonElement[] FilesOf(string folder)
    {
        using var json = JsonDocument.Parse(
            File.ReadAllText(Path.Combine(RealPicturesFactAttribute.FolderOf(folder)!, "manifest.json")));
        return json.RootElement.GetProperty("files").EnumerateArray().Select(f => f.Clone()).ToArray();
    }

    private static RgbPicture Load(string folder, string file)
        => PictureFile.Load(Path.Combine(RealPicturesFactAttribute.FolderOf(folder)!, file));

    private int Find(RgbPicture picture, double metresPerPixel)
    {
        var input = new DetectorInput(
            picture.Pixels, picture.Width, picture.Height, BenchClasses.BlackAndWhitePanels,
            PictureGroundScale.Uniform(metresPerPixel));
        DetectorResult result = _detector.Detect(input, _found);
        Assert.Null(result.Refusal);
        return result.Count;
    }
}
