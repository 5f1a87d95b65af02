using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Preflight;
using Rabit.Uav.Tests.ImageProcessing;
using Rabit.Uav.Tests.MissionControl;
using Rabit.Vision;
using Xunit;

namespace Rabit.Uav.Tests.Preflight;

/// <summary>Whether a mission is too high for its camera and its smallest target, before it flies.</summary>
public sealed class SearchResolutionTests
{
    private static readonly CameraModel Camera = new()
    {
        Width = 640,
        Height = 480,
        FocalX = 530,
        FocalY = 530,
        CentreX = 319.5,
        CentreY = 239.5,
    };

    private static readonly TargetClass Person = new("person")
    {
        Colour = new ColourRange(242, 112, 18),
        MinSideMetres = 0.5,
        MaxSideMetres = 1.3,
        MinColourShare = 0.4,
    };

    private static readonly TargetClass Tag = new("tag")
    {
        Marker = new TargetMarker(MarkerFamily.AprilTag36h11),
        MinSideMetres = 0.8,
        MaxSideMetres = 1,
    };

    [Theory]
    [InlineData(40, PreflightResult.Pass, "person of 0.5 m: 6.6 pixels from 40 m; 4.0 are needed")]
    [InlineData(65, PreflightResult.Warn, "person of 0.5 m: 4.0 pixels from 65 m; 4.0 are needed, as from 63 m")]
    [InlineData(80, PreflightResult.Fail, "person of 0.5 m: 3.3 pixels from 80 m; 4.0 are needed, as from 63 m")]
    public void Line_ByHeight_NamesClassPixelsAndTheHeightThatWouldDo(
        double height, PreflightResult result, string text)
    {
        PreflightFacts facts = PreflightCases.Facts(
            options: o => o.Resolution = Of(height, [.. TargetClass.Defaults, Person]));
        PreflightLine line = facts.Line("resolution");
        Assert.Equal((result, text), (line.Result, line.Value));
        Assert.Equal(result != PreflightResult.Pass, line.HowToSet.Length > 0);
    }

    [Fact]
    public void Line_VehicleOfAGroup_WarnsOnly()
    {
        PreflightFacts facts = PreflightCases.Facts(options: o =>
        {
            o.Resolution = Of(80, [Person]);
            o.IsInGroup = true;
        });
        Assert.Equal(PreflightResult.Warn, facts.Line("resolution").Result);
    }

    [Fact]
    public void Line_HeightThatItNames_Passes()
    {
        for (double height = 64; height < 400; height += 7.3)
        {
            double sufficient = Of(height, [Person])!.SufficientHeightMetres;
            Assert.False(Of(sufficient, [Person])!.IsScarce, $"{height}: {sufficient}");
        }
    }

    [Fact]
    public void Of_Marker_NeedsThePixelsOfItsCells()
    {
        SearchResolution resolution = Of(31, [Tag, Person])!;
        Assert.StartsWith("tag of 0.8 m: 13.6 pixels from 31 m; 14.0 are needed", resolution.ToString());
        Assert.True(resolution.IsTooCoarse);
    }

    [Fact]
    public void Of_NothingToJudge_IsNone()
    {
        Assert.Null(Of(40, []));
        Assert.Null(SearchResolution.Of(Camera, new CameraMount(), Down, default, 40, 0, [Person]));
        Assert.Equal(PreflightResult.Pass, PreflightCases.Facts().Line("resolution").Result);
    }

    [Fact]
    public void Of_CameraAtTheHorizon_Fails()
    {
        SearchResolution resolution = SearchResolution.Of(
            Camera, new CameraMount(), Angle.Zero, Angle.Zero, 40, 4, [Person])!;
        Assert.True(resolution.IsTooCoarse);
        Assert.Equal("the middle of the picture shows no ground", resolution.ToString());
    }

    // What the pictures of the flight are judged by, with the projection of Image Processing.
    [Fact]
    public void Of_AnyPitch_IsTheSamplingOfThePictures()
    {
        const int seed = 12;
        var random = new Random(seed);
        for (int i = 0; i < 50; i++)
        {
            var view = new TestView { CameraPitch = -1.5 + random.NextDouble(), CameraYaw = random.NextDouble() };
            Assert.True(view.Projection(new Rabit.Uav.ImageProcessing.Geolocation.ErrorBudget())
                .TryScale(view.Camera.CentreX, view.Camera.CentreY, out GroundScale scale));
            SearchResolution resolution = SearchResolution.Of(
                view.Camera, view.Mount, Angle.FromRadians(view.CameraPitch), Angle.FromRadians(view.CameraYaw),
                view.Position.AltitudeAmslMetres - view.GroundAltitude, 4, [Person])!;
            Assert.Equal(0.5 / Math.Sqrt(scale.PixelArea), resolution.Pixels, 1e-3);
        }
    }

    [Fact]
    public void Options_MissionThatIsTooHigh_IsInTheChecklistAndRefusesAChange()
    {
        UavOptions options = Options(height: 40);
        Assert.False(ResolutionOf(options)!.IsTooCoarse);
        Func<MissionPlan, string?> judge = ManagerOptions.ForMissionControl(options).FindsFaultOfChange!;
        Assert.Null(judge(Plan(40)));
        Assert.StartsWith(
            "heightMetres of the mission is too much for its smallest target: red of 0.6 m", judge(Plan(100)));

        options = Options(height: 100);
        Assert.StartsWith("red of 0.6 m: 3.1 pixels from 100 m", ResolutionOf(options)!.ToString());
        options.Imaging.MinTargetPixels = 0;
        Assert.Null(ResolutionOf(options));
    }

    [Fact]
    public void Open_MoreFormsThanTheDetectorKnows_IsAFault()
    {
        UavOptions options = Options(height: 40);
        options.Imaging.TargetClasses =
        [
            .. Enumerable.Range(0, ShapeTargetDetector.MaxClasses + 1).Select(i => new TargetClass($"form {i}")
            {
                Colour = new ColourRange((byte)(3 * i), 40, (byte)(255 - (3 * i))), MinColourShare = 0.6,
            }),
        ];
        string text = Assert.Throws<ArgumentException>(() => UavSystem.Open(options)).Message;
        Assert.Contains(
            "Image Processing: there are 65 target classes; the shape detector takes at most 64", text);
    }

    private static SearchResolution? ResolutionOf(UavOptions options)
        => ManagerOptions.ForHealth(options, new Rabit.Core.VirtualTime(1)).Preflight!.Resolution;

    private static Angle Down => Angle.FromDegrees(-90);

    private static SearchResolution? Of(double height, IEnumerable<TargetClass> classes)
        => SearchResolution.Of(Camera, new CameraMount(), Down, Angle.Zero, height, 4, classes);

    private static MissionPlan Plan(double height)
        => MissionPlan.Parse(
            MissionRig.Text().Replace(
                "\"heightMetres\":40", FormattableString.Invariant($"\"heightMetres\":{height}")), "height");

    private static UavOptions Options(double height) => new()
    {
        OpenLinks = [new Rabit.Links.MemoryLinkPair("vehicle").A],
        Mission = Plan(height),
        MayCommand = true,
        Camera = new ScriptedCamera([]),
        Imaging = new ImageProcessingOptions { Camera = Camera },
    };
}
