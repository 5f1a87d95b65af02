using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Vision;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>White parts of what is printed on black, as the cells of a marker that is too large in the picture to be
/// taken for one panel, beside a white panel on the same dark things.</summary>
public class WhiteOnBlackTests
{
    private const int Seed = 700;
    private const double MetresPerPixel = 0.03;
    private const double Side = 1 / MetresPerPixel;

    // In the yellowish light of the painted grass.
    private static readonly (double, double, double) White = (240, 240, 223);
    private static readonly (double, double, double) Ink = (24, 24, 24);
    private static readonly (double, double, double) Asphalt = (64, 65, 62);

    private static readonly ImmutableArray<TargetClass> Classes =
    [
        new TargetClass("white") { Colour = new ColourRange(236, 236, 234) },
        new TargetClass("red") { Colour = new ColourRange(205, 28, 32) },
    ];

    private readonly ShapeTargetDetector _detector = new(Classes);
    private readonly TargetDetection[] _found = new TargetDetection[16];

    [Theory]
    [InlineData(2, 3)]
    [InlineData(3, 3)]
    [InlineData(3, 2)]
    public void Detect_WhiteCellsOfAMarker_AreNoWhitePanel(int across, int down)
    {
        const double Cell = 1.6 / 6 / MetresPerPixel;
        for (int turn = 0; turn < 8; turn++)
        {
            double angle = 0.2 + (0.4 * turn);
            var painting = new Painting(Seed + turn);
            painting.Rectangle(White, 320, 240, 8 * Cell, 8 * Cell, angle);
            painting.Rectangle(Ink, 320, 240, 6 * Cell, 6 * Cell, angle);
            painting.Rectangle(White, 320, 240, across * Cell, down * Cell, angle);

            Assert.Empty(Search(painting));
        }
    }

    [Fact]
    public void Detect_WhitePanelOnAsphalt_IsFound()
    {
        for (int turn = 0; turn < 8; turn++)
        {
            double angle = 0.2 + (0.4 * turn);
            var painting = new Painting(Seed + turn);
            painting.Rectangle(Asphalt, 320, 240, 4 * Side, 3 * Side, angle);
            painting.Rectangle(White, 320, 240, Side, Side, angle + 0.3);

            Assert.Equal(["white"], Search(painting));
        }
    }

    private string[] Search(Painting painting)
    {
        var input = new DetectorInput(
            painting.Finish(), Painting.Width, Painting.Height, Classes, PictureGroundScale.Uniform(MetresPerPixel));
        DetectorResult result = _detector.Detect(input, _found);
        return [.. _found.Take(result.Count).Select(f => f.Class.ToString())];
    }
}
