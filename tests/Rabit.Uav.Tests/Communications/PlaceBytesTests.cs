using System;
using System.Buffers.Binary;
using Rabit.Geodesy;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>A place in messages between vehicles: what is out of range is refused wherever it stands.</summary>
public sealed class PlaceBytesTests
{
    private static readonly GeodeticPosition Place = GeodeticPosition.FromDegrees(47.3977, -122.5456, 0);

    [Fact]
    public void Read_WhatWasWritten_IsThePlaceToACentimetre()
    {
        var bytes = new byte[PlaceBytes.Length];
        PlaceBytes.Write(bytes, Place);

        GeodeticPosition read = PlaceBytes.Read(bytes, altitudeAmslMetres: 12);

        Assert.Equal(Place.Latitude.Degrees, read.Latitude.Degrees, 7);
        Assert.Equal(Place.Longitude.Degrees, read.Longitude.Degrees, 7);
        Assert.Equal(12, read.AltitudeAmslMetres);
    }

    [Theory]
    [InlineData(900_000_001, 0)]
    [InlineData(-900_000_001, 0)]
    [InlineData(int.MaxValue, 0)]
    [InlineData(0, 1_800_000_100)]
    [InlineData(0, int.MinValue)]
    public void TryDecode_PlaceOutOfRange_IsRefused(int latitude, int longitude)
    {
        var follow = new FollowTask
        {
            Finder = 1,
            Decider = 1,
            Decision = 1,
            Class = DefaultTargetClasses.Red,
            Position = Place,
        };
        var validation = new ValidationTask { Class = DefaultTargetClasses.Red, Position = Place };

        AssertRefused(new FollowTaskCodec(), follow, 11, latitude, longitude);
        AssertRefused(new ValidationTaskCodec(), validation, 10, latitude, longitude);
    }

    // The same bytes are taken before the place is made wrong.
    private static void AssertRefused<T>(
        IVehicleMessageCodec<T> codec, in T content, int offset, int latitude, int longitude)
        where T : struct
    {
        var bytes = new byte[VehicleMessageRoute.MaxLength];
        Assert.True(codec.TryEncode(content, TimeSpan.Zero, bytes, out int length));
        Span<byte> message = bytes.AsSpan(0, length);
        Assert.True(codec.TryDecode(message, codec.Version, TimeSpan.Zero, sourceSystemId: 2, out _));
        BinaryPrimitives.WriteInt32LittleEndian(message.Slice(offset), latitude);
        BinaryPrimitives.WriteInt32LittleEndian(message.Slice(offset + 4), longitude);
        Assert.False(codec.TryDecode(message, codec.Version, TimeSpan.Zero, sourceSystemId: 2, out _));
    }
}
