using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>MAVLink frames for managers of the user's (docs/managers/communications.md).</summary>
public sealed class SubscriptionTests
{
    private const byte Gimbal = (byte)MavComponent.Gimbal;

    [Fact]
    public void Subscription_OfAMessage_ReceivesItAndNothingElse_AutopilotAll()
    {
        var ranges = new PayloadManager<DistanceSensor>("ranges");
        using CommunicationsRig rig = Rig(
            [ranges], [new MavlinkSubscription("ranges") { MessageIds = [DistanceSensor.MavlinkId] }]);

        rig.Send(0, Frames.Heartbeat(), Frames.Of(new DistanceSensor { CurrentDistance = 420 }, component: 7));

        Assert.Equal(420, Assert.Single(ranges.Taken).CurrentDistance);
        LinkFrame frame = Assert.Single(ranges.Frames);
        Assert.Equal((true, 0, 1L, (byte)7), (frame.IsChecked, frame.Link, frame.Index, frame.Frame.ComponentId));
        Assert.Equal(2, rig.Autopilot.Taken.Count);
        Assert.Equal(0, ranges.Undecoded);
    }

    [Fact]
    public void Subscriptions_SeveralToOneMessageAndOneToAll_EachReceivesIt()
    {
        var first = new PayloadManager<DistanceSensor>("first");
        var second = new PayloadManager<DistanceSensor>("second");
        var all = new PayloadManager<DistanceSensor>("all");
        using CommunicationsRig rig = Rig(
            [first, second, all],
            [
                new MavlinkSubscription("first") { MessageIds = [DistanceSensor.MavlinkId, Heartbeat.MavlinkId] },
                new MavlinkSubscription("second") { MessageIds = [DistanceSensor.MavlinkId] },
                new MavlinkSubscription("all"),
            ]);

        rig.Send(
            0, Frames.Heartbeat(), Frames.Of(new DistanceSensor()), Frames.Of(new Attitude()),
            Frames.Raw(Frames.UnknownId, [1, 2]), Frames.Heartbeat(sequence: 4));

        Assert.Equal((1, 2L), (first.Taken.Count, first.Undecoded));
        Assert.Equal((1, 0L), (second.Taken.Count, second.Undecoded));
        Assert.Equal((1, 3L), (all.Taken.Count, all.Undecoded));
        Assert.Equal(
            [("first", 3L, 0L), ("second", 1L, 0L), ("all", 4L, 0L)],
            rig.Manager.CountSubscriptions().Select(c => (c.Queue, c.Delivered, c.Dropped)));
    }

    [Theory]
    [InlineData(QueueFullMode.DropOldest)]
    [InlineData(QueueFullMode.Reject)]
    [InlineData(QueueFullMode.DropNewest)]
    public void Subscription_ManagerThatNeverReceives_DropsAreCountedAndLogged_AutopilotDoesNotWait(
        QueueFullMode fullMode)
    {
        var stuck = new PayloadManager<Heartbeat>("stuck", capacity: 4, fullMode, isStuck: true);
        using CommunicationsRig rig = Rig([stuck], [new MavlinkSubscription("stuck")]);

        rig.Send(0, Enumerable.Range(0, 50).Select(i => Frames.Heartbeat(sequence: (byte)i)).ToArray());
        rig.Run(TimeSpan.FromSeconds(1));

        Assert.Equal(50, rig.Autopilot.Taken.Count);
        MavlinkSubscriptionCounters counters = Assert.Single(rig.Manager.CountSubscriptions());
        Assert.Equal((4L, 46L), (counters.Delivered, counters.Dropped));
        Assert.Contains(
            "46 frames for queue 'stuck' were dropped", Assert.Single(rig.Log, e => e.Text.Contains("dropped")).Text);
    }

