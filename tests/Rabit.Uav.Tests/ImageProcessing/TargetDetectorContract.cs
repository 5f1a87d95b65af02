using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Tests.Shared;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>
/// What Image Processing expects of any detector; run against the default one and one of the tests' own.
/// </summary>
public abstract class TargetDetectorContract
{
    /// <summary>Of the pictures.</summary>
    protected const double PixelsPerMetre = 13;

    private static readonly ImmutableArray<TargetClass> All = TargetClass.Defaults;

    private readonly ITargetDetector _detector;

    protected TargetDetectorContract(ITargetDetector detector) => _detector = detector;

    [Fact]
    public void Detect_NoTarget_FindsNone()
        => Assert.Equal(
            DetectorResult.Found(0),
            _detector.Detect(Input(Finish(new Painting(1).Finish())), new TargetDetection[16]));

    [Fact]
    public void Detect_OneTarget_IsValidAndWhereItIs()
    {
        DetectorInput input = Input(Painted(1));
        var found = new TargetDetection[16];

        Assert.Equal(DetectorResult.Found(1), _detector.Detect(input, found));

        Assert.Null(DetectionCheck.FindFault(found[0], input));
        Assert.Equal(DefaultTargetClasses.Red, found[0].Class);
        Assert.Equal(80, found[0].CentreX, 0.5);
        Assert.Equal(100, found[0].CentreY, 0.5);
        Assert.InRange(found[0].WidthPixels, 11, 20);
    }

    [Fact]
    public void Detect_MoreThanTheSpanHolds_FillsItWithTheBestAndCountsTheRest()
    {
        var found = new TargetDetection[2];
        DetectorResult result = _detector.Detect(Input(Painted(5)), found);
        Assert.Equal(DetectorResult.Found(2, dropped: 3), result);
        Assert.True(found[0].Score >= found[1].Score);
        Assert.Equal(DetectorResult.Found(0, dropped: 5), _detector.Detect(Input(Painted(5)), []));
    }

    [Fact]
    public void Detect_ClassThatIsNotAskedFor_IsNotReturned()
    {
        DetectorInput input = Input(Painted(3), All.Where(c => c.Name == DefaultTargetClasses.Blue));
        Assert.Equal(DetectorResult.Found(0), _detector.Detect(input, new TargetDetection[16]));
    }

    [Fact]
    public void Detect_SamePictureAgain_FindsTheSame()
    {
        DetectorInput input = Input(Painted(4));
        (var first, var second) = (new TargetDetection[16], new TargetDetection[16]);
        Assert.Equal(_detector.Detect(input, first), _detector.Detect(input, second));
        Assert.Equal(first, second);
    }

    [Fact]
    public void Detect_PictureAfterPicture_AllocatesNothingAndLeavesThePictureAsItIs()
    {
        byte[] picture = Painted(3);
        byte[] before = [.. picture];
        DetectorInput input = Input(picture);
        var found = new TargetDetection[16];
        _detector.Detect(input, found);
        Assert.Equal(0, Allocated.By(() => _detector.Detect(input, found)));
        Assert.Equal(before, picture);
    }

    /// <summary>Makes a painted picture one that the detector is for.</summary>
    protected virtual byte[] Finish(byte[] painted) => painted;

    /// <summary>Such a picture as input.</summary>
    protected virtual DetectorInput Input(byte[] picture, ImmutableArray<TargetClass> classes)
        => new(
            picture, Painting.Width, Painting.Height, classes, PictureGroundScale.Uniform(1 / PixelsPerMetre));

    private byte[] Painted(int panels)
    {
        var painting = new Painting(3);
        for (int i = 0; i < panels; i++)
            painting.Panel(DefaultTargetClasses.Red, 80 + (100 * i), 100, PixelsPerMetre, 0.3 * i);
        return Finish(painting.Finish());
    }

    private DetectorInput Input(byte[] picture, IEnumerable<TargetClass>? classes = null)
        => Input(picture, classes?.ToImmutableArray() ?? All);
}
