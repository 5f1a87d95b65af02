using Rabit.Uav.ImageProcessing;
using Rabit.Vision;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>What is a piece of something larger of its colour.</summary>
public class PatchCandidatesTests
{
    // Of a person of 4 px the blur mixes ground into the edge: with it the colour is too pale for one, the form is not.
    // A bed of flowers is not of the form either, and what is in its middle is a piece of it.
    [Theory]
    [InlineData(15, 14.5, 19, false)]
    [InlineData(15, 11, 19, true)]
    [InlineData(9, 8.5, 19, true)]    // a target itself, and its edge is the target's
    [InlineData(15, 14.5, 60, true)]   // so large a thing has an edge that is small beside it
    public void IsPiece_WithAFadedEdgeOfTheSameForm_IsNone(
        double costOfWhole, double colourCostOfWhole, double area, bool isPiece)
    {
        var candidates = new PatchCandidates();
        candidates.Clear();
        candidates.Add(Of(costOfWhole, colourCostOfWhole, 1.6 * area, isStrong: false));
        PatchCandidate piece = Of(8, 7, area, isStrong: true);
        candidates.Add(piece);
        Assert.Equal(isPiece, candidates.IsPiece(piece));
    }

    private static PatchCandidate Of(double cost, double colourCost, double area, bool isStrong) => new()
    {
        Cost = cost,
        ColourCost = colourCost,
        IsStrong = isStrong,
        Parts = 1,
        Shape = new PatchShape { Area = area, CentreX = 20, CentreY = 20, Width = 9, Height = 6, Outline = 1 },
    };
}
