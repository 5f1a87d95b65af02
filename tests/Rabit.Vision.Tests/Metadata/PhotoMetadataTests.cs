using System;
using System.Linq;
using System.Text;
using Rabit.Tests.Shared;
using Rabit.Vision.Tests.Jpeg;
using Xunit;

namespace Rabit.Vision.Tests.Metadata;

public sealed class PhotoMetadataTests
{
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Read_ADronesPhoto_GivesAll(bool isBig)
    {
        PhotoMetadata photo = PhotoMetadata.Read(PhotoBytes.Drone(isBig), "x");

        Assert.Empty(photo.Faults);
        Assert.Equal(("DJI", "FC300S", 1), (photo.Make, photo.Model, photo.Orientation));
        Assert.Equal((61, 43, 4000, 2250), (photo.Width, photo.Height, photo.PixelWidth, photo.PixelHeight));
        Assert.Equal(new DateTime(2016, 6, 23, 16, 31, 59, 250), photo.TakenLocal);
        Assert.Equal(TimeSpan.FromMilliseconds(10), photo.TakenResolution);
        Assert.Equal(
            new DateTimeOffset(2016, 6, 23, 16, 31, 59, 250, TimeSpan.FromHours(-5)), photo.Taken);
        Assert.Equal(new DateTimeOffset(2016, 6, 23, 21, 31, 59, 500, TimeSpan.Zero), photo.PositionTimeUtc);
        Assert.Equal(46 + (50 / 60.0) + (33.3855 / 3600), photo.LatitudeDegrees!.Value, 10);
        Assert.Equal(-(91 + (59 / 60.0) + (40.4156 / 3600)), photo.LongitudeDegrees!.Value, 10);
        Assert.Equal((-198.309, 45.25, true),
            (photo.AltitudeAmslMetres, photo.ImageDirectionDegrees, photo.IsImageDirectionMagnetic));
        Assert.Equal((3.61, 20.0),
            (photo.FocalLengthMillimetres, photo.FocalLength35MillimetreEquivalentMillimetres));
        Assert.Equal((39.8, 198.31), (photo.RelativeAltitudeMetres, photo.AbsoluteAltitudeMetres));
        Assert.Equal((0.1, -89.9, 45), (photo.GimbalRollDegrees, photo.GimbalPitchDegrees, photo.GimbalYawDegrees));
        Assert.Equal((3, 1.8, -46), (photo.FlightRollDegrees, photo.FlightPitchDegrees, photo.FlightYawDegrees));
    }

    [Fact]
    public void Read_XmpElementsAndMisspelling_GivesThem()
    {
        byte[] xmp = Encoding.ASCII.GetBytes(Encoding.ASCII.GetString(PhotoBytes.Xmp(string.Empty)).Replace(
            "></rdf:Description>",
            "><drone-dji:GimbalYawDegree>-106.6</drone-dji:GimbalYawDegree>"
            + "<drone-dji:GpsLatitude>+22.5</drone-dji:GpsLatitude>"
            + "<drone-dji:GpsLongtitude>114.25</drone-dji:GpsLongtitude></rdf:Description>"));

        PhotoMetadata photo = PhotoMetadata.Read(PhotoBytes.With(null, xmp), "x");

        Assert.Empty(photo.Faults);
        Assert.Equal((-106.6, 22.5, 114.25), (photo.GimbalYawDegrees, photo.LatitudeDegrees, photo.LongitudeDegrees));
    }

    // One text for XML, in parts for those that read it.
    [Theory]
    [InlineData("-4<!-- of the gimbal -->5.5")]
    [InlineData("<![CDATA[-45.5]]>")]
    [InlineData("-4<?a b?><![CDATA[5]]>.5")]
    [InlineData("\n  &#45;45.5\n")]
    public void Read_XmpElementInParts_IsOneNumber(string text)
    {
        byte[] xmp = Encoding.ASCII.GetBytes(Encoding.ASCII.GetString(PhotoBytes.Xmp(string.Empty)).Replace(
            "></rdf:Description>",
            $"><drone-dji:GimbalPitchDegree>{text}</drone-dji:GimbalPitchDegree><rdf:b>7</rdf:b></rdf:Description>"));

        PhotoMetadata photo = PhotoMetadata.Read(PhotoBytes.With(null, xmp), "x");

        Assert.Empty(photo.Faults);
        Assert.Equal(-45.5, photo.GimbalPitchDegrees);
    }

    [Fact]
    public void Read_XmpThatNeverEnds_IsAFaultOfALine()
    {
        byte[] xmp = Encoding.ASCII.GetBytes(
            "http://ns.adobe.com/xap/1.0/\0" + string.Concat(Enumerable.Repeat("<a>", 10_000)));

        string fault = Assert.Single(PhotoMetadata.Read(PhotoBytes.With(null, xmp), "x").Faults);

        Assert.StartsWith("XMP: ", fault, StringComparison.Ordinal);
        Assert.InRange(fault.Length, 20, 220);
    }

    [Fact]
    public void Read_ExtendedXmp_IsNamedAsNotRead()
    {
        byte[] part = Encoding.ASCII.GetBytes("http://ns.adobe.com/xmp/extension/\0" + new string('A', 40) + "<a/>");
        byte[] file = JpegFiles.With(JpegFiles.With(PhotoBytes.Drone(), 0xE1, part), 0xE1, part);

        PhotoMetadata photo = PhotoMetadata.Read(file, "x");

        Assert.Equal(["XMP: its extension (ExtendedXMP) is not read"], photo.Faults);
        Assert.Equal(-89.9, photo.GimbalPitchDegrees);
    }