    [Fact]
    public void Subscription_QueueThatStaysFull_IsLoggedEveryTenSecondsWithTheTotal()
    {
        var stuck = new PayloadManager<Heartbeat>("stuck", capacity: 4, QueueFullMode.Reject, isStuck: true);
        using CommunicationsRig rig = Rig([stuck], [new MavlinkSubscription("stuck")]);

        for (int second = 0; second < 25; second++)
        {
            byte first = (byte)(2 * second);
            rig.Send(0, Frames.Heartbeat(sequence: first), Frames.Heartbeat(sequence: (byte)(first + 1)));
            rig.Run(TimeSpan.FromSeconds(1));
        }

        string[] lines = [.. rig.Log.Select(e => e.Text).Where(t => t.Contains("dropped"))];
        Assert.Equal(3, lines.Length);
        long[] totals = [.. lines.Select(l => long.Parse(l.Split(' ')[0], CultureInfo.InvariantCulture))];
        Assert.InRange(totals[1], totals[0] + 18, totals[0] + 22);
        Assert.InRange(totals[2], totals[1] + 18, totals[1] + 22);
        Assert.Equal(46, Assert.Single(rig.Manager.CountSubscriptions()).Dropped);
    }

    [Fact]
    public void MessageOfTheUsersDialect_IsCheckedAndReceived_DamagedOneIsNot()
    {
        var winch = new PayloadManager<WinchState>("winch");
        using CommunicationsRig rig = Rig(
            [winch], [new MavlinkSubscription("winch") { MessageIds = [WinchState.MavlinkId] }],
            o => o.Dialect = WinchState.Dialect);
        byte[] damaged = Frames.Of(new WinchState { LineCentimetres = 7 });
        damaged[10] ^= 1;

        rig.Send(0, damaged, Frames.Of(new WinchState { LineCentimetres = 1200 }), Frames.Heartbeat());

        Assert.Equal(1200, Assert.Single(winch.Taken).LineCentimetres);
        Assert.True(Assert.Single(winch.Frames).IsChecked);
        Assert.Contains(rig.Manager.SummariseLinks()[0].Counts, c => c.Name == "WINCH_STATE");
    }

    [Fact]
    public void MessageOfTheUsersDialect_IsSentFromAComponentOfItsOwn()
    {
        var winch = new PayloadManager<WinchState>("winch", componentId: Gimbal);
        using CommunicationsRig rig = Rig(
            [winch], [new MavlinkSubscription("winch")], o => o.Dialect = WinchState.Dialect);
        rig.Send(0, Frames.Heartbeat(system: 255, component: 190));
        rig.Received(1);

        winch.ToSend = new WinchState { LineCentimetres = 33, TargetSystem = 255, TargetComponent = 190 };
        rig.Run(TimeSpan.FromMilliseconds(400));

        MavlinkFrame sent = Assert.Single(rig.ReceivedFrames(0));
        Assert.True(sent.TryDecode(out WinchState state));
        Assert.Equal((33, (byte)1, Gimbal), (state.LineCentimetres, sent.SystemId, sent.ComponentId));
        Assert.Equal(0, winch.NotSent);
        Assert.Empty(rig.Received(1));
    }

    [Fact]
    public void Send_BeforeOurSystemIsKnown_IsCounted()
    {
        var winch = new PayloadManager<Heartbeat>("winch");
        using var rig = new CommunicationsRig(
            links: 1, o => o.Subscriptions = [new MavlinkSubscription("winch")], beforeStart: r => r.Add(winch));

        winch.ToSend = new Heartbeat { MavlinkVersion = 3 };
        rig.Run(TimeSpan.FromMilliseconds(400));

        Assert.Equal(1, winch.NotSent);
        Assert.Empty(rig.Received(0));
    }

    [Fact]
    public void Component_AddressedToIt_IsForItAloneAndGoesNoFurther()
    {
        var gimbal = new PayloadManager<CommandLong>("gimbal", componentId: Gimbal);
        var own = new PayloadManager<CommandLong>("own");
        using CommunicationsRig rig = Rig(
            [gimbal, own],
            [new MavlinkSubscription("gimbal") { ComponentId = Gimbal }, new MavlinkSubscription("own")]);

        rig.Send(0, Frames.Of(Frames.Command(1, Gimbal), 255, 190));

        Assert.Single(gimbal.Taken);
        Assert.Empty(own.Taken);
        Assert.Empty(rig.Autopilot.Taken);
        Assert.Empty(rig.Received(1));
    }

