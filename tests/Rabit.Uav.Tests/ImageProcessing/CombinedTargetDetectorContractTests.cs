using System;
using System.Collections.Immutable;
using Rabit.Tests.Shared;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Vision;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>
/// The contract with classes of several kinds. There is a panel of red and yellow: of each form of one of these it is
/// asked whether it is half of one.
/// </summary>
public sealed class CombinedTargetDetectorContractTests : TargetDetectorContract
{
    private static readonly TargetClass Half =
        new("red-yellow") { Colour = new ColourRange(205, 28, 32), SecondColour = new ColourRange(243, 214, 28) };

    private static readonly ImmutableArray<TargetClass> Classes =
    [
        .. TargetClass.Defaults,
        Half,
        new("pad") { Marker = new TargetMarker(MarkerFamily.ArUco4x4), MinSideMetres = 0.5, MaxSideMetres = 3 },
    ];

    public CombinedTargetDetectorContractTests()
        : base(Create())
    {
    }

    // The red half is found as a form, since the whole ground passes as yellow.
    [Fact]
    public void Detect_HalfOfAPanel_AllocatesNothing()
    {
        var painting = new Painting(12);
        painting.Rectangle((140, 118, 35), 320, 240, Painting.Width, Painting.Height, 0);
        painting.TwoColours((205, 28, 32), (243, 214, 28), 200, 150, 15, 0.3, isChequered: false);
        DetectorInput input = Input(painting.Finish(), [.. Classes]);
        var found = new TargetDetection[16];
        CombinedTargetDetector detector = Create();

        Assert.Equal(DetectorResult.Found(1), detector.Detect(input, found));
        Assert.Equal(Half.Name, found[0].Class);
        Assert.Null(found[0].Bearing);   // completed: the panel detector gives one
        Assert.Equal(0, Allocated.By(() => detector.Detect(input, found)));
    }

    private static CombinedTargetDetector Create()
        => Assert.IsType<CombinedTargetDetector>(
            new ImageProcessingOptions { TargetClasses = Classes }.CreateDetector());
}
