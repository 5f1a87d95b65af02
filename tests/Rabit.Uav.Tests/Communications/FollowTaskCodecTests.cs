using System;
using Rabit.Geodesy;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>Targets that are followed, as bytes.</summary>
public sealed class FollowTaskCodecTests : VehicleMessageCodecContract<FollowTask>
{
    private protected override IVehicleMessageCodec<FollowTask> Codec { get; } = new FollowTaskCodec();

    [Fact]
    public void Encode_WhatCannotBe_IsRefused()
    {
        FollowTask task = Random(new Random(1));
        Assert.True(Fits(task));
        Assert.False(Fits(task with { Finder = 0 }));
        Assert.False(Fits(task with { Decision = 0 }));
        Assert.False(Fits(task with { State = FollowState.Awarded, Follower = 0, Result = FollowResult.None }));
        Assert.False(Fits(task with { State = FollowState.Closed, Result = FollowResult.None }));
        Assert.False(Fits(task with { State = FollowState.Open, Result = FollowResult.Lost }));
        Assert.False(Fits(task with { State = (FollowState)3 }));
        Assert.False(Fits(task with { RadiusMetres = double.NaN }));
        Assert.False(Fits(task with { VelocityNed = new NedVector(double.NaN, 0, 0) }));
        Assert.False(Fits(task with { Time = TimeSpan.FromHours(-5) }));
        Assert.False(Fits(task with { Class = default }));
    }

    private protected override FollowTask Random(Random random)
    {
        var state = (FollowState)random.Next(3);
        return new FollowTask
        {
            Finder = (byte)random.Next(1, 256),
            Session = (ushort)random.Next(65536),
            Number = (ushort)random.Next(65536),
            Decision = (ushort)random.Next(1, 65536),
            Decider = (byte)random.Next(1, 256),
            State = state,
            Follower = (byte)random.Next(1, 256),
            Progress = (FollowProgress)random.Next(3),
            Result = state == FollowState.Closed ? (FollowResult)random.Next(1, 5) : FollowResult.None,
            Class = DefaultTargetClasses.Red,
            MarkerId = random.Next(2) == 0 ? null : random.Next(65535),
            Position = GeodeticPosition.FromDegrees(
                (random.NextDouble() * 180) - 90, (random.NextDouble() * 360) - 180, 0),
            VelocityNed = new NedVector((random.NextDouble() * 200) - 100, (random.NextDouble() * 200) - 100, 0),
            RadiusMetres = random.NextDouble() * 600,
            Time = TimeSpan.FromSeconds(1000 - random.Next(0, 500)),
            InView = TimeSpan.FromSeconds(random.Next(65536)),
        };
    }

    private protected override void AssertEqual(FollowTask expected, FollowTask actual)
    {
        Assert.Equal(
            (expected.Finder, expected.Session, expected.Number, expected.Decision, expected.Decider),
            (actual.Finder, actual.Session, actual.Number, actual.Decision, actual.Decider));
        Assert.Equal(
            (expected.State, expected.Follower, expected.Progress, expected.Result, expected.Class, expected.MarkerId),
            (actual.State, actual.Follower, actual.Progress, actual.Result, actual.Class, actual.MarkerId));
        Assert.Equal(expected.Position.Latitude.Degrees, actual.Position.Latitude.Degrees, 7);
        Assert.Equal(expected.Position.Longitude.Degrees, actual.Position.Longitude.Degrees, 7);
        Assert.Equal(expected.VelocityNed.North, actual.VelocityNed.North, 0.0051);
        Assert.Equal(expected.VelocityNed.East, actual.VelocityNed.East, 0.0051);
        Assert.Equal(expected.RadiusMetres, actual.RadiusMetres, 0.0051);
        Assert.Equal((expected.Time, expected.InView), (actual.Time, actual.InView));
    }

    private bool Fits(FollowTask task)
        => Codec.TryEncode(task, TimeSpan.FromSeconds(1000), new byte[VehicleMessageRoute.MaxLength], out _);
}