    [Theory]
    [InlineData(1, 0, 1, 1, 1)]      // all components of our system
    [InlineData(0, 0, 1, 1, 1)]      // every system
    [InlineData(1, 191, 0, 1, 1)]    // the computer
    [InlineData(1, 77, 0, 0, 0)]     // a component that is not ours
    [InlineData(2, Gimbal, 0, 0, 0)] // the gimbal of another vehicle
    public void Component_AddressedElsewhere_FollowsTheRulesOfMavlink(
        byte system, byte component, int atGimbal, int atOwn, int atAutopilot)
    {
        var gimbal = new PayloadManager<CommandLong>("gimbal");
        var own = new PayloadManager<CommandLong>("own");
        using CommunicationsRig rig = Rig(
            [gimbal, own],
            [new MavlinkSubscription("gimbal") { ComponentId = Gimbal },
                new MavlinkSubscription("own") { ComponentId = 191 }]);

        rig.Send(0, Frames.Of(Frames.Command(system, component), 255, 190));

        Assert.Equal((atGimbal, atOwn, atAutopilot), (gimbal.Taken.Count, own.Taken.Count, rig.Autopilot.Taken.Count));
    }

    [Fact]
    public void Component_OwnFramesComingBack_AreNotDelivered()
    {
        var gimbal = new PayloadManager<Heartbeat>("gimbal");
        using CommunicationsRig rig = Rig([gimbal], [new MavlinkSubscription("gimbal") { ComponentId = Gimbal }]);

        rig.Send(0, Frames.Heartbeat(component: Gimbal));

        Assert.Empty(gimbal.Taken);
        Assert.Empty(rig.Received(1));
    }

    [Fact]
    public void SignedLink_OnlyVerifiedFramesAreDelivered()
    {
        var all = new PayloadManager<Heartbeat>("all");
        using MavlinkSigningKey key = MavlinkSigningKey.FromPassphrase("only we two know it");
        using CommunicationsRig rig = Rig(
            [all], [new MavlinkSubscription("all")], o => o.Signing = new SigningOptions(key) { Links = [0] });
        var clock = new MavlinkSigningClock();
        clock.Advance(new DateTime(2026, 1, 1, 0, 0, 0, DateTimeKind.Utc), TimeSpan.Zero);
        MavlinkFrame signed = new MavlinkSigner(key, 3, clock)
            .Sign(MavlinkFrame.Create(new Heartbeat(), 1, 1, 0), Heartbeat.MavlinkCrcExtra);

        rig.Send(0, Frames.Heartbeat(sequence: 9), Frames.Bytes(signed));

        Assert.True(Assert.Single(all.Frames).Frame.IsSigned);
    }

    [Fact]
    public void Replay_SubscriptionReceivesWhatTheAutopilotDoes()
    {
        using TestLog log = new TestLog()
            .Record(0, Frames.Heartbeat())
            .Record(1000, Frames.Of(new WinchState { LineCentimetres = 5 }))
            .Record(2000, Frames.Of(new CommandAck { TargetSystem = 255, TargetComponent = 190 }));
        var winch = new PayloadManager<WinchState>("winch");
        var all = new PayloadManager<CommandAck>("all");
        using CommunicationsRig rig = Rig(
            [winch, all],
            [new MavlinkSubscription("winch") { MessageIds = [WinchState.MavlinkId] }, new MavlinkSubscription("all")],
            o => (o.Dialect, o.RecordedFiles) = (WinchState.Dialect, [log.Open(WinchState.Dialect)]));

        rig.Run(TimeSpan.FromSeconds(1));

        Assert.Equal(5, Assert.Single(winch.Taken).LineCentimetres);
        Assert.Single(all.Taken);
        Assert.Equal(2, all.Undecoded);
        Assert.Equal(3, rig.Autopilot.Taken.Count);
    }

    [Fact]
    public void Queue_NoManagerReceives_TheWiringNamesIt()
    {
        var fault = Assert.Throws<RabitWiringException>(() => Rig([], [new MavlinkSubscription("ranges")]));

        Assert.Contains("Queue 'ranges' has no receiver, but 'communications' sends to it.", fault.Message);
    }

    [Fact]
    public void Queue_TwoManagersReceive_TheWiringNamesThem()
    {
        RabitManager[] managers = [new PayloadManager<Heartbeat>("ranges"), new OtherReceiver("ranges")];

        var fault = Assert.Throws<RabitWiringException>(() => Rig(managers, [new MavlinkSubscription("ranges")]));

        Assert.Contains("Queue 'ranges' has 2 receivers ('ranges manager', 'other'); it can have one.", fault.Message);
    }

