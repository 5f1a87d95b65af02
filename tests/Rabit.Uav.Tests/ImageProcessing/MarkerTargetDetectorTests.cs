using System;
using System.Collections.Immutable;
using System.IO;
using System.Linq;
using Rabit.Tests.Shared;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Vision;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>Markers as targets, in a generated picture with one of DICT_4X4_50: id 46, 2.64 m.</summary>
public sealed class MarkerTargetDetectorTests
{
    private const double MetresPerPixel = 0.109;

    private static readonly TargetClass Any = Class("any marker", new TargetMarker(MarkerFamily.ArUco4x4));
    private static readonly TargetClass Pad = Class("pad", new TargetMarker(MarkerFamily.ArUco4x4, 46));
    private static readonly TargetClass Tag = Class("tag", new TargetMarker(MarkerFamily.AprilTag36h11));

    private static readonly RgbPicture Picture = new PictureReader().Load(
        Path.Combine(Repository.Root, "tests", "data", "markers", "stills_640_f0048.jpg"));

    private readonly TargetDetection[] _found = new TargetDetection[16];

    [Fact]
    public void Detect_Marker_IsOfItsClassWithItsIdAndValid()
    {
        DetectorInput input = Input(Any, Tag);
        Assert.Equal(DetectorResult.Found(1), new MarkerTargetDetector([Any, Tag]).Detect(input, _found));
        Assert.Equal((Any.Name, 46), (_found[0].Class, _found[0].MarkerId));
        Assert.Null(DetectionCheck.FindFault(_found[0], input));
        Assert.InRange(_found[0].SideMetres, 2.4, 2.8);
        Assert.InRange(_found[0].Score, 0.9, 1);
        Assert.InRange(Math.Sqrt(_found[0].Covariance.RowRow), 0.03, 0.3);
    }

    [Fact]
    public void Detect_ClassWithTheId_ComesBeforeOneOfAny()
    {
        foreach (TargetClass[] classes in new[] { new[] { Any, Pad }, [Pad, Any] })
        {
            Assert.Equal(1, new MarkerTargetDetector([.. classes]).Detect(Input(classes), _found).Count);
            Assert.Equal(Pad.Name, _found[0].Class);
        }
    }

    [Fact]
    public void Detect_OtherIdSizeOrClassNotWanted_FindsNone()
    {
        TargetClass other = Class("other", new TargetMarker(MarkerFamily.ArUco4x4, 45));
        TargetClass small = new("small")
        {
            Marker = new TargetMarker(MarkerFamily.ArUco4x4),
            MinSideMetres = 0.1,
            MaxSideMetres = 2,
        };
        var detector = new MarkerTargetDetector([Any, Tag, other, small]);
        Assert.Equal(0, detector.Detect(Input(other), _found).Count);
        Assert.Equal(0, detector.Detect(Input(small), _found).Count);
        Assert.Equal(0, detector.Detect(Input(Tag), _found).Count);
    }

    [Fact]
    public void DefaultDetector_ColoursAndMarkers_FindsWhatIsWanted()
    {
        ImmutableArray<TargetClass> classes = [.. TargetClass.Defaults, Any];
        ITargetDetector detector = new ImageProcessingOptions { TargetClasses = classes }.CreateDetector();
        DetectorResult both = detector.Detect(Input([.. classes]), _found);
        Assert.Equal(0, both.Dropped);
        Assert.Single(_found.Take(both.Count), d => d.MarkerId == 46);
        double[] scores = [.. _found.Take(both.Count).Select(d => d.Score)];
        Assert.Equal(scores.OrderByDescending(s => s), scores);
        Assert.Equal(1, detector.Detect(Input(Any), _found).Count);
        int coloured = detector.Detect(Input([.. TargetClass.Defaults]), _found).Count;
        Assert.Equal(both.Count - 1, coloured);
    }

    [Fact]
    public void Detect_PictureAgain_AllocatesNothing()
    {
        if (!Allocated.IsSupported)
            return;
        ImmutableArray<TargetClass> classes = [.. TargetClass.Defaults, Any];
        ITargetDetector detector = new ImageProcessingOptions { TargetClasses = classes }.CreateDetector();
        byte[] pixels = Picture.Pixels;
        Action work = () => detector.Detect(
            new DetectorInput(pixels, Picture.Width, Picture.Height, classes, PictureGroundScale.Uniform(0.109)),
            _found);
        work();
        Assert.Equal(0, Allocated.By(work));
    }

    [Fact]
    public void Options_MarkerFaults_AreNamed()
    {
        TargetClass both = new("both")
        {
            Marker = new TargetMarker(MarkerFamily.ArUco4x4),
            Colour = new ColourRange(1, 2, 3),
        };
        TargetClass high = Class("high", new TargetMarker(MarkerFamily.ArUco4x4, 50));
        string[] faults = [.. TargetClass.FindFaults([both, high, Class("tag", new TargetMarker((MarkerFamily)7))])];
        Assert.Contains(faults, f => f.Contains("both has a colour and a marker", StringComparison.Ordinal));
        Assert.Contains(faults, f => f.Contains("high has the id 50; ArUco4x4 has 0 to 49", StringComparison.Ordinal));
        Assert.Contains(faults, f => f.Contains("unknown family 7", StringComparison.Ordinal));
        Assert.Contains(
            "has no marker",
            Assert.Throws<ArgumentException>(() => new MarkerTargetDetector([new TargetClass("x")])).Message,
            StringComparison.Ordinal);
    }

    private static TargetClass Class(string name, TargetMarker marker)
        => new(name) { Marker = marker, MinSideMetres = 2, MaxSideMetres = 3.2 };

    private static DetectorInput Input(params TargetClass[] classes) => new(
        Picture.Pixels, Picture.Width, Picture.Height, [.. classes], PictureGroundScale.Uniform(MetresPerPixel));
}
