using System;
using Rabit.Geodesy;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>Target reports as bytes.</summary>
public sealed class TargetReportCodecTests
{
    private static readonly TargetReportCodec Codec = new();
    private static readonly TimeSpan Now = TimeSpan.FromSeconds(1000);

    [Fact]
    public void RoundTrip_RandomReports_AreTheSameWithinTheForm()
    {
        const int Seed = 21;
        var random = new Random(Seed);
        var buffer = new byte[VehicleMessageRoute.MaxLength];
        for (int i = 0; i < 10_000; i++)
        {
            double nn = 0.01 + (random.NextDouble() * 100);
            double ee = 0.01 + (random.NextDouble() * 100);
            var report = new TargetReport
            {
                SourceSystemId = 200,
                PictureNumber = random.Next(),
                Index = random.Next(256),
                Time = Now - TimeSpan.FromSeconds(random.NextDouble() * 600),
                Position = GeodeticPosition.FromRadians(
                    (random.NextDouble() - 0.5) * Math.PI, (random.NextDouble() - 0.5) * 2 * Math.PI,
                    (random.NextDouble() * 9000) - 400),
                Covariance = new HorizontalCovariance(
                    nn, Math.Sqrt(nn * ee) * ((random.NextDouble() * 1.9) - 0.95), ee),
                SystematicCovariance = i % 3 == 0 ? default : new HorizontalCovariance(ee, 0, nn),
                Class = RandomName(random),
                MarkerId = i % 2 == 0 ? null : random.Next(65535),
                Score = random.NextDouble(),
                SizeMetres = random.NextDouble() * 60,
                CentreX = random.NextDouble() * 640,
                CentreY = random.NextDouble() * 480,
            };
            Assert.True(Codec.TryEncode(report, Now, buffer, out int length), $"seed {Seed}, report {i}");
            Assert.Equal(60 + report.Class.Length, length);
            Assert.True(
                Codec.TryDecode(buffer.AsSpan(0, length), 3, Now + TimeSpan.FromSeconds(5), 7, out TargetReport back),
                $"seed {Seed}, report {i}");
            AssertEqual(report, back);
        }
    }

    [Fact]
    public void Decode_RandomBytes_NeverThrowsAndWhatItTakesIsValid()
    {
        const int Seed = 22;
        var random = new Random(Seed);
        for (int i = 0; i < 200_000; i++)
        {
            var bytes = new byte[i % 4 == 0
                ? random.Next(129)
                : random.Next(TargetReportCodec.MinLength, TargetReportCodec.MaxLength + 1)];
            random.NextBytes(bytes);
            if (bytes.Length > 1 && i % 2 == 0)
                (bytes[0], bytes[1]) = (3, (byte)(bytes.Length - 60));
            if (Codec.TryDecode(bytes, 3, Now, 7, out TargetReport report))
                AssertValid(report, $"seed {Seed}, case {i}");
        }
    }

    [Fact]
    public void Decode_MutatedReports_NeverThrowAndWhatIsTakenIsValid()
    {
        const int Seed = 23;
        var random = new Random(Seed);
        var good = new byte[VehicleMessageRoute.MaxLength];
        Codec.TryEncode(VehicleMessageTests.Report(picture: 3), TimeSpan.Zero, good, out int length);
        int taken = 0;
        for (int i = 0; i < 200_000; i++)
        {
            byte[] bytes = good.AsSpan(0, length).ToArray();
            for (int n = random.Next(1, 5); n > 0; n--)
                bytes[random.Next(length)] = (byte)random.Next(256);
            if (!Codec.TryDecode(bytes, 3, Now, 7, out TargetReport report))
                continue;
            taken++;
            AssertValid(report, $"seed {Seed}, case {i}");
        }

        Assert.InRange(taken, 10_000, 190_000);
    }

    [Theory]
    [InlineData(0, 1)]      // the version with colours
    [InlineData(0, 2)]      // the version without markers
    [InlineData(0, 4)]      // a version to come
    [InlineData(1, 0)]      // no class
    [InlineData(1, 2)]      // a shorter name than there are bytes
    [InlineData(1, 255)]    // a longer one
    [InlineData(60, 0)]     // no character
    [InlineData(60, 32)]    // a space in front
    [InlineData(61, 200)]   // not ASCII
    [InlineData(11, 255)]   // an age of months
    [InlineData(15, 127)]   // beyond the pole
    public void Decode_OneWrongByte_IsRefused(int offset, byte value)
    {
        var bytes = new byte[VehicleMessageRoute.MaxLength];
        Codec.TryEncode(VehicleMessageTests.Report(picture: 3), TimeSpan.Zero, bytes, out int length);
        Assert.True(Codec.TryDecode(bytes.AsSpan(0, length), 3, Now, 7, out _));
        Assert.False(Codec.TryDecode(bytes.AsSpan(0, length - 1), 3, Now, 7, out _));
        Assert.False(Codec.TryDecode(bytes.AsSpan(0, length + 1), 3, Now, 7, out _));
        bytes[offset] = value;
        Assert.False(Codec.TryDecode(bytes.AsSpan(0, length), 3, Now, 7, out _));
    }

