using System;
using System.Collections.Generic;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;
using static Rabit.Uav.Tests.Communications.Exchange.TwoLinks;

namespace Rabit.Uav.Tests.Communications.Exchange;

/// <summary>
/// What a vehicle sends on for others, and its announcements, with two links: one to the autopilot, which has room,
/// and a radio under a budget, which has none for a while.
/// </summary>
public sealed class RelayCopyTests
{
    private const byte Sender = 1;
    private const byte Relay = 2;

    private readonly TwoLinks _links = new() { Free = Telemetry };

    [Fact]
    public void Relay_OneLinkHasNoRoom_GoesOverItWhenItHas()
    {
        MessageExchange relay = _links.Open(Relay);
        byte[] fragment = Fragment(number: 1, lifetimeSeconds: 5);
        relay.Take(fragment, Sender, TimeSpan.Zero);
        Assert.Equal([Telemetry], Send(relay, 0.1));
        Assert.Empty(Send(relay, 1));
        Assert.True(relay.NextDue(TimeSpan.FromSeconds(1)) <= TimeSpan.FromSeconds(1), "waits for the radio");

        _links.Free = Telemetry | Radio;
        Assert.Equal([Radio], Send(relay, 2));
        Assert.Empty(Send(relay, 2.1));
        Assert.Equal((1L, 0L), (relay.Counters.Relayed, relay.Counters.CopiesHeldBack));
    }

    [Fact]
    public void Relay_SenderSendsAgainWhileTheRadioHasNoRoom_TheRadioGetsItOnce()
    {
        MessageExchange relay = _links.Open(Relay);
        byte[] fragment = Fragment(number: 1, lifetimeSeconds: 5);
        relay.Take(fragment, Sender, TimeSpan.Zero);
        Assert.Equal([Telemetry], Send(relay, 0.1));
        relay.Take(fragment, Sender, TimeSpan.FromMilliseconds(500));
        Assert.Equal([Telemetry], Send(relay, 0.6));

        _links.Free = Telemetry | Radio;
        Assert.Equal([Radio], Send(relay, 1));
        Assert.Equal(0, relay.Counters.CopiesHeldBack);
    }

    [Fact]
    public void Relay_CopyThatWaited_IsAsOldAsItIs()
    {
        MessageExchange relay = _links.Open(Relay);
        relay.Take(Fragment(number: 1, lifetimeSeconds: 5), Sender, TimeSpan.Zero);
        Assert.Equal(100, AgeMs(relay, 0.1));
        _links.Free = Telemetry | Radio;
        Assert.Equal(2000, AgeMs(relay, 2));
    }

    [Fact]
    public void Relay_BothLinksHaveRoom_GoesOutOnce()
    {
        _links.Free = Telemetry | Radio;
        MessageExchange relay = _links.Open(Relay);
        relay.Take(Fragment(number: 1, lifetimeSeconds: 5), Sender, TimeSpan.Zero);
        Assert.Equal([Telemetry | Radio], Send(relay, 0.1));
        Assert.Empty(Send(relay, 0.2));
    }

    [Fact]
    public void Relay_OneLinkHasNoRoomForTheLifetime_IsDroppedAndTheMissingCopyIsCounted()
    {
        MessageExchange relay = _links.Open(Relay);
        relay.Take(Fragment(number: 1, lifetimeSeconds: 5), Sender, TimeSpan.Zero);
        Assert.Equal([Telemetry], Send(relay, 0.1));
        Assert.Empty(Send(relay, 5.1));
        Assert.Equal(1, relay.Counters.CopiesHeldBack);
        _links.Free = Telemetry | Radio;
        Assert.Empty(Send(relay, 5.2));
    }

    [Fact]
    public void Relay_AnnouncementOneLinkHasNoRoom_WaitsForItButNotForLong()
    {
        MessageExchange relay = _links.Open(Relay);
        relay.Take(Announcement(1), Sender, TimeSpan.Zero);
        Assert.Equal([Telemetry], Send(relay, 0.1));
        relay.Take(Announcement(2), Sender, TimeSpan.FromSeconds(2));
        Assert.Equal([Telemetry], Send(relay, 2.1));
        _links.Free = Telemetry | Radio;
        Assert.Equal([Radio], Send(relay, 2.2));
        Assert.Equal(1, relay.Counters.CopiesHeldBack);
    }

