using System;
using System.Collections.Generic;
using Rabit.Mavlink.Messages;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Mavlink.Tests.Protocols;

public class MavlinkPingClientTests
{
    private static readonly MavlinkSender Vehicle = new(1, 1);
    private static readonly MavlinkSender Station = new(255, 190);
    private readonly MavlinkPingClient _client = new(Station, new MavlinkAddress(1, 1), TimeSpan.FromSeconds(1));
    private TimeSpan _now = TimeSpan.FromSeconds(10);

    [Fact]
    public void TryTakeFrame_OnceAPeriod_AsksAllAndMeasuresTheOne()
    {
        Ping first = Take();
        Assert.Equal(
            (10_000_000ul, 0u, (byte)0, (byte)0),
            (first.TimeUsec, first.Seq, first.TargetSystem, first.TargetComponent));
        Assert.False(_client.TryTakeFrame(_now, out _));
        Assert.Equal(TimeSpan.FromSeconds(11), _client.NextDue);

        _now += TimeSpan.FromMilliseconds(40);
        _client.Handle(new MavlinkSender(1, 191).Create(AnswerTo(first)), _now);
        Assert.Null(_client.RoundTrip);
        _client.Handle(Vehicle.Create(AnswerTo(first)), _now);
        Assert.Equal(TimeSpan.FromMilliseconds(40), _client.RoundTrip);
        Assert.Equal((1L, 1L), (_client.Requests, _client.Answers));

        // A copy of the answer, one late by a second, one with a time that was never sent, and one for another station.
        _client.Handle(Vehicle.Create(AnswerTo(first)), _now + TimeSpan.FromSeconds(5));
        _now = TimeSpan.FromSeconds(11);
        Ping second = Take();
        Assert.Equal(1u, second.Seq);
        Ping wrong = AnswerTo(second);
        wrong.TimeUsec++;
        _client.Handle(Vehicle.Create(wrong), _now);
        Ping others = AnswerTo(second);
        others.TargetComponent = 191;
        _client.Handle(Vehicle.Create(others), _now);
        Assert.Equal(1, _client.Answers);
        _client.Handle(Vehicle.Create(AnswerTo(second)), _now + TimeSpan.FromSeconds(1));
        Assert.Equal((TimeSpan.FromSeconds(1), 2L), (_client.RoundTrip, _client.Answers));
    }

    [Fact]
    public void Handle_RequestOfAnother_IsAnsweredToIt()
    {
        var client = new MavlinkPingClient(Vehicle);
        Assert.Equal(TimeSpan.MaxValue, client.NextDue);
        Assert.False(client.TryTakeFrame(_now, out _));
        client.Handle(Station.Create(new Ping { TimeUsec = 77, Seq = 5 }), _now);
        Assert.Equal(TimeSpan.Zero, client.NextDue);
        Assert.True(client.TryTakeFrame(_now, out MavlinkFrame frame));
        Assert.True(frame.TryDecode(out Ping answer));
        Assert.Equal(
            (77ul, 5u, (byte)255, (byte)190),
            (answer.TimeUsec, answer.Seq, answer.TargetSystem, answer.TargetComponent));
        Assert.False(client.TryTakeFrame(_now, out _));
    }

    [Fact]
    public void Handle_OwnRequestAnswersOfOthersAndFloods_AreNotAnswered()
    {
        var client = new MavlinkPingClient(Vehicle);
        client.Handle(Vehicle.Create(new Ping { Seq = 1 }), _now);
        client.Handle(Station.Create(new Ping { Seq = 1, TargetSystem = 1, TargetComponent = 1 }), _now);
        client.Handle(Station.Create(new Ping { Seq = 1, TargetSystem = 3, TargetComponent = 0 }), _now);
        client.Handle(Station.Create(default(Heartbeat)), _now);
        Assert.False(client.TryTakeFrame(_now, out _));

        for (uint i = 0; i < 100; i++)
            client.Handle(Station.Create(new Ping { Seq = i }), _now);
        var answered = new List<MavlinkFrame>();
        while (client.TryTakeFrame(_now, out MavlinkFrame frame))
            answered.Add(frame);
        Assert.Equal((4, 96L), (answered.Count, client.Unanswered));
    }

    [Fact]
    public void TwoClients_OverLossyLinks_MeasureEachOther()
    {
        for (ulong seed = 1; seed <= 20; seed++)
        {
            var vehicle = new MavlinkPingClient(Vehicle);
            var up = new LossyChannel(0.2, (seed * 2) + 1);
            var down = new LossyChannel(0.2, (seed * 2) + 2);
            var client = new MavlinkPingClient(Station, new MavlinkAddress(1, 1), TimeSpan.FromSeconds(1));
            for (int step = 0; step < 60_000; step++)
            {
                TimeSpan now = TimeSpan.FromMilliseconds(step);
                while (client.TryTakeFrame(now, out MavlinkFrame frame))
                    up.Send(frame, now);
                while (up.TryReceive(now, out MavlinkFrame frame))
                    vehicle.Handle(frame, now);
                while (vehicle.TryTakeFrame(now, out MavlinkFrame frame))
                    down.Send(frame, now);
                while (down.TryReceive(now, out MavlinkFrame frame))
                    client.Handle(frame, now);
            }

            Assert.Equal(60, client.Requests);
            Assert.True(client.Answers is > 20 and < 60, $"seed {seed}: {client.Answers}");
            Assert.True(client.RoundTrip <= TimeSpan.FromMilliseconds(602), $"seed {seed}: {client.RoundTrip}");
        }
    }

    [Fact]
    public void Constructor_NoComponentOrNoInterval_IsRefused()
    {
        Assert.Throws<ArgumentNullException>(() => new MavlinkPingClient(null!));
        Assert.Throws<ArgumentException>(
            () => new MavlinkPingClient(Station, new MavlinkAddress(1, 0), TimeSpan.FromSeconds(1)));
        Assert.Throws<ArgumentOutOfRangeException>(
            () => new MavlinkPingClient(Station, new MavlinkAddress(1, 1), TimeSpan.Zero));
    }

    [Fact]
    public void HandleAndTake_InTurn_AllocateNothing()
    {
        var vehicle = new MavlinkPingClient(Vehicle);
        Action work = () =>
        {
            _now += TimeSpan.FromSeconds(1);
            _client.TryTakeFrame(_now, out MavlinkFrame request);
            vehicle.Handle(request, _now);
            vehicle.TryTakeFrame(_now, out MavlinkFrame answer);
            _client.Handle(answer, _now);
        };
        work();
        Assert.Equal(0, Allocated.By(work));
    }

    private static Ping AnswerTo(Ping request)
    {
        (request.TargetSystem, request.TargetComponent) = (255, 190);
        return request;
    }

    private Ping Take()
    {
        Assert.True(_client.TryTakeFrame(_now, out MavlinkFrame frame));
        Assert.True(frame.TryDecode(out Ping ping));
        return ping;
    }
}