    [Theory]
    [InlineData("iTXt", "XML:com.adobe.xmp\0\u0001\0\0\0abc", "XMP: it is compressed, which is not read")]
    [InlineData("zTXt", "Raw profile type xmp\0\0abc",
        "PNG: the profile that ImageMagick made of its EXIF or XMP is not read")]
    [InlineData("tEXt", "Raw profile type APP1\0abc",
        "PNG: the profile that ImageMagick made of its EXIF or XMP is not read")]
    [InlineData("zTXt", "Raw profile type icc\0\0abc", null)]
    [InlineData("tEXt", "Raw profile type ", null)]
    [InlineData("tEXt", "Comment\0exif", null)]
    public void Read_MetadataOfAPngThatAreNotRead_AreNamed(string type, string content, string? fault)
    {
        byte[] png = PngPicture.Encode(new RgbPicture(1, 1, [1, 2, 3]));
        const int AfterHeader = 8 + 12 + 13;
        byte[] text = Encoding.ASCII.GetBytes(content);
        byte[] file =
        [
            .. png.Take(AfterHeader), 0, 0, 0, (byte)text.Length, .. Encoding.ASCII.GetBytes(type), .. text, 0, 0, 0, 0,
            .. png.Skip(AfterHeader),
        ];

        Assert.Equal(fault is null ? [] : [fault], PhotoMetadata.Read(file, "x").Faults);
    }

    // 0 and 1 until EXIF 2.3, all four since EXIF 3.0.
    [Theory]
    [InlineData(0, 430.5)]
    [InlineData(1, -430.5)]
    [InlineData(2, 430.5)]
    [InlineData(3, -430.5)]
    public void Read_AltitudeWithReference_HasItsSign(byte reference, double altitude)
    {
        byte[] exif = PhotoBytes.Exif(
            false, PhotoBytes.First, PhotoBytes.Detail, [(5, reference), (6, PhotoBytes.Rationals(4305, 10))]);

        Assert.Equal(altitude, PhotoMetadata.Read(PhotoBytes.With(exif, null), "x").AltitudeAmslMetres);
    }

    [Fact]
    public void Read_NothingSaid_IsEmpty()
    {
        PhotoMetadata photo = PhotoMetadata.Read(JpegFiles.Read("420.jpg"), "x");

        Assert.Empty(photo.Faults);
        Assert.Null(photo.Make);
        Assert.Null(photo.Taken);
        Assert.Null(photo.LatitudeDegrees);
        Assert.Null(photo.GimbalPitchDegrees);
        Assert.Throws<PictureException>(() => PhotoMetadata.Read([1, 2, 3], "x"));
        Assert.Throws<PictureException>(() => PhotoMetadata.Read([], "x"));
    }

    [Fact]
    public void Read_ValuesThatAreNone_AreFaultsAndTheRestIsThere()
    {
        (int, object)[] gps =
        [
            (1, "N"), (2, PhotoBytes.Rationals(0, 1, 0, 1, 0, 1)), (3, "E"),
            (4, PhotoBytes.Rationals(0, 1, 0, 1, 0, 1)), (6, PhotoBytes.Rationals(5, 0)),
        ];
        (int, object)[] detail = [(0x9003, "0000:00:00 00:00:00"), (0xA405, 0), (0x920A, PhotoBytes.Rationals(1, 0))];
        byte[] file = PhotoBytes.With(
            PhotoBytes.Exif(false, PhotoBytes.First, detail, gps),
            PhotoBytes.Xmp("drone-dji:GimbalYawDegree=\"north\" drone-dji:RelativeAltitude=\"1e9\""));

        PhotoMetadata photo = PhotoMetadata.Read(file, "x");

        Assert.Equal("DJI", photo.Make);
        Assert.Null(photo.LatitudeDegrees);
        Assert.Null(photo.TakenLocal);
        Assert.Null(photo.AltitudeAmslMetres);
        Assert.Null(photo.FocalLengthMillimetres);
        Assert.Null(photo.FocalLength35MillimetreEquivalentMillimetres);
        Assert.Null(photo.GimbalYawDegrees);
        Assert.Equal(
            ["EXIF: its position is 0, 0, as cameras without a fix write it",
             "EXIF: its time is none: 0000:00:00 00:00:00",
             "XMP: GimbalYawDegree is no number of its range", "XMP: RelativeAltitude is no number of its range"],
            photo.Faults.OrderBy(f => f, StringComparer.Ordinal));
    }

    [Fact]
    public void Read_XmpWithEntities_IsRefused()
    {
        byte[] xmp = Encoding.ASCII.GetBytes(
            "http://ns.adobe.com/xap/1.0/\0<!DOCTYPE a [<!ENTITY b \"cccc\">]><a>&b;</a>");

        PhotoMetadata photo = PhotoMetadata.Read(PhotoBytes.With(null, xmp), "x");

        Assert.StartsWith("XMP: ", Assert.Single(photo.Faults), StringComparison.Ordinal);
    }

    [Fact]
    public void Read_Mutations_NeverFail()
    {
        byte[][] files = [PhotoBytes.Drone(), PhotoBytes.Drone(isBig: true)];
        var numbers = new SeededNumbers(3);
        int faults = 0;
        for (int round = 0; round < 4_000; round++)
        {
            byte[] file = (byte[])files[round & 1].Clone();
            for (int left = 1 + numbers.Below(4); left > 0; left--)
                file[2 + numbers.Below(1200)] = (byte)(numbers.Below(4) == 0 ? 0xFF : numbers.Below(256));
            PhotoMetadata photo = PhotoMetadata.Read(file, "seed 3, " + round);
            faults += photo.Faults.Count;
            Assert.True(photo.LatitudeDegrees is null or (>= -90 and <= 90), "seed 3, " + round);
            _ = photo.Taken;
        }

        Assert.True(faults > 500, $"{faults}");
    }
}
