using System;
using System.Globalization;
using System.IO;
using System.Linq;
using Rabit.Vision;
using Rabit.Vision.Tests;
using VisionBench;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>
/// Photos with a manifest in the program that scores detectors: panels on the ground, and bare ground.
/// </summary>
public sealed class VisionBenchPhotoTests : IDisposable
{
    private const int Width = 240;
    private const int Height = 160;

    // A panel of 40 pixels, as the picture was before it was made half as large.
    private const string Panel = """
        "scale": 0.5, "panels_original_px": [ { "centre": [ 200.5, 140.5 ], "size": [ 80, 80 ],
          "quad": [ [ 160.5, 100.5 ], [ 240.5, 100.5 ], [ 240.5, 180.5 ], [ 160.5, 180.5 ] ] } ]
        """;

    private readonly string _folder =
        Directory.CreateDirectory(Path.Combine(Path.GetTempPath(), $"bench-{Guid.NewGuid():N}")).FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void Run_PhotosWithAManifest_CountsPanelsMissesAndWhatHasNoScale()
    {
        Draw("with.png", hasPanel: true);
        Draw("without.png", hasPanel: false);
        WriteManifest(
            FileOf("with.png", Panel), FileOf("without.png", Panel), FileOf("with.png", "\"metres_per_pixel\": 0.01"),
            FileOf("without.png", "\"metres_per_pixel\": 0.01"), FileOf("without.png", "\"scale\": 0.5"));

        string output = Run(0, "--list");

        Assert.Contains(", 4 frames", output, StringComparison.Ordinal);
        AssertRow(output, "panels found", "1/2");
        AssertRow(output, "false alarms per frame", "0.25");   // the panel of which the manifest does not say
        Assert.Contains("without missed panel-two-tone", output, StringComparison.Ordinal);
        Assert.Contains("with false panel-two-tone", output, StringComparison.Ordinal);
        Assert.Contains("; 1 pictures without a scale were not searched", output, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("{", " is no manifest of photos: ")]
    [InlineData("{ \"pictures\": [] }", " is no manifest of photos: ")]
    [InlineData("{ \"files\": [] }", "of no picture it is known what a pixel is on the ground")]
    [InlineData("{ \"files\": [ { \"file\": \"a.png\", \"metres_per_pixel\": -1 } ] }", "a.png: a pixel of -1 m")]
    [InlineData("{ \"files\": [ { \"file\": \"a.png\", \"metres_per_pixel\": 0.1 } ] }", " is no manifest of photos: ")]
    public void Run_ManifestWithAFault_IsNamed(string manifest, string fault)
    {
        File.WriteAllText(Path.Combine(_folder, "manifest.json"), manifest);

        string errors = Run(2);

        Assert.StartsWith(Path.Combine(_folder, "manifest.json"), errors, StringComparison.Ordinal);
        Assert.Contains(fault, errors, StringComparison.Ordinal);
    }

    [RealPicturesFact("aerial"), Trait("Category", "Long")]
    public void Run_RealPhotos_FindsThePanels()
    {
        string output = RunOn(RealPicturesFactAttribute.FolderOf("aerial")!, 0);

        Assert.Contains("aerial, 31 frames", output, StringComparison.Ordinal);
        string found = Row(output, "panels found");
        Assert.True(found is "15/15" or "14/15", found);
        Assert.Contains("; 14 pictures without a scale were not searched", output, StringComparison.Ordinal);
    }

    [RealPicturesFact("background"), Trait("Category", "Long")]
    public void Run_RealCropsOfBareGround_FindsNothing()
        => AssertRow(RunOn(RealPicturesFactAttribute.FolderOf("background")!, 0), "false alarms per frame", "0.00");

    private static void AssertRow(string output, string name, string value) => Assert.Equal(value, Row(output, name));

    private static string Row(string output, string name) => output.Split('\n')
        .Single(l => l.StartsWith("  " + name + " ", StringComparison.Ordinal)).Substring(name.Length + 2).Trim();

    private static string FileOf(string name, string more) => FormattableString.Invariant(
        $$"""{ "file": "{{name}}", "width": {{Width}}, "height": {{Height}}, {{more}} }""");

    private static string RunOn(string folder, int exit, params string[] args)
    {
        using var output = new StringWriter(CultureInfo.InvariantCulture);
        using var errors = new StringWriter(CultureInfo.InvariantCulture);
        Assert.Equal(exit, VisionBenchProgram.Run([folder, .. args], output, errors, isTerminal: false));
        return exit == 0 ? output.ToString() : errors.ToString();
    }

    private string Run(int exit, params string[] args) => RunOn(_folder, exit, args);

    private void WriteManifest(params string[] files) => File.WriteAllText(
        Path.Combine(_folder, "manifest.json"), "{ \"files\": [ " + string.Join(", ", files) + " ] }");

    // A black square with a white middle, on sand.
    private void Draw(string name, bool hasPanel)
    {
        var picture = new RgbPicture(Width, Height, new byte[3 * Width * Height]);
        for (int row = 0; row < Height; row++)
        {
            for (int column = 0; column < Width; column++)
            {
                int from = Math.Max(Math.Abs(column - 100), Math.Abs(row - 70));
                byte[] colour = !hasPanel || from > 20 ? [150, 140, 120] : from > 10 ? [20, 20, 20] : [240, 240, 240];
                colour.CopyTo(picture.Pixels, ((row * Width) + column) * 3);
            }
        }

        File.WriteAllBytes(Path.Combine(_folder, name), PngPicture.Encode(picture));
    }
}
