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
        Assert.InRange(square.RowRow, 0.01, 0.05);
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

    // A person ends in head and boots of other colours; the windows of a car lie within it.
    [Theory]
    [InlineData(false, 4)]
    [InlineData(true, 1)]
    public void Of_LongForm_IsLargerAlongItsLengthWhereItsEndsMayBeMissing(bool hasParts, double minRatio)
    {
        PixelCovariance covariance = PatchCovariance.Of(Of(12, 4, unevenness: 0.1), hasParts);
        Assert.InRange(covariance.ColumnColumn / covariance.RowRow, minRatio, hasParts ? 1.2 : 60);
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
