using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl.Group;

/// <summary>Targets that none can validate yet, since all have lanes to fly.</summary>
public sealed class ValidationDeclinedTests
{
    private const byte Finder = 1;
    private const byte Other = 2;

    private readonly Sent _sent = new();

    [Fact]
    public void Update_AllDecline_AnnouncesRarelyAndTheNextTargetsToo()
    {
        var finder = new ValidationFinder(session: 1, _sent, _ => { });
        for (int track = 1; track <= 5; track++)
            finder.Announce(track, new ValidationTask { Class = DefaultTargetClasses.Red });
        for (double seconds = 0; seconds < 60; seconds += 0.1)
        {
            int before = _sent.Tasks.Count;
            finder.Update([Other], TimeSpan.FromSeconds(seconds));
            foreach (ValidationTask task in _sent.Tasks.Skip(before).ToArray())
                finder.Receive(Other, Answer(task, ValidationBidState.Declined), TimeSpan.FromSeconds(seconds));
        }

        foreach (IGrouping<ushort, ValidationTask> task in _sent.Tasks.GroupBy(t => t.Number))
            Assert.InRange(task.Count(), 5, 7);
        Assert.Equal(5, _sent.Tasks.Select(t => t.Number).Distinct().Count());
    }

    [Fact]
    public void Receive_OfferAfterAllDeclined_IsAwardedWithoutAnotherAnnouncement()
    {
        var finder = new ValidationFinder(session: 1, _sent, _ => { });
        finder.Announce(1, new ValidationTask { Class = DefaultTargetClasses.Red });
        finder.Update([Other], TimeSpan.Zero);
        ValidationTask task = Assert.Single(_sent.Tasks);
        finder.Receive(Other, Answer(task, ValidationBidState.Declined), TimeSpan.FromSeconds(0.1));
        finder.Update([Other], TimeSpan.FromSeconds(0.2));
        finder.Receive(Other, Answer(task, ValidationBidState.Offered), TimeSpan.FromSeconds(3));
        finder.Update([Other], TimeSpan.FromSeconds(3.1));
        Assert.Equal((ValidationState.Awarded, Other), (finder.Find(1)!.Value.State, finder.Find(1)!.Value.Validator));
    }

    [Fact]
    public void BidForOpen_WhatWasDeclined_IsOfferedUnasked()
    {
        var bidder = new ValidationBidder(_sent);
        var task = new ValidationTask { Finder = Finder, Session = 1, Number = 1, State = ValidationState.Open };
        bidder.Receive(task, Other, _ => null, TimeSpan.Zero);
        bidder.BidForOpen(_ => null);
        Assert.Equal([ValidationBidState.Declined], _sent.Bids.Select(b => b.State));
        bidder.BidForOpen(_ => 7);
        Assert.Equal([ValidationBidState.Declined, ValidationBidState.Offered], _sent.Bids.Select(b => b.State));
        Assert.Equal(7, _sent.Bids[1].Seconds);
    }

    private static ValidationBid Answer(in ValidationTask task, ValidationBidState state) => new()
    {
        Session = task.Session,
        Number = task.Number,
        Award = task.Award,
        State = state,
        Seconds = 5,
    };

    private sealed class Sent : IValidationSender
    {
        public List<ValidationTask> Tasks { get; } = [];

        public List<ValidationBid> Bids { get; } = [];

        public void Send(in ValidationTask task) => Tasks.Add(task);

        public void Send(in ValidationBid bid, byte finder) => Bids.Add(bid);
    }
}
