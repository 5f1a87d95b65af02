using System;
using System.Linq;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Vision;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>A class that declares a shape: in code, in a mission file, and what is refused.</summary>
public sealed class TargetShapeTests
{
    private static readonly ColourRange Red = new(205, 28, 32);

    [Fact]
    public void CreateDetector_AShapeThatCannotBe_IsRefusedByName()
    {
        Assert.Contains("target class pad has the Shape Circle and no Colour", FaultOf(
            new TargetClass("pad") { Shape = TargetShape.Circle }));
        Assert.Contains("target class pad has the Shape Cross and a marker", FaultOf(
            new TargetClass("pad") { Shape = TargetShape.Cross, Marker = new TargetMarker(MarkerFamily.ArUco4x4) }));
        Assert.Contains("target class pad has the Shape 9, which is none", FaultOf(
            new TargetClass("pad") { Shape = (TargetShape)9, Colour = Red }));
        Assert.Contains("target class pad has the Shape Triangle and a MinColourShare of 0.7", FaultOf(
            new TargetClass("pad") { Shape = TargetShape.Triangle, Colour = Red, MinColourShare = 0.7 }));
    }

    [Theory]
    [InlineData("Circle", TargetShape.Circle)]
    [InlineData("Rectangle", TargetShape.Rectangle)]
    public void Load_MissionFileWithAShape_HasIt(string text, TargetShape shape)
    {
        TargetClass read = MissionPlan.Parse(MissionWith(text), "field.json").TargetClasses.Single();
        Assert.Equal(shape, read.Shape);
    }

    [Theory]
    [InlineData("circle")]
    [InlineData("2")]
    public void Load_MissionFileWithAShapeThatIsNone_NamesThoseThatThereAre(string text)
    {
        Exception fault = Assert.ThrowsAny<Exception>(() => MissionPlan.Parse(MissionWith(text), "field.json"));
        Assert.Contains("must be one of Any, Rectangle, Circle, Cross, Triangle", fault.Message);
    }

    [Fact]
    public void Detect_RedSquare_IsNoRedCircleAndStillAnyForm()
    {
        var painting = new Painting(3);
        painting.Panel(DefaultTargetClasses.Red, 200, 200, 14, 0.3);
        byte[] picture = painting.Finish();
        Assert.Equal(0, CountOf(picture, TargetShape.Circle));
        Assert.Equal(0, CountOf(picture, TargetShape.Cross));
        Assert.Equal(0, CountOf(picture, TargetShape.Triangle));
        Assert.Equal(1, CountOf(picture, TargetShape.Rectangle));
        Assert.Equal(1, CountOf(picture, TargetShape.Any));
    }

    private static int CountOf(byte[] picture, TargetShape shape)
    {
        TargetClass[] classes = [new("pad") { Colour = Red, Shape = shape }];
        return new ShapeTargetDetector([.. classes]).Detect(
            new DetectorInput(
                picture, Painting.Width, Painting.Height, [.. classes], PictureGroundScale.Uniform(1 / 14.0)),
            new TargetDetection[4]).Count;
    }

    private static string FaultOf(TargetClass target)
        => Assert.Throws<InvalidOperationException>(
            () => new ImageProcessingOptions { TargetClasses = [target] }.CreateDetector()).Message;

    private static string MissionWith(string shape) => $$"""
        {
          "area": [[47.0, 8.0], [47.001, 8.0], [47.001, 8.001]], "heightMetres": 40, "speedMetresPerSecond": 5,
          "laneSpacingMetres": 20,
          "targetClasses": { "pad": { "colour": "#cd1c20", "shape": "{{shape}}" } }
        }
        """;
}
