using System;
using System.IO;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Geodesy.Tests;
using Rabit.Vision;
using Rabit.Vision.Tests.Jpeg;
using Rabit.Vision.Tests.Metadata;
using Xunit;

namespace Rabit.Tool.Tests.Geolocate;

public sealed class PhotoTests : IDisposable
{
    private const double Latitude = 46 + (50 / 60.0) + (33.3855 / 3600);
    private const double Longitude = -(91 + (59 / 60.0) + (40.4156 / 3600));
    private static readonly double FocalPixels = 61 / 36.0 * 20;

    private readonly GeolocateFiles _run = new();

    public void Dispose() => _run.Dispose();

    // The camera looks down by 89.9 degrees to the northeast, its roll is 0.1, 39.8 m above the ground.
    [Theory]
    [InlineData(30, 21, 0)]
    [InlineData(50, 21, 135)]
    [InlineData(30, 1, 45)]
    public void Photo_ByItself_GivesThePlace(double column, double row, double azimuthDegrees)
    {
        string photo = Write("a.jpg", PhotoBytes.Drone());

        Assert.Equal(0, _run.Run(photo, "--pixel", FormattableString.Invariant($"{column},{row}"), "--json"));

        double metres = Math.Max(Math.Abs(column - 30), Math.Abs(row - 21)) / FocalPixels * 39.8;
        NedPosition place = PlaceFromCamera();
        Assert.Equal(metres * Math.Cos(azimuthDegrees * Vectors.Degree), place.North, 0.2);
        Assert.Equal(metres * Math.Sin(azimuthDegrees * Vectors.Degree), place.East, 0.2);
        Assert.Equal(-198.309 - 39.8, _run.Json.Number("altitudeAmslMetres"), 3);
        Assert.InRange(_run.Json.Number("ellipse95HalfMajorAxisMetres"), 2, 6);
    }

    // A point 10 m east of the camera is 10 pixels right of the principal point, which a lens moves outwards.
    [Fact]
    public void Photo_PngWithACalibratedLens_GivesThePlaceThroughTheLens()
    {
        var lens = new PhotoLens { FocalX = 100, FocalY = 100, CentreOffsetX = 4, CentreOffsetY = -6, K1 = 0.5 };
        byte[] png = StraightDown(122, 86, focalLengthPixels: null, lens);
        string photo = Write("lens.png", png);
        const double Column = 30 + 2 + (50 * 0.2 * (1 + (0.5 * 0.2 * 0.2)));

        Assert.Equal(0, _run.Run(photo, "--pixel", FormattableString.Invariant($"{Column},18"), "--json"));

        NedPosition place = PlaceFromCamera();
        Assert.Equal(0, place.North, 0.01);
        Assert.Equal(10, place.East, 0.01);
    }

    // As a program of one's own writes it: the focal length in pixels is of the size that the picture had.
    [Theory]
    [InlineData(61, 43)]
    [InlineData(122, 86)]
    public void Photo_PngWithMetadata_GivesThePlace(int takenWidth, int takenHeight)
    {
        byte[] png = StraightDown(takenWidth, takenHeight, 50 * takenWidth / 61.0, lens: null);

        Assert.Equal(0, _run.Run(Write("a.png", png), "--pixel", "60,21", "--json"));

        NedPosition place = PlaceFromCamera();
        Assert.Equal(0, place.North, 0.01);
        Assert.Equal(30, place.East, 0.01);
        Assert.Equal(490, _run.Json.Number("altitudeAmslMetres"), 3);
    }

    [Fact]
    public void Photo_Turned_GivesThePlaceOfTheOppositePixel()
    {
        string photo = Write("a.jpg", PhotoBytes.Drone());

        Assert.Equal(0, _run.Run(photo, "--pixel", "10", "41", "--turned", "--json"));
        GeodeticPosition turned = _run.Place;
        Assert.Equal(0, _run.Run(photo, "--pixel", "50", "1", "--json"));

        Assert.Equal(turned, _run.Place);
    }

    [Fact]
    public void Photo_SeveralPixelsTurned_GivesEachPlaceWithItsPixel()
    {
        string photo = Write("a.jpg", PhotoBytes.Drone());
        Assert.Equal(0, _run.Run(photo, "--pixel", "50", "1", "--json"));
        GeodeticPosition place = _run.Place;

        Assert.Equal(
            1, _run.Run(photo, "--pixel", "10", "41", "--pixel", "61,1", "--pixel", "10,41", "--turned", "--json"));

        Assert.Equal(3, _run.Json.GetArrayLength());
        Assert.Equal([10, 41], _run.Json[0].Numbers("pixel"));
        Assert.Equal(place.Latitude.Degrees, _run.Json[0].Number("latitudeDegrees"), 1e-9);
        Assert.Equal(place.Longitude.Degrees, _run.Json[2].Number("longitudeDegrees"), 1e-9);
        Assert.Equal("OutsidePicture", _run.Json[1].Text("reason"));
    }