    [Fact]
    public void Relay_CopyWaitsForTheRadio_WhatIsOursGoesFirst()
    {
        MessageExchange relay = _links.Open(Relay);
        relay.Take(Fragment(number: 1, lifetimeSeconds: 5), Sender, TimeSpan.Zero);
        Assert.Equal([Telemetry], Send(relay, 0.1));
        relay.Post(Message(lifetimeSeconds: 5), TimeSpan.FromMilliseconds(200));

        _links.Free = Telemetry | Radio;
        Assert.Equal([Telemetry | Radio, Radio], Send(relay, 0.3));
    }

    // What waits for one link alone makes room for what is new.
    [Fact]
    public void Relay_MoreWaitThanThereIsRoomFor_TheOtherLinkGetsAll()
    {
        const int many = 100;
        MessageExchange relay = _links.Open(Relay);
        for (int n = 0; n < many; n++)
        {
            relay.Take(Fragment(n, lifetimeSeconds: 60), Sender, TimeSpan.FromSeconds(0.1 * n));
            Assert.Equal([Telemetry], Send(relay, (0.1 * n) + 0.05));
        }

        _links.Free = Telemetry | Radio;
        int waiting = Send(relay, 20).Count;
        Assert.InRange(waiting, 1, 64);
        Assert.Equal(many - waiting, relay.Counters.CopiesHeldBack);
    }

    [Fact]
    public void Announcement_OneLinkHasNoRoom_GoesOverItWhenItHas()
    {
        MessageExchange exchange = _links.Open(Relay, announces: true);
        Assert.Equal([Telemetry], Send(exchange, 0));
        Assert.Empty(Send(exchange, 0.5));
        Assert.True(exchange.NextDue(TimeSpan.FromSeconds(0.5)) <= TimeSpan.FromSeconds(0.5), "waits for the radio");
        _links.Free = Telemetry | Radio;
        Assert.Equal([Radio], Send(exchange, 1));
        Assert.Empty(Send(exchange, 1.1));
        Assert.Equal([Telemetry | Radio], Send(exchange, 2));
        Assert.Equal(0, exchange.Counters.CopiesHeldBack);
    }

    [Fact]
    public void Announcement_OneLinkHasNoRoomUntilTheNext_TheMissingCopyIsCounted()
    {
        MessageExchange exchange = _links.Open(Relay, announces: true);
        Assert.Equal([Telemetry], Send(exchange, 0));
        Assert.Equal([Telemetry], Send(exchange, 2));
        Assert.Equal(1, exchange.Counters.CopiesHeldBack);
        _links.Free = Telemetry | Radio;
        Assert.Equal([Radio], Send(exchange, 3));
    }

    private static int AgeMs(MessageExchange exchange, double seconds)
    {
        Assert.True(ExchangeWire.TryRead(Next(exchange, seconds), out ExchangeFragment fragment));
        return fragment.AgeMs;
    }

    private static byte[] Fragment(int number, double lifetimeSeconds)
    {
        var sender = new MessageExchange(
            new VehicleExchangeOptions { Announces = false }, Sender, new ExchangeRandom(number));
        sender.Post(Message(lifetimeSeconds), TimeSpan.Zero);
        return Next(sender, 0);
    }

    private static ExchangeMessage Message(double lifetimeSeconds) => new()
    {
        Type = 7,
        Version = 1,
        Content = new byte[10],
        Destination = VehicleDestination.Vehicle(9),
        HopLimit = 1,
        Class = VehicleMessageClass.Coordination,
        Lifetime = TimeSpan.FromSeconds(lifetimeSeconds),
    };

    private static byte[] Announcement(int number)
        => Next(
            new MessageExchange(
                new VehicleExchangeOptions { Announces = true, AnnouncementHops = 1 }, Sender,
                new ExchangeRandom(number)),
            0);
}