    [Fact]
    public void Queue_MakesItsSendersWait_TheWiringNamesIt()
    {
        var fault = Assert.Throws<RabitWiringException>(
            () => Rig(
                [new PayloadManager<Heartbeat>("ranges", fullMode: QueueFullMode.Wait)],
                [new MavlinkSubscription("ranges")]));

        Assert.Contains(
            "Queue 'ranges' makes its senders wait when it is full; a manager never waits, and 'communications' is "
                + "one.",
            fault.Message);
    }

    public static TheoryData<string, Action<CommunicationsOptions>> Faults => new()
    {
        { "Dialect is null", o => o.Dialect = null! },
        { "Subscriptions, or one of them, is null; the list may be empty", o => o.Subscriptions = null! },
        { "Subscriptions, or one of them, is null; the list may be empty", o => o.Subscriptions = [null!] },
        { "2 subscriptions have queue 'a'; each needs a queue of its own",
            o => o.Subscriptions = [new("a"), new("a")] },
        { "a subscription has queue 'autopilot frames', which is that of Autopilot Interface",
            o => o.Subscriptions = [new("autopilot frames")] },
        { "the subscription of queue 'a' is for component 0, which means every component",
            o => o.Subscriptions = [new("a") { ComponentId = 0 }] },
        { "the subscription of queue 'a' has null as MessageIds; none means all",
            o => o.Subscriptions = [new("a") { MessageIds = null! }] },
        { "the subscription of queue 'a' has message 0 more than once",
            o => o.Subscriptions = [new("a") { MessageIds = [0, 0] }] },
        {
            "the subscription of queue 'a' has message 54321, which dialect 'all' does not have, so that nothing could "
                + "check it; MavlinkDialect.Combine",
            o => o.Subscriptions = [new("a") { MessageIds = [WinchState.MavlinkId] }]
        },
        {
            "dialect 'tiny' lacks HEARTBEAT and ",
            o => o.Dialect = new MavlinkDialect(
                "tiny", [new MavlinkMessageInfo(WinchState.MavlinkId, "WINCH_STATE", 77, 4, 4, -1, -1)])
        },
        {
            "dialect 'other' has HEARTBEAT (checksum byte 51) as message 0, which the managers use as HEARTBEAT "
                + "(checksum byte 50)",
            o => o.Dialect = new MavlinkDialect("other", WithAnotherHeartbeat())
        },
    };

    [Theory]
    [MemberData(nameof(Faults))]
    public void Options_OutOfRange_AreNamed(string expected, Action<CommunicationsOptions> configure)
    {
        var fault = Assert.Throws<ArgumentException>(() => new CommunicationsRig(links: 1, configure));

        Assert.Contains(expected, fault.Message);
    }

    [Fact]
    public void Subscription_WithoutAName_IsRefused()
        => Assert.Equal(
            "queue", Assert.Throws<ArgumentException>(() => new MavlinkSubscription(string.Empty)).ParamName);

    private static CommunicationsRig Rig(
        IEnumerable<RabitManager> managers, MavlinkSubscription[] subscriptions,
        Action<CommunicationsOptions>? configure = null)
    {
        return new CommunicationsRig(
            links: 2,
            o =>
            {
                (o.Subscriptions, o.PositionRateHz) = (subscriptions, 0);
                configure?.Invoke(o);
            },
            beforeStart: reactor =>
            {
                foreach (RabitManager manager in managers)
                    reactor.Add(manager);
            }).As(1);
    }

    private static MavlinkMessageInfo[] WithAnotherHeartbeat() => MavlinkDialect.All.Messages
        .Select(m => m.Id != 0 ? m : new MavlinkMessageInfo(0, m.Name, 51, m.MinLength, m.MaxLength, -1, -1)).ToArray();

    private sealed class OtherReceiver : RabitManager
    {
        public OtherReceiver(string queue)
            : base("other") => Receive<LinkFrame>(queue);

        protected override void ExecuteUnitOfWork()
        {
        }
    }
}
