using System;
using Rabit.Geodesy;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>The bytes of tracks between vehicles.</summary>
public sealed class TrackEstimateCodecTests
{
    private static readonly TimeSpan Now = TimeSpan.FromSeconds(100);

    private readonly TrackEstimateCodec _codec = new();
    private readonly byte[] _bytes = new byte[VehicleMessageRoute.MaxLength];

    [Theory]
    [InlineData("car", null)]
    [InlineData("sixteen-letters-", 17)]
    public void Estimate_ThereAndBack_IsTheSame(string name, int? marker)
    {
        TrackEstimate sent = Estimate() with { Class = new TargetClassName(name), MarkerId = marker };
        Assert.True(_codec.TryEncode(sent, Now, _bytes, out int length));
        Assert.Equal(71 + name.Length, length);
        Assert.True(_codec.TryDecode(_bytes.AsSpan(0, length), 1, Now, 3, out TrackEstimate got));

        Assert.Equal(3, got.SourceSystemId);
        Assert.Equal((sent.TrackId, sent.PictureNumber, sent.Time), (got.TrackId, got.PictureNumber, got.Time));
        Assert.Equal((sent.Class, sent.MarkerId), (got.Class, got.MarkerId));
        NedPosition off = LocalNedFrame.IgnoringGeoid(sent.Position).ToNed(got.Position);
        Assert.InRange(Math.Abs(off.North) + Math.Abs(off.East) + Math.Abs(off.Down), 0, 0.02);
        Assert.Equal(sent.VelocityNed.North, got.VelocityNed.North, 0.0051);
        Assert.Equal(sent.VelocityNed.East, got.VelocityNed.East, 0.0051);
        Assert.Equal(sent.Covariance.NorthEast, got.Covariance.NorthEast, 1e-6);
        Assert.Equal(sent.VelocityCovariance.EastEast, got.VelocityCovariance.EastEast, 1e-6);
        Assert.Equal(
            (sent.NorthWithNorthRate, sent.NorthWithEastRate, sent.EastWithNorthRate, sent.EastWithEastRate),
            (got.NorthWithNorthRate, got.NorthWithEastRate, got.EastWithNorthRate, got.EastWithEastRate));
    }

    [Fact]
    public void Decode_CutOrTooLongOrOfAnotherVersion_IsRefused()
    {
        Assert.True(_codec.TryEncode(Estimate(), Now, _bytes, out int length));
        for (int cut = 0; cut < length; cut++)
            Assert.False(_codec.TryDecode(_bytes.AsSpan(0, cut), 1, Now, 3, out _));
        Assert.False(_codec.TryDecode(_bytes.AsSpan(0, length + 1), 1, Now, 3, out _));
        Assert.False(_codec.TryDecode(_bytes.AsSpan(0, length), 0, Now, 3, out _));
    }

    [Fact]
    public void Decode_AnyBytes_IsRefusedOrFinite()
    {
        const int Seed = 12;
        var random = new Random(Seed);
        for (int i = 0; i < 20_000; i++)
        {
            Assert.True(_codec.TryEncode(Estimate(), Now, _bytes, out int length));
            for (int k = random.Next(1, 6); k > 0; k--)
                _bytes[random.Next(length)] = (byte)random.Next(256);
            if (!_codec.TryDecode(_bytes.AsSpan(0, length), 1, Now, 3, out TrackEstimate got))
                continue;
            Assert.True(
                Math.Abs(got.VelocityNed.North) <= 300 && got.Covariance.NorthNorth is > 0 and <= 1e8
                    && got.VelocityCovariance.EastEast is > 0 and <= 1e8
                    && Math.Abs(got.EastWithNorthRate) <= 1e8 && got.TrackId > 0, $"seed {Seed}, {i}");
        }
    }

    [Fact]
    public void Encode_WhatCannotBe_IsRefused()
    {
        Assert.False(CanSend(Estimate() with { TrackId = 0 }));
        Assert.False(CanSend(Estimate() with { Class = TargetClassName.None }));
        Assert.False(CanSend(Estimate() with { Covariance = new HorizontalCovariance(1, 1, 1) }));
        Assert.False(CanSend(Estimate() with { VelocityCovariance = new HorizontalCovariance(double.NaN, 0, 1) }));
        Assert.False(CanSend(Estimate() with { NorthWithEastRate = double.NaN }));
        Assert.False(CanSend(Estimate() with { VelocityNed = new NedVector(400, 0, 0) }));
        Assert.False(CanSend(Estimate() with { Time = Now - TimeSpan.FromSeconds(700) }));
        Assert.True(CanSend(Estimate()));
    }

    private bool CanSend(TrackEstimate estimate) => _codec.TryEncode(estimate, Now, _bytes, out _);

    private static TrackEstimate Estimate() => new()
    {
        TrackId = 70_001,
        PictureNumber = 4_000_000_000,
        Time = Now - TimeSpan.FromMilliseconds(12_345),
        Position = GeodeticPosition.FromDegrees(-35.36, 149.16, 583.25),
        VelocityNed = new NedVector(-7.25, 3.5, 0),
        Covariance = new HorizontalCovariance(2, 0.5, 3),
        VelocityCovariance = new HorizontalCovariance(0.5, -0.125, 0.75),
        NorthWithNorthRate = 0.25,
        NorthWithEastRate = -0.125,
        EastWithNorthRate = 0.0625,
        EastWithEastRate = 0.375,
        Class = new TargetClassName("car"),
    };
}
