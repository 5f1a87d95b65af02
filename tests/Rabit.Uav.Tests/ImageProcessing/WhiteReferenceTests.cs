using Rabit.Uav.ImageProcessing;
using Rabit.Vision;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>How bright white is in a picture.</summary>
public class WhiteReferenceTests
{
    private readonly WhiteReference _white = new();

    public WhiteReferenceTests() => _white.Clear(level: 110);

    [Fact]
    public void DarknessOf_TheBrightest_IsZero()
    {
        _white.Add(Of(200, 110), cost: 4);
        Assert.Equal(0, _white.DarknessOf(Of(200, 110)));
        Assert.Equal(0, _white.DarknessOf(Of(194, 110)));
    }

    [Fact]
    public void DarknessOf_GreyBesideWhite_IsLarge()
    {
        _white.Add(Of(250, 110), cost: 4);
        Assert.InRange(_white.DarknessOf(Of(205, 110)), 8, 40);
    }

    [Fact]
    public void DarknessOf_InTheShade_IsZero()
    {
        _white.Add(Of(250, 110), cost: 4);
        Assert.Equal(0, _white.DarknessOf(Of(150, 55)));
    }

    [Fact]
    public void DarknessOf_BesideWhatIsHardlyWhite_IsZero()
    {
        _white.Add(Of(255, 110), cost: 30);
        Assert.Equal(0, _white.DarknessOf(Of(180, 110)));
    }

    [Fact]
    public void DarknessOf_InTheNextPicture_KnowsNothing()
    {
        _white.Add(Of(250, 110), cost: 4);
        _white.Clear(level: 110);
        Assert.Equal(0, _white.DarknessOf(Of(180, 110)));
    }

    private static PatchShape Of(double level, double ground) => new()
    {
        Red = level,
        Green = level,
        Blue = level,
        GroundRed = ground,
        GroundGreen = ground,
        GroundBlue = ground,
    };
}
