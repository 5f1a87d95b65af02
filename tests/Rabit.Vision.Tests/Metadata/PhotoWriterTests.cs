using System;
using System.Linq;
using Xunit;

namespace Rabit.Vision.Tests.Metadata;

/// <summary>What is written into a PNG is read again.</summary>
public sealed class PhotoWriterTests
{
    [Theory]
    [InlineData(null, 1_234_560, 10)]
    [InlineData(10_000_000L, 0, 10_000_000)]
    [InlineData(100_000L, 1_200_000, 100_000)]
    public void Encode_TimeAndExposure_AreReadAgainToTheirResolution(long? resolution, long fraction, long expected)
    {
        var taken = new DateTime(2026, 3, 4, 5, 6, 7);
        var written = new PhotoMetadata
        {
            TakenLocal = taken.AddTicks(1_234_560),
            TakenResolution = resolution is { } ticks ? TimeSpan.FromTicks(ticks) : null,
            ExposureTime = TimeSpan.FromTicks(12_500),
        };

        PhotoMetadata read = PhotoMetadata.Read(
            PngPicture.Encode(Pictures.SamplePictures.Random(4, 5, seed: 1), written), "x");

        Assert.Equal(taken.AddTicks(fraction), read.TakenLocal);
        Assert.Equal(TimeSpan.FromTicks(expected), read.TakenResolution);
        Assert.Equal(TimeSpan.FromTicks(12_500), read.ExposureTime);
    }

