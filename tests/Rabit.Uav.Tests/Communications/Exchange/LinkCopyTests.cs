using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;
using static Rabit.Uav.Tests.Communications.Exchange.TwoLinks;

namespace Rabit.Uav.Tests.Communications.Exchange;

/// <summary>
/// Messages that are not acknowledged, with two links: one to the autopilot, which has room, and a radio under a
/// budget, which has none for a while.
/// </summary>
public sealed class LinkCopyTests
{
    private readonly TwoLinks _links = new();

    [Fact]
    public void Message_OneLinkHasNoRoom_GoesOverItWhenItHas()
    {
        MessageExchange exchange = _links.Open(systemId: 1);
        _links.Free = Telemetry;
        for (int n = 0; n < 5; n++)
            exchange.Post(Message(n), TimeSpan.Zero);
        Assert.Equal(Enumerable.Repeat(Telemetry, 5), Send(exchange, 0));
        Assert.Empty(Send(exchange, 1));
        Assert.True(exchange.NextDue(TimeSpan.FromSeconds(1)) <= TimeSpan.FromSeconds(1), "waits for the radio");

        _links.Free = Telemetry | Radio;
        Assert.Equal(Enumerable.Repeat(Radio, 5), Send(exchange, 2));
        Assert.Empty(Send(exchange, 2.1));
        Assert.Equal(0, exchange.Waiting);
        Assert.Equal((5L, 0L, 0L, 0L), CountsOf(exchange));
        Assert.All(Reports(exchange), r => Assert.Equal(DeliveryOutcome.Sent, r));
    }

    [Fact]
    public void Message_BothLinksHaveRoom_GoesOutOnce()
    {
        MessageExchange exchange = _links.Open(systemId: 1);
        exchange.Post(Message(0), TimeSpan.Zero);
        Assert.Equal([Telemetry | Radio], Send(exchange, 0));
        Assert.Empty(Send(exchange, 0.1));
        Assert.Equal(0, exchange.Waiting);
    }

    [Fact]
    public void Message_OneLinkHasNoRoomForItsLifetime_IsSentAndTheMissingCopyIsCounted()
    {
        MessageExchange exchange = _links.Open(systemId: 1);
        _links.Free = Telemetry;
        exchange.Post(Message(0), TimeSpan.Zero);
        Assert.Equal([Telemetry], Send(exchange, 0));
        Assert.Empty(Send(exchange, 6));
        Assert.Equal((1L, 0L, 0L, 1L), CountsOf(exchange));
        Assert.Equal([DeliveryOutcome.Sent], Reports(exchange));
    }

    [Fact]
    public void Message_NoLinkHasRoomForItsLifetime_Expires()
    {
        MessageExchange exchange = _links.Open(systemId: 1);
        _links.Free = 0;
        exchange.Post(Message(0), TimeSpan.Zero);
        Assert.Empty(Send(exchange, 0));
        Assert.Empty(Send(exchange, 6));
        Assert.Equal((0L, 0L, 1L, 0L), CountsOf(exchange));
        Assert.Equal([DeliveryOutcome.Expired], Reports(exchange));
    }

    // Of several fragments those that are missing on a link follow, each of them once.
    [Fact]
    public void Message_OfSeveralFragments_EachGoesOverEachLinkOnce()
    {
        MessageExchange exchange = _links.Open(systemId: 1);
        exchange.Post(Message(0, length: 250), TimeSpan.Zero);
        _links.Free = Radio;
        Assert.Equal([Radio, Radio, Radio], Send(exchange, 0));
        _links.Free = Telemetry | Radio;
        Assert.Equal([Telemetry, Telemetry, Telemetry], Send(exchange, 0.5));
        Assert.Equal((3L, 0L, 0L, 0L), CountsOf(exchange));
    }

    [Fact]
    public void State_NewerBeforeALinkHadRoom_TakesThePlaceOfTheOlder()
    {
        MessageExchange exchange = _links.Open(systemId: 1);
        _links.Free = Telemetry;
        exchange.Post(Message(0, messageClass: VehicleMessageClass.State), TimeSpan.Zero);
        Send(exchange, 0);
        exchange.Post(Message(1, messageClass: VehicleMessageClass.State), TimeSpan.FromSeconds(1));
        _links.Free = Telemetry | Radio;
        Assert.Equal([Telemetry | Radio], Send(exchange, 1));
        Assert.Equal([DeliveryOutcome.Sent, DeliveryOutcome.Sent], Reports(exchange));
        Assert.Equal(1, exchange.Counters.CopiesHeldBack);
    }

    [Theory]
    [InlineData(Telemetry)]
    [InlineData(0)]
    public void NextDue_LinkHasRoomLater_IsThenAndNotBefore(ulong free)
    {
        MessageExchange exchange = _links.Open(systemId: 1, announces: true);
        (_links.Free, _links.Wait) = (free, TimeSpan.FromSeconds(1.45));
        exchange.Post(Message(0), TimeSpan.Zero);
        Send(exchange, 0);
        Assert.Equal(TimeSpan.FromSeconds(1.45), exchange.NextDue(TimeSpan.Zero));
    }

    // What was announced before, and one link did not get yet, is of a vehicle that there is no more.
    [Fact]
    public void Announcement_SystemIdChangesBeforeALinkHadRoom_IsAnnouncedWithTheNewOne()
    {
        MessageExchange exchange = _links.Open(systemId: 1, announces: true);
        _links.Free = Telemetry;
        Assert.Equal([Telemetry], Send(exchange, 0));
        exchange.SystemId = 7;
        _links.Free = Telemetry | Radio;
        Assert.True(exchange.NextDue(TimeSpan.FromSeconds(0.1)) <= TimeSpan.FromSeconds(0.1));
        Assert.True(ExchangeWire.TryRead(Next(exchange, 0.1), out ExchangeAnnouncement announcement));
        Assert.Equal(7, announcement.Source);
        Assert.Empty(Send(exchange, 0.1));
        Assert.Equal(1, exchange.Counters.CopiesHeldBack);
    }

    private static List<DeliveryOutcome> Reports(MessageExchange exchange)
    {
        var outcomes = new List<DeliveryOutcome>();
        while (exchange.TryReport(out _, out DeliveryReport report))
            outcomes.Add(report.Outcome);
        return outcomes;
    }

    private static (long Sent, long Resent, long Expired, long HeldBack) CountsOf(MessageExchange exchange)
        => (exchange.Counters.FragmentsSent, exchange.Counters.FragmentsResent, exchange.Counters.Expired,
            exchange.Counters.CopiesHeldBack);

    private static ExchangeMessage Message(
        int number, int length = 10, VehicleMessageClass messageClass = VehicleMessageClass.Coordination) => new()
        {
            Type = 7,
            Version = 1,
            Content = new byte[length],
            Destination = VehicleDestination.All,
            Class = messageClass,
            Lifetime = TimeSpan.FromSeconds(5),
            Reference = number,
        };
}