    [Fact]
    public void Encode_WhatDoesNotFit_IsRefused()
    {
        TargetReport good = VehicleMessageTests.Report(picture: 1);
        Assert.True(Encodes(good));
        Assert.False(Encodes(good with { Class = TargetClassName.None }));
        Assert.False(Encodes(good with { Index = 256 }));
        Assert.False(Encodes(good with { PictureNumber = -1 }));
        Assert.False(Encodes(good with { Score = double.NaN }));
        Assert.False(Encodes(good with { SizeMetres = 70 }));
        Assert.False(Encodes(good with { CentreX = double.NaN }));
        Assert.False(Encodes(good with { Covariance = default }));
        Assert.False(Encodes(good with { Covariance = new HorizontalCovariance(1, 2, 1) }));
        Assert.False(Encodes(good with { Covariance = new HorizontalCovariance(double.NaN, 0, 1) }));
        Assert.False(Encodes(good with { SystematicCovariance = new HorizontalCovariance(-1, 0, 1) }));
        Assert.False(Encodes(good with { MarkerId = -1 }));
        Assert.False(Encodes(good with { MarkerId = 65535 }));
        Assert.True(Encodes(good with { MarkerId = 65534 }));
        Assert.False(Encodes(good with { Position = default }));
        Assert.False(Encodes(good with { Position = GeodeticPosition.FromRadians(double.NaN, 0, 0) }));
        Assert.False(Encodes(good with { Time = TimeSpan.FromHours(-1) }));
        Assert.False(Codec.TryEncode(good, TimeSpan.Zero, new byte[59 + good.Class.Length], out _));
    }

    [Fact]
    public void Decode_OldFormWithAColour_IsRefused()
    {
        // Version 1 had 58 bytes, with the flag of one of five colours in the second.
        var bytes = new byte[VehicleMessageRoute.MaxLength];
        Codec.TryEncode(VehicleMessageTests.Report(picture: 3), TimeSpan.Zero, bytes, out _);
        (bytes[0], bytes[1]) = (1, 1);
        Assert.False(Codec.TryDecode(bytes.AsSpan(0, 58), 3, Now, 7, out _));
    }

    [Fact]
    public void RoundTrip_ClassThatIsNotDeclaredHere_KeepsItsName()
    {
        var bytes = new byte[VehicleMessageRoute.MaxLength];
        TargetReport report = VehicleMessageTests.Report(picture: 3) with
        {
            Class = new TargetClassName("Canis lupus fam.")
        };
        Assert.True(Codec.TryEncode(report, TimeSpan.Zero, bytes, out int length));
        Assert.Equal(TargetReportCodec.MaxLength, length);
        Assert.True(Codec.TryDecode(bytes.AsSpan(0, length), 3, Now, 7, out TargetReport back));
        Assert.Equal("Canis lupus fam.", back.Class.ToString());
    }

    private static TargetClassName RandomName(Random random)
    {
        var name = new byte[random.Next(1, TargetClassName.MaxLength + 1)];
        for (int i = 0; i < name.Length; i++)
            name[i] = (byte)random.Next(' ' + 1, '~' + 1);
        Assert.True(TargetClassName.TryRead(name, out TargetClassName read));
        return read;
    }

    private static bool Encodes(in TargetReport report) => Codec.TryEncode(report, TimeSpan.Zero, new byte[128], out _);

    private static void AssertValid(in TargetReport report, string what)
    {
        Assert.True(Math.Abs(report.Position.Latitude.Radians) <= (Math.PI / 2) + 1e-9, what);
        Assert.True(Math.Abs(report.Position.Longitude.Radians) <= Math.PI + 1e-9, what);
        Assert.True(report.Covariance.HalfMajorAxis95Metres is > 0 and < 1e6, what);
        Assert.False(double.IsNaN(report.SystematicCovariance.HalfMajorAxis95Metres), what);
        Assert.False(double.IsNaN(report.CentreX) || double.IsInfinity(report.CentreY), what);
        Assert.InRange(report.Score, 0, 1);
        Assert.Equal(7, report.SourceSystemId);
    }

    private static void AssertEqual(in TargetReport expected, in TargetReport actual)
    {
        Assert.Equal(
            (7, expected.PictureNumber, expected.Index, expected.Class, expected.MarkerId),
            (actual.SourceSystemId, actual.PictureNumber, actual.Index, actual.Class, actual.MarkerId));
        Assert.Equal(expected.Time.TotalSeconds + 5, actual.Time.TotalSeconds, 0.0006);
        Assert.Equal(expected.Position.Latitude.Radians, actual.Position.Latitude.Radians, 1e-9);
        Assert.Equal(expected.Position.Longitude.Radians, actual.Position.Longitude.Radians, 1e-9);
        Assert.Equal(expected.Position.AltitudeAmslMetres, actual.Position.AltitudeAmslMetres, 0.0006);
        AssertEqual(expected.Covariance, actual.Covariance);
        AssertEqual(expected.SystematicCovariance, actual.SystematicCovariance);
        Assert.Equal(expected.Score, actual.Score, 0.002);
        Assert.Equal(expected.SizeMetres, actual.SizeMetres, 0.0006);
        Assert.Equal(expected.CentreX, actual.CentreX, 1e-4);
        Assert.Equal(expected.CentreY, actual.CentreY, 1e-4);
    }

    private static void AssertEqual(HorizontalCovariance expected, HorizontalCovariance actual)
    {
        Assert.Equal(expected.NorthNorth, actual.NorthNorth, 1e-4);
        Assert.Equal(expected.NorthEast, actual.NorthEast, 1e-4);
        Assert.Equal(expected.EastEast, actual.EastEast, 1e-4);
    }
}
