using System;
using System.Collections.Immutable;
using System.IO;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Vision;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>The detector of templates beside what its contract says.</summary>
public sealed class TemplateTargetDetectorTests
{
    private readonly TargetDetection[] _found = new TargetDetection[16];

    // The scale of a tilted camera grows up the picture: each panel is as large as it would be there.
    [Fact]
    public void Detect_TiltedCamera_FindsTargetsAtTheirScale()
    {
        var camera = new CameraModel
        {
            Width = Painting.Width,
            Height = Painting.Height,
            FocalX = 640,
            FocalY = 640,
            CentreX = (Painting.Width - 1) / 2.0,
            CentreY = (Painting.Height - 1) / 2.0,
        };
        const double tilt = 0.35;
        var nedFromCamera = Rotation.FromMatrix(
            0, -Math.Cos(tilt), Math.Sin(tilt), 1, 0, 0, 0, Math.Sin(tilt), Math.Cos(tilt));
        PictureGroundScale scale = PictureGroundScale.OfLevelGround(camera, nedFromCamera, 35);
        var painting = new Painting(4);
        (double X, double Y)[] places = [(100, 60), (320, 120), (540, 240), (120, 330), (400, 420)];
        foreach ((double x, double y) in places)
        {
            Assert.True(scale.TryAt(x, y, out GroundScale here));
            painting.Panel(DefaultTargetClasses.Red, x, y, 1 / Math.Sqrt(here.PixelArea), 0.4);
        }

        Assert.True(scale.TryAt(320, 0, out GroundScale top));
        Assert.True(scale.TryAt(320, 479, out GroundScale bottom));
        Assert.True(top.PixelArea > 2 * bottom.PixelArea, $"{top.PixelArea} {bottom.PixelArea}");
        var detector = new TemplateTargetDetector(PanelTemplate.Classes);
        var input = new DetectorInput(
            PanelTemplate.ThroughRedFilter(painting.Finish()), Painting.Width, Painting.Height,
            PanelTemplate.Classes, scale);
        int count = detector.Detect(input, _found).Count;
        Assert.All(_found.Take(count), f => Assert.Null(DetectionCheck.FindFault(f, input)));
        int right = places.Count(p => _found.Take(count)
            .Any(f => Math.Abs(f.CentreX - p.X) < 4 && Math.Abs(f.CentreY - p.Y) < 4));
        Assert.True(right >= 4 && count - right <= 2, $"{right} right of {count}");
    }

    [Fact]
    public void Detect_PixelsTooCoarse_IsNotSearched()
    {
        var input = new DetectorInput(
            new byte[300], 10, 10, PanelTemplate.Classes, PictureGroundScale.Uniform(0.3));
        DetectorResult result = new TemplateTargetDetector(PanelTemplate.Classes).Detect(input, _found);
        Assert.Equal(DetectorResult.NotSearched(TemplateTargetDetector.TooCoarse), result);
    }

    [Fact]
    public void Create_ClassWithoutTemplateOrOfAnotherSize_NamesIt()
    {
        Assert.Contains(
            "target class red has no template",
            Assert.Throws<ArgumentException>(() => new TemplateTargetDetector([TargetClass.Defaults[0]])).Message,
            StringComparison.Ordinal);
        TargetClass large = new("large") { Template = PanelTemplate.Red, MinSideMetres = 2, MaxSideMetres = 3 };
        TargetClass both = new("both") { Template = PanelTemplate.Red, Colour = new ColourRange(1, 2, 3) };
        string[] faults = [.. TargetClass.FindFaults([large, both])];
        Assert.Equal(2, faults.Length);
        Assert.Contains("a side of 1.00 m", faults[0], StringComparison.Ordinal);
        Assert.Contains("it can only have one of them", faults[1], StringComparison.Ordinal);
    }

    [Fact]
    public void CreateDetector_ColourAndTemplate_FindsBothAndOnlyWhatIsWanted()
    {
        ImmutableArray<TargetClass> classes =
            [.. TargetClass.Defaults, new TargetClass("panel") { Template = PanelTemplate.Red }];
        var options = new ImageProcessingOptions { TargetClasses = classes };
        Assert.Empty(options.FindFaults(hasCamera: false));
        ITargetDetector detector = options.CreateDetector();
        var painting = new Painting(5);
        painting.Panel(DefaultTargetClasses.Red, 200, 200, PanelTemplate.PixelsPerMetre, 0.2);
        painting.Panel(DefaultTargetClasses.Red, 480, 200, PanelTemplate.PixelsPerMetre, 0.2);
        byte[] picture = PanelTemplate.ThroughRedFilter(painting.Finish(), fromColumn: 340);
        string[] Names(params TargetClass[] wanted)
        {
            var input = new DetectorInput(
                picture, Painting.Width, Painting.Height, [.. wanted],
                PictureGroundScale.Uniform(1 / PanelTemplate.PixelsPerMetre));
            int count = detector.Detect(input, _found).Count;
            return [.. _found.Take(count).Select(f => f.Class.ToString()).Distinct(StringComparer.Ordinal)
                .OrderBy(n => n, StringComparer.Ordinal)];
        }

        Assert.Equal(["panel", "red"], Names([.. classes]));
        Assert.Equal(["panel"], Names(classes[5]));
        Assert.Equal(["red"], Names(classes[0]));
    }

    [Fact]
    public void MissionFile_Template_IsReadFromItsFolderAndRefusedByName()
    {
        string folder = Path.Combine(Path.GetTempPath(), Guid.NewGuid().ToString("N"));
        Directory.CreateDirectory(folder);
        try
        {
            PanelTemplate.Red.Save(Path.Combine(folder, "panel.template"));
            File.WriteAllText(Path.Combine(folder, "bad.template"), "rabit-template 1\n");
            MissionPlan plan = MissionPlan.Parse(Mission("panel.template"), "field.json", folder);
            Assert.Equal(PanelTemplate.Red.Name, plan.TargetClasses.Single().Template!.Name);
            foreach (string wrong in (string[])["bad.template", "none.template"])
            {
                var error = Assert.Throws<MissionPlanException>(
                    () => MissionPlan.Parse(Mission(wrong), "field.json", folder));
                Assert.Contains("targetClasses.panel.template", error.Message, StringComparison.Ordinal);
                Assert.Contains(wrong, error.Message, StringComparison.Ordinal);
            }
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    private static string Mission(string template) => """
        {
          "area": [[47.0, 8.0], [47.001, 8.0], [47.001, 8.001]], "heightMetres": 40, "speedMetresPerSecond": 5,
          "laneSpacingMetres": 20, "targetClasses": { "panel": { "template": "TEMPLATE" } }
        }
        """.Replace("TEMPLATE", template);
}
