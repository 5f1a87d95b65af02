using System;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Vision;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>
/// What several detectors report of one place, with detectors that report what they are given: the sizes at which a
/// panel is a part of what lies around it.
/// </summary>
public sealed class CombinedTargetDetectorPartsTests
{
    private const double PanelSideMetres = 1;
    private const double PixelsPerMetre = 13;

    private static readonly TargetClass Panel = new("black") { Colour = new ColourRange(26, 24, 24) };

    /// <summary>
    /// The limit is 2.5 times the area: a form that took in ground of its hue had up to 2.05 times that of the panel.
    /// </summary>
    [Theory]
    [InlineData(24, 1.5, "black")]
    [InlineData(24, 1.65, "car")]
    [InlineData(240, 1.65, "black, car")]
    public void Detect_PanelWithinALargerForm_IsAPartOfItWhereThatIsMuchLargerAndOfItsColour(
        byte level, double formSideMetres, string expected)
        => Assert.Equal(expected, Find(Car(level), formSideMetres, PanelSideMetres));

    /// <summary>Where the areas on the ground were not measured the boxes in the picture decide.</summary>
    [Theory]
    [InlineData(1.5, "black")]
    [InlineData(1.65, "car")]
    public void Detect_SidesThatWereNotMeasured_AreThoseOfTheBoxes(double times, string expected)
        => Assert.Equal(expected, Find(Car(24), sideMetres: 0, panelSideMetres: 0, times));

    [Fact]
    public void Detect_PanelBesideAMuchLargerFormOfItsColour_IsFoundToo()
        => Assert.Equal("black, car", Find(Car(24), 3, PanelSideMetres, centreX: 300));

    /// <summary>This black is a little red: its hue is noise all the same, and it is no part of a red car.</summary>
    [Fact]
    public void Detect_BlackPanelOnAColouredForm_IsFoundToo()
        => Assert.Equal("black, car", Find(Car(new ColourRange(205, 28, 32)), 3, PanelSideMetres));

    private static TargetClass Car(byte level) => Car(new ColourRange(level, level, level));

    private static TargetClass Car(ColourRange colour) => new("car")
    {
        Colour = colour,
        MinSideMetres = 1.2,
        MaxSideMetres = 3.6,
        MinColourShare = 0.65,
    };

    private static string Find(
        TargetClass form, double sideMetres, double panelSideMetres, double times = 3, double centreX = 200)
    {
        TargetDetection panelFound = At(Panel, 200, panelSideMetres, PanelSideMetres);
        TargetDetection formFound = At(form, centreX, sideMetres, times * PanelSideMetres);
        var detector = new CombinedTargetDetector(
            [new PartDetector(new GivenDetector(panelFound), [Panel]),
                new PartDetector(new GivenDetector(formFound), [form])]);
        var input = new DetectorInput(
            new byte[3 * Painting.Width * Painting.Height], Painting.Width, Painting.Height, [Panel, form],
            PictureGroundScale.Uniform(1 / PixelsPerMetre));
        var found = new TargetDetection[8];
        DetectorResult result = detector.Detect(input, found);
        return string.Join(", ", found.Take(result.Count).Select(f => f.Class.ToString())
            .OrderBy(n => n, StringComparer.Ordinal));
    }

    private static TargetDetection At(TargetClass target, double centreX, double sideMetres, double boxMetres) => new()
    {
        Class = target.Name,
        CentreX = centreX,
        CentreY = 150,
        WidthPixels = boxMetres * PixelsPerMetre,
        HeightPixels = boxMetres * PixelsPerMetre,
        SideMetres = sideMetres,
        Score = 0.9,
        Covariance = PixelCovariance.FromSigma(0.3),
    };

    private sealed class GivenDetector(TargetDetection given) : ITargetDetector
    {
        public DetectorResult Detect(in DetectorInput input, Span<TargetDetection> detections)
        {
            detections[0] = given;
            return DetectorResult.Found(1);
        }
    }
}