    [Fact]
    public void Photo_WithOptions_TakesThemInstead()
    {
        string photo = Write("a.jpg", PhotoBytes.Drone());

        Assert.Equal(0, _run.Run(
            photo, "--pixel", "60,21", "--json", "--height", "100", "--camera-roll", "0", "--camera-pitch", "-90",
            "--camera-yaw", "0", "--sensor-width", "6.1", "--focal-length", "6.1"));

        NedPosition place = PlaceFromCamera();
        Assert.Equal(0, place.North, 0.01);
        Assert.Equal(30 / 61.0 * 100, place.East, 0.01);
    }

    [Fact]
    public void Photo_ThatSaysNothing_NamesAllThatIsMissing()
    {
        string photo = Write("a.JPEG", JpegFiles.Read("420.jpg"));

        Assert.Equal(2, _run.Run(photo, "--pixel", "1,1"));

        Assert.Contains(
            "a.JPEG does not say its latitude (--latitude), its longitude (--longitude), its altitude (--altitude), its "
            + "height above the ground (--height or --ground-altitude), the pitch of its camera (--camera-pitch), the yaw "
            + "of its camera (--camera-yaw), its focal length (--focal-length-35mm, or --focal-length and "
            + "--sensor-width).", _run.Errors, StringComparison.Ordinal);
    }

    // A download that broke off: within its EXIF, or before the segment that has its size.
    [Theory]
    [InlineData("EXIF")]
    [InlineData("size")]
    public void Photo_CutOff_NamesAllThatIsMissingAndWhy(string where)
    {
        byte[] whole = PhotoBytes.Drone();
        int frame = Enumerable.Range(0, whole.Length - 1).Last(at => whole[at] == 0xFF && whole[at + 1] == 0xC0);
        string photo = Write("a.jpg", [.. whole.Take(where == "EXIF" ? 100 : frame + 4)]);

        Assert.Equal(2, _run.Run(photo, "--pixel", "1,1"));

        string missing = where == "EXIF" ? "its latitude (--latitude), its longitude (--longitude), " : "its size";
        Assert.StartsWith($"{photo} does not say {missing}", _run.Errors, StringComparison.Ordinal);
        Assert.Contains("its size", _run.Errors, StringComparison.Ordinal);
        Assert.EndsWith(
            ". What was not understood: JPEG: it is cut off before its pixels.", _run.Errors.TrimEnd(),
            StringComparison.Ordinal);
    }

    // One photo has one pose: there is none between samples, and no clock by which it was taken.
    [Fact]
    public void Photo_Answer_LeavesOutWhatIsOfTelemetry()
    {
        string photo = Write("a.jpg", PhotoBytes.Drone());

        Assert.Equal(0, _run.Run(photo, "--pixel", "30,21"));
        Assert.DoesNotContain("pose", _run.Output, StringComparison.Ordinal);
        Assert.EndsWith(" m", _run.Output.TrimEnd(), StringComparison.Ordinal);
        Assert.Equal(0, _run.Run(photo, "--pixel", "30,21", "--json"));
        Assert.False(_run.Json.TryGetProperty("timeSeconds", out _));
        Assert.False(_run.Json.TryGetProperty("extrapolatedSeconds", out _));
    }

