using Rabit.Uav.ImageProcessing;
using Rabit.Vision;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>How uncertain the centre of a patch is.</summary>
public class PatchCovarianceTests
{
    [Fact]
    public void Of_EvenSquare_IsTheSameInAllDirections()
    {
        PixelCovariance square = PatchCovariance.Of(Of(10, 10, unevenness: 0.05), hasParts: false);
        Assert.Equal(square.ColumnColumn, square.RowRow, 9);
        Assert.Equal(0, square.ColumnRow, 9);
        Assert.InRange(square.RowRow, 0.001, 0.01);
    }

    // A shadow over a part of it moves the centre by a good part of a pixel.
    [Fact]
    public void Of_UnevenSquare_IsLarger()
    {
        PixelCovariance even = PatchCovariance.Of(Of(10, 10, unevenness: 0.15), hasParts: false);
        PixelCovariance uneven = PatchCovariance.Of(Of(10, 10, unevenness: 0.35), hasParts: false);
        Assert.InRange(uneven.RowRow - even.RowRow, 0.3, 0.4);
        Assert.Equal(uneven.RowRow, uneven.ColumnColumn, 9);
    }

    // A person ends in head and boots of other colours; the windows of a car lie within it, and are parts of its length
    // as of its width.
    [Theory]
    [InlineData(false, 4, 200)]
    [InlineData(true, 1.5, 4)]
    public void Of_LongForm_IsLargerAlongItsLength(bool hasParts, double minRatio, double maxRatio)
    {
        PixelCovariance covariance = PatchCovariance.Of(Of(12, 4, unevenness: 0.1), hasParts);
        Assert.InRange(covariance.ColumnColumn / covariance.RowRow, minRatio, maxRatio);
        Assert.Equal(0, covariance.ColumnRow, 9);
    }

    // By what the ground varies, and whatever the size: what is as coarse as the patch is what moves it.
    [Theory]
    [InlineData(6)]
    [InlineData(30)]
    public void Of_UnevenGround_IsLargerByThat(double side)
    {
        PatchShape shape = Of(side, side, unevenness: 0.1);
        PixelCovariance even = PatchCovariance.Of(shape, hasParts: false);
        shape.GroundNoise = 0.2;
        PixelCovariance uneven = PatchCovariance.Of(shape, hasParts: false);
        Assert.InRange(uneven.RowRow - even.RowRow, 0.05, 0.06);
    }

    // As a JPEG, which has colour in half of the rows and columns.
    [Fact]
    public void Of_ContrastByColourAlone_IsLargerThanByBrightness()
    {
        PatchShape bright = Of(6, 6, unevenness: 0.1);
        (bright.Red, bright.Green, bright.Blue) = (80, 80, 80);
        PatchShape coloured = bright;
        (coloured.Red, coloured.Green, coloured.Blue) = (120, 0, 0);
        double byColour = PatchCovariance.Of(coloured, hasParts: false).RowRow;
        Assert.InRange(byColour - PatchCovariance.Of(bright, hasParts: false).RowRow, 0.0004, 0.001);
        coloured.Contrast /= 2;
        Assert.InRange(PatchCovariance.Of(coloured, hasParts: false).RowRow - byColour, 0.001, 0.003);
    }

    private static PatchShape Of(double columns, double rows, double unevenness) => new()
    {
        Area = columns * rows,
        MomentXX = (columns * columns / 12) + PatchCost.BlurVariance,
        MomentYY = (rows * rows / 12) + PatchCost.BlurVariance,
        Unevenness = unevenness,
        GroundNoise = 0.02,
        Contrast = 120,
    };
}
