using Xunit;

namespace Rabit.Vision.Tests.Metadata;

/// <summary>The calibrated lens in XMP, as DJI writes it.</summary>
public sealed class PhotoLensTests
{
    private static readonly PhotoLens Lens = new()
    {
        FocalX = 3678.87,
        FocalY = 3671.84,
        CentreOffsetX = 10.1,
        CentreOffsetY = -27.29,
        K1 = -0.268652,
        K2 = 0.114663,
        P1 = 0.000015,
        P2 = -0.000046,
        K3 = -0.035026,
    };

    [Fact]
    public void Png_Lens_ComesBack()
    {
        byte[] file = PngPicture.Encode(new RgbPicture(2, 1, new byte[6]), new PhotoMetadata { Lens = Lens });
        PhotoMetadata read = PhotoMetadata.Read(file, "a.png");
        Assert.Equal(Lens, read.Lens);
        Assert.Empty(read.Faults);
    }

    [Theory]
    [InlineData("2018-09-28;3678.87,3671.84,10.1,-27.29,-0.268652,0.114663,0.000015,-0.000046,-0.035026", true)]
    [InlineData("3678.87,3671.84,10.1,-27.29,-0.268652,0.114663,0.000015,-0.000046,-0.035026", true)]
    [InlineData("", false)]
    [InlineData(";", false)]
    [InlineData("2018-09-28;1,2,3", false)]
    [InlineData("2018-09-28;0,3671.84,10.1,-27.29,-0.26,0.11,0.000015,-0.000046,-0.03", false)]
    [InlineData("2018-09-28;NaN,3671.84,10.1,-27.29,-0.26,0.11,0.000015,-0.000046,-0.03", false)]
    [InlineData("2018-09-28;1e9,3671.84,10.1,-27.29,-0.26,0.11,0.000015,-0.000046,-0.03", false)]
    [InlineData("2018-09-28;a,b,c,d,e,f,g,h,i", false)]
    public void Read_AnyText_IsALensOrNone(string text, bool isLens)
        => Assert.Equal(isLens ? Lens : null, XmpLens.Read(text));
}