    [Fact]
    public void Photo_WrongUse_IsNamed()
    {
        string photo = Write("a.jpg", PhotoBytes.Drone());
        string camera = _run.File("camera.json", GeolocateFiles.Camera);

        AssertRefused("--pixel is missing", photo);
        AssertRefused("is a photo, which needs no request.json", photo, "request.json", "--pixel", "1,1");
        AssertRefused("--height is for a photo", camera, "--height", "5");
        AssertRefused("--turned is for a photo", camera, "--turned");
        AssertRefused("'x' is not a number", photo, "--pixel", "1,x");
        AssertRefused("--height is NaN, which is not finite", photo, "--pixel", "1,1", "--height", "NaN");
        AssertRefused("that is no JPEG", Write("b.jpg", [1, 2, 3]), "--pixel", "1,1");
        Assert.Equal(1, _run.Run(photo, "--pixel", "61,1"));
        Assert.StartsWith("refused: OutsidePicture", _run.Output, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--latitude", "95", "-90 to 90 degrees")]
    [InlineData("--longitude", "400", "-180 to 180 degrees")]
    [InlineData("--altitude", "-1001", "-1000 to 100000 metres")]
    [InlineData("--height", "1e9", "0 to 100000 metres")]
    [InlineData("--height", "-5", "0 to 100000 metres")]
    [InlineData("--ground-altitude", "1e4000", "")]
    [InlineData("--ground-altitude", "10001", "-1000 to 10000 metres")]
    [InlineData("--camera-roll", "-181", "-180 to 180 degrees")]
    [InlineData("--camera-pitch", "1000", "-180 to 180 degrees")]
    [InlineData("--camera-yaw", "361", "-360 to 360 degrees")]
    [InlineData("--focal-length", "0", "0.1 to 10000 millimetres")]
    [InlineData("--sensor-width", "1e-300", "0.1 to 1000 millimetres")]
    [InlineData("--focal-length-35mm", "0", "1 to 10000 millimetres")]
    [InlineData("--focal-length-35mm", "1e9", "1 to 10000 millimetres")]
    public void Photo_OptionOutOfItsRange_IsNamedWithTheRange(string option, string value, string range)
    {
        string photo = Write("a.jpg", PhotoBytes.Drone());

        Assert.Equal(2, _run.Run(photo, "--pixel", "1,1", option, value));

        Assert.StartsWith(
            range.Length == 0 ? option : $"{option} is {value}; it must be {range}.", _run.Errors,
            StringComparison.Ordinal);
        Assert.Single(_run.Errors.TrimEnd().Split('\n'));
        Assert.Empty(_run.Output);
    }

    [Theory]
    [InlineData("--latitude", "-90")]
    [InlineData("--longitude", "180")]
    [InlineData("--camera-pitch", "-90")]
    [InlineData("--camera-yaw", "360")]
    [InlineData("--height", "100000")]
    public void Photo_OptionAtTheEndOfItsRange_IsTaken(string option, string value)
        => Assert.Equal(0, _run.Run(Write("a.jpg", PhotoBytes.Drone()), "--pixel", "30,21", option, value));

    [Theory]
    [InlineData(1, false)]
    [InlineData(2, true)]
    [InlineData(6, true)]
    [InlineData(8, true)]
    [InlineData(9, false)]
    public void Photo_ThatViewersShowTurned_IsLocatedAsItIsStoredWithAWarning(int orientation, bool isWarned)
    {
        (int, object)[] first = [.. PhotoBytes.First.Where(t => t.Tag != 0x112), (0x112, orientation)];
        byte[] exif = PhotoBytes.Exif(isBig: false, first, PhotoBytes.Detail, PhotoBytes.Gps);
        string photo = Write("turned.jpg", PhotoBytes.With(exif, PhotoBytes.Xmp(PhotoBytes.DroneXmp)));
        Assert.Equal(0, _run.Run(Write("a.jpg", PhotoBytes.Drone()), "--pixel", "50,1", "--json"));
        string upright = _run.Output;
        Assert.Empty(_run.Errors);

        Assert.Equal(0, _run.Run(photo, "--pixel", "50,1", "--json"));

        Assert.Equal(upright, _run.Output);
        Assert.Equal(
            isWarned
                ? $"{photo}: viewers show it turned (EXIF orientation {orientation}); pixels are those of the stored "
                    + "picture, before it is turned"
                : "",
            _run.Errors.TrimEnd());
    }

    [Fact]
    public void Photo_OptionsThatMakeNoSenseTogether_AreNamed()
    {
        string photo = Write("a.jpg", PhotoBytes.Drone());

        AssertRefused(
            "--height and --ground-altitude exclude each other: both say where the ground is.",
            photo, "--pixel", "1,1", "--height", "50", "--ground-altitude", "40");
        AssertRefused("--focal-length needs --sensor-width.", photo, "--pixel", "1,1", "--focal-length", "4.5");
        AssertRefused(
            "--focal-length-35mm and --sensor-width exclude each other: both say what the focal length is.",
            photo, "--pixel", "1,1", "--focal-length-35mm", "20", "--sensor-width", "6.17");
        foreach (string height in (string[])["--height", "--ground-altitude"])
            AssertRefused(
                $"{height} and --terrain exclude each other: both say where the ground is.",
                photo, "--pixel", "1,1", height, "50", "--terrain", "dem.asc");
    }

    // Of 61 x 43 pixels, from 50 m above the ground, north up.
    private static byte[] StraightDown(int takenWidth, int takenHeight, double? focalLengthPixels, PhotoLens? lens)
        => PngPicture.Encode(
            new RgbPicture(61, 43, new byte[61 * 43 * 3]),
            new PhotoMetadata
            {
                LatitudeDegrees = Latitude,
                LongitudeDegrees = Longitude,
                AltitudeAmslMetres = 540,
                RelativeAltitudeMetres = 50,
                GimbalPitchDegrees = -90,
                GimbalYawDegrees = 0,
                GimbalRollDegrees = 0,
                PixelWidth = takenWidth,
                PixelHeight = takenHeight,
                FocalLengthPixels = focalLengthPixels,
                Lens = lens,
            });

    private void AssertRefused(string reason, params string[] arguments)
    {
        Assert.Equal(2, _run.Run(arguments));
        Assert.Contains(reason, _run.Errors, StringComparison.Ordinal);
    }

    private NedPosition PlaceFromCamera()
        => LocalNedFrame.IgnoringGeoid(GeodeticPosition.FromDegrees(Latitude, Longitude, -198.309 - 39.8))
            .ToNed(_run.Place);

    private string Write(string name, byte[] bytes)
    {
        string path = _run.PathOf(name);
        File.WriteAllBytes(path, bytes);
        return path;
    }
}