    [Fact]
    public void ReadHead_FileLongerThanWhatIsRead_IsReadUpToItsPixels()
    {
        using var folder = new Pictures.SamplePictures.TemporaryFolder();
        string file = folder.File("photo.jpg");
        System.IO.File.WriteAllBytes(file, [.. PhotoBytes.Drone(), .. new byte[400_000]]);

        PhotoMetadata photo = PhotoMetadata.ReadHead(file);

        Assert.Empty(photo.Faults);
        Assert.Equal("FC300S", photo.Model);
        Assert.Contains(
            "no such file",
            Assert.Throws<PictureException>(() => PhotoMetadata.ReadHead(folder.File("other.jpg"))).Message,
            StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(47.12345678, 8.98765432, 512.345)]
    [InlineData(-0.00001234, -179.99999, -12.5)]
    [InlineData(89.99999999, 0.5, 0)]
    public void Encode_Metadata_IsReadAgain(double latitude, double longitude, double altitude)
    {
        var taken = new DateTime(2026, 3, 4, 5, 6, 7).AddTicks(1_234_560);
        var written = new PhotoMetadata
        {
            Make = "Rabit",
            Model = "nadir",
            TakenLocal = taken,
            UtcOffset = TimeSpan.Zero,
            PositionTimeUtc = new DateTimeOffset(taken, TimeSpan.Zero),
            PixelWidth = 4,
            PixelHeight = 5,
            LatitudeDegrees = latitude,
            LongitudeDegrees = longitude,
            AltitudeAmslMetres = altitude,
            AbsoluteAltitudeMetres = altitude,
            RelativeAltitudeMetres = 41.25,
            ImageDirectionDegrees = 12.5,
            FocalLengthPixels = 531.4567,
            FocalLengthMillimetres = 4.25,
            FocalLength35MillimetreEquivalentMillimetres = 30,
            GimbalRollDegrees = -0.125,
            GimbalPitchDegrees = -89.5,
            GimbalYawDegrees = 179.25,
            FlightRollDegrees = 3,
            FlightPitchDegrees = -4,
            FlightYawDegrees = -170.5,
        };
        RgbPicture picture = Pictures.SamplePictures.Random(4, 5, seed: 1);

        byte[] file = PngPicture.Encode(picture, written);
        PhotoMetadata read = PhotoMetadata.Read(file, "x");

        Assert.Equal(picture.Pixels, PngPicture.Decode(file, "x").Pixels);
        Assert.Empty(read.Faults);
        Assert.Equal((4, 5, 4, 5), (read.Width, read.Height, read.PixelWidth, read.PixelHeight));
        Assert.Equal(("Rabit", "nadir", new DateTimeOffset(taken, TimeSpan.Zero)), (read.Make, read.Model, read.Taken));
        Assert.Equal(latitude, read.LatitudeDegrees!.Value, 1e-11);
        Assert.Equal(longitude, read.LongitudeDegrees!.Value, 1e-11);
        Assert.Equal(altitude, read.AltitudeAmslMetres!.Value, 1e-5);
        Assert.InRange(
            (read.PositionTimeUtc!.Value - written.PositionTimeUtc.Value).Duration(), TimeSpan.Zero,
            TimeSpan.FromMilliseconds(1));
        Assert.Equal(
            [altitude, 41.25, 12.5, 531.4567, 4.25, 30, -0.125, -89.5, 179.25, 3, -4, -170.5],
            new[]
            {
                read.AbsoluteAltitudeMetres, read.RelativeAltitudeMetres, read.ImageDirectionDegrees,
                read.FocalLengthPixels, read.FocalLengthMillimetres,
                read.FocalLength35MillimetreEquivalentMillimetres, read.GimbalRollDegrees, read.GimbalPitchDegrees,
                read.GimbalYawDegrees, read.FlightRollDegrees, read.FlightPitchDegrees, read.FlightYawDegrees,
            }.Select(n => Math.Round(n!.Value, 5)));
    }

    [Fact]
    public void Encode_WhatIsNoNumberOrOutOfItsRange_IsLeftOut()
    {
        PhotoMetadata[] none =
        [
            new() { LatitudeDegrees = double.NaN, LongitudeDegrees = 5 },
            new() { LatitudeDegrees = 91, LongitudeDegrees = 5 },
            new() { LatitudeDegrees = 5, LongitudeDegrees = -180.001 },
            new() { AltitudeAmslMetres = double.PositiveInfinity, ImageDirectionDegrees = double.NaN },
            new() { TakenLocal = DateTime.MinValue, ExposureTime = TimeSpan.MaxValue, Orientation = 9 },
            new() { TakenLocal = DateTime.MaxValue, ExposureTime = TimeSpan.FromSeconds(-1), PixelWidth = -5 },
            new() { FocalLengthMillimetres = -3, FocalLength35MillimetreEquivalentMillimetres = double.NaN },
            new() { GimbalPitchDegrees = double.NegativeInfinity, GimbalYawDegrees = 1e300 },
            new() { RelativeAltitudeMetres = double.NaN, AbsoluteAltitudeMetres = 1e20, FocalLengthPixels = 1e7 },
            new() { Lens = new PhotoLens { FocalX = double.NaN, FocalY = 1 } },
        ];
        foreach (PhotoMetadata photo in none)
        {
            PhotoMetadata read = PhotoMetadata.Read(
                PngPicture.Encode(Pictures.SamplePictures.Random(4, 5, seed: 1), photo), "x");

            Assert.Empty(read.Faults);
            Assert.All(
                new double?[]
                {
                    read.LatitudeDegrees, read.LongitudeDegrees, read.AltitudeAmslMetres, read.ImageDirectionDegrees,
                    read.FocalLengthMillimetres, read.FocalLength35MillimetreEquivalentMillimetres,
                    read.GimbalPitchDegrees, read.GimbalYawDegrees, read.RelativeAltitudeMetres,
                    read.AbsoluteAltitudeMetres, read.FocalLengthPixels, read.Orientation, read.PixelWidth,
                    read.ExposureTime?.TotalSeconds,
                },
                number => Assert.Null(number));
            Assert.Equal((null, null), (read.TakenLocal, read.Lens));
        }
    }

    [Theory]
    [InlineData(-10, 350)]
    [InlineData(725.5, 5.5)]
    [InlineData(360, 0)]
    public void Encode_DirectionOfAnyTurn_IsThatFromNorth(double direction, double expected)
    {
        byte[] file = PngPicture.Encode(
            Pictures.SamplePictures.Random(4, 5, seed: 1), new PhotoMetadata { ImageDirectionDegrees = direction });

        Assert.Equal(expected, PhotoMetadata.Read(file, "x").ImageDirectionDegrees!.Value, 6);
    }

    [Fact]
    public void Encode_NothingKnown_SaysNothing()
    {
        PhotoMetadata read = PhotoMetadata.Read(
            PngPicture.Encode(Pictures.SamplePictures.Random(4, 5, seed: 1), new PhotoMetadata()), "x");

        Assert.Empty(read.Faults);
        Assert.Equal((null, null, null, null), (read.Make, read.Taken, read.LatitudeDegrees, read.GimbalYawDegrees));
    }

    [Fact]
    public void Read_PngCutOrChanged_EndsWithoutCrash()
    {
        const int Seed = 4;
        var random = new Random(Seed);
        byte[] file = PngPicture.Encode(
            Pictures.SamplePictures.Random(4, 5, seed: 1),
            new PhotoMetadata { Make = "Rabit", LatitudeDegrees = 1, LongitudeDegrees = 2, GimbalYawDegrees = 3 });
        for (int at = 8; at < file.Length; at++)
        {
            Assert.NotNull(PhotoMetadata.Read(file.Take(at).ToArray(), "x"));
            byte[] changed = (byte[])file.Clone();
            changed[at] = (byte)random.Next(256);
            Assert.NotNull(PhotoMetadata.Read(changed, "x"));
        }
    }
}
