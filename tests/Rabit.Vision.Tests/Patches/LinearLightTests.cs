using Xunit;

namespace Rabit.Vision.Tests.Patches;

/// <summary>The curve of sRGB, against its definition.</summary>
public class LinearLightTests
{
    [Theory]
    [InlineData(0, 0)]
    [InlineData(10, 0.003035)]
    [InlineData(128, 0.215861)]
    [InlineData(255, 1)]
    public void Of_Level_IsTheLightOfTheStandard(double level, double light)
        => Assert.Equal(light, LinearLight.Of(level), 5);

    [Fact]
    public void ToLevel_LightOfEachLevel_IsThatLevel()
    {
        for (int level = 0; level < 256; level++)
            Assert.Equal(level, LinearLight.ToLevel(LinearLight.Of(level)), 3);
    }

    [Fact]
    public void ToLevel_LessThanNoLight_IsBlack() => Assert.Equal(0, LinearLight.ToLevel(-0.1));
}
