using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Tests.Framing;
using Xunit;

namespace Rabit.Mavlink.Tests.Routing;

/// <summary>
/// One row per clause of the guide's "Routing in detail". We are 1/191. Links: 0 autopilot 1/1, 1 ground 255/190, 2
/// other vehicle 2/1 and our camera 1/100, 3 a log (receive only, 9/1 was seen on it), 4 quiet.
/// </summary>
public class MavlinkRouterTests
{
    private const int Autopilot = 0;
    private const int Ground = 1;
    private const int Other = 2;
    private const int Log = 3;
    private const int Quiet = 4;

    private readonly MavlinkRouter _router = new(1, 191);

    public MavlinkRouterTests()
    {
        foreach (int link in new[] { Autopilot, Ground, Other, Quiet })
            _router.SetLink(link, MavlinkLinkRules.Live);
        _router.SetLink(Log, MavlinkLinkRules.ReceiveOnly);
        Receive(Autopilot, 1, 1);
        Receive(Ground, 255, 190);
        Receive(Other, 2, 1);
        Receive(Other, 1, 100);
        Receive(Log, 9, 1);
    }

    [Theory]
    // A broadcast is processed and goes to all other links, never back.
    [InlineData("broadcast to all other links", Autopilot, 1, 1, 0, 0, true, "1 2 4", MavlinkRouteReason.Broadcast)]
    [InlineData("target system 0 with a component is a broadcast", Ground, 255, 190, 0, 1, true, "0 2 4",
        MavlinkRouteReason.Broadcast)]
    // Our address.
    [InlineData("for us alone", Ground, 255, 190, 1, 191, true, "", MavlinkRouteReason.ForUs)]
    [InlineData("for every component of our system", Ground, 255, 190, 1, 0, true, "0 2",
        MavlinkRouteReason.ForOurSystem)]
    [InlineData("for our system, from within it: not back", Autopilot, 1, 1, 1, 0, true, "2",
        MavlinkRouteReason.ForOurSystem)]
    // Another component of our system: only where it was seen.
    [InlineData("for the autopilot", Ground, 255, 190, 1, 1, false, "0", MavlinkRouteReason.ForOthers)]
    [InlineData("for the camera", Autopilot, 1, 1, 1, 100, false, "2", MavlinkRouteReason.ForOthers)]
    [InlineData("for a component of ours that was not seen", Ground, 255, 190, 1, 154, false, "",
        MavlinkRouteReason.UnknownTarget)]
    // Another system: where the system was seen, whichever component.
    [InlineData("for the ground station", Autopilot, 1, 1, 255, 190, false, "1", MavlinkRouteReason.ForOthers)]
    [InlineData("for another system, all components", Ground, 255, 190, 2, 0, false, "2", MavlinkRouteReason.ForOthers)]
    [InlineData("for another system, a component not seen", Ground, 255, 190, 2, 77, false, "2",
        MavlinkRouteReason.ForOthers)]
    [InlineData("for a system that was not seen", Ground, 255, 190, 3, 1, false, "", MavlinkRouteReason.UnknownTarget)]
    [InlineData("for one who is only on the link it came from", Other, 1, 100, 2, 1, false, "",
        MavlinkRouteReason.ForOthers)]
    // A log is neither a source nor a target of forwarding.
    [InlineData("broadcast from a log stays here", Log, 9, 1, 0, 0, true, "", MavlinkRouteReason.Broadcast)]
    [InlineData("addressed from a log stays here", Log, 9, 1, 1, 1, false, "", MavlinkRouteReason.ForOthers)]
    [InlineData("for one seen in a log only", Ground, 255, 190, 9, 1, false, "", MavlinkRouteReason.ForOthers)]
    // Our own address coming in.
    [InlineData("our echo", Ground, 1, 191, 0, 0, false, "", MavlinkRouteReason.OurOwn)]
    [InlineData("our part of a log", Log, 1, 191, 1, 1, false, "", MavlinkRouteReason.OurOwn)]
    // A frame of a sender without an address is delivered.
    [InlineData("from system 0", Quiet, 0, 0, 0, 0, true, "0 1 2", MavlinkRouteReason.Broadcast)]
    public void Route_Clause(
        string clause, int link, byte system, byte component, byte targetSystem, byte targetComponent, bool isLocal,
        string links, MavlinkRouteReason reason)
    {
        var command = new CommandLong { TargetSystem = targetSystem, TargetComponent = targetComponent };
        MavlinkRoute route = _router.Route(
            link, MavlinkFrame.Create(command, system, component, 0), Wire.Info<CommandLong>(), isChecked: true);

        Assert.Equal(
            (clause, isLocal, links, reason), (clause, route.DeliverLocally, Links(route.ForwardTo), route.Reason));
    }

    [Theory]
    [InlineData("broadcast", 0, 0, "0 1 2 4")]
    [InlineData("to the autopilot", 1, 1, "0")]
    [InlineData("to our whole system", 1, 0, "0 2")]
    [InlineData("to a component of ours that was not seen", 1, 154, "")]
    [InlineData("to another system", 2, 1, "2")]
    [InlineData("to another system, a component not seen", 2, 77, "2")]
    [InlineData("to a system that was not seen", 3, 1, "")]
    [InlineData("to one seen in a log only", 9, 1, "")]
    public void RouteOwn_Clause(string clause, byte targetSystem, byte targetComponent, string links)
    {
        var command = new CommandLong { TargetSystem = targetSystem, TargetComponent = targetComponent };
        ulong route = _router.RouteOwn(MavlinkFrame.Create(command, 1, 191, 0), Wire.Info<CommandLong>());

        Assert.Equal((clause, links), (clause, Links(route)));
        Assert.Equal(links.Length == 0 ? 1 : 0, _router.Counters.UnknownTargets);
    }

    [Fact]
    public void Route_MessageWithoutTarget_IsABroadcast()
    {
        MavlinkRoute route = Receive(Autopilot, 1, 1);

        Assert.Equal(
            (MavlinkRouteReason.Broadcast, true, "1 2 4"),
            (route.Reason, route.DeliverLocally, Links(route.ForwardTo)));
    }

    [Fact]
    public void Route_UnknownId_GoesOnAsABroadcastButNotToUsAndIsNotLearned()
    {
        MavlinkFrame frame = Wire.Single(Wire.V2(Wire.UnknownId, [1]), out MavlinkFrameInfo info);
        _router.RemoveLink(Autopilot);
        _router.SetLink(Autopilot, MavlinkLinkRules.Live);

        MavlinkRoute route = _router.Route(Autopilot, frame, info);

        Assert.Equal(
            (MavlinkRouteReason.UnknownMessage, false, "1 2 4"),
            (route.Reason, route.DeliverLocally, Links(route.ForwardTo)));
        Assert.Equal(0UL, _router.LinksOf(1, 1));
    }

    [Fact]
    public void Route_SignedFrame_IsRoutedLikeAnyOther()
    {
        MavlinkFrame frame = Wire.Single(
            Wire.V2(0, [1], Wire.Info<Heartbeat>().CrcExtra, incompatibilityFlags: 1), out MavlinkFrameInfo info);

        Assert.Equal("1 2 4", Links(_router.Route(Autopilot, frame, info).ForwardTo));
    }

    [Fact]
    public void Route_SetupSigning_NeverLeavesItsLink()
    {
        AssertLinkLocal(new SetupSigning(), isLocal: true);
        AssertLinkLocal(new SetupSigning { TargetSystem = 1, TargetComponent = 191 }, isLocal: true);
        AssertLinkLocal(new SetupSigning { TargetSystem = 1, TargetComponent = 1 }, isLocal: false);
    }

    [Fact]
    public void Route_RadioStatusAndRadio_NeverLeaveTheirLink()
    {
        AssertLinkLocal(new RadioStatus { Rssi = 1 }, isLocal: true);
        AssertLinkLocal(new Radio { Rssi = 1 }, isLocal: true);
    }

    [Fact]
    public void Route_RadioStatusWithLinksForIt_GoesToTheseAndNeverBack()
    {
        _router.SetRadioStatusLinks((1UL << Ground) | (1UL << Quiet) | (1UL << Log));

        MavlinkRoute route = _router.Route(
            Quiet, MavlinkFrame.Create(default(RadioStatus), 51, 68, 0), Wire.Info<RadioStatus>(), isChecked: true);

        Assert.Equal((MavlinkRouteReason.LinkLocal, "1"), (route.Reason, Links(route.ForwardTo)));
    }

    [Fact]
    public void Route_UnknownIdNotToBeForwarded_GoesNowhere()
    {
        _router.ForwardsUnknownMessages = false;

        MavlinkRoute route = _router.Route(
            Ground, MavlinkFrame.Create(default(Heartbeat), 255, 190, 0), default, isChecked: false);

        Assert.Equal((MavlinkRouteReason.UnknownMessage, 0UL), (route.Reason, route.ForwardTo));
    }

    [Theory]
    [InlineData(60_000u, 5_000u, "4")]
    [InlineData(60_000u, 59_500u, "2 4")]
    [InlineData(60_000u, 61_000u, "2 4")]
    public void Route_SystemTimeThatGoesBack_ForgetsWhereTheComponentWas(uint before, uint after, string links)
    {
        Receive(Other, 2, 100);
        SendTime(Other, 2, before);

        SendTime(Quiet, 2, after);

        Assert.Equal(links, Links(_router.LinksOf(2, 1)));
        Assert.Equal("2", Links(_router.LinksOf(2, 100)));
        Assert.Equal("2 4", Links(_router.LinksOf(2, 0)));
    }

    [Fact]
    public void Route_SystemTimesOfTwoComponents_AreTheirOwn()
    {
        SendTime(Other, 1, 60_000, component: 100);
        SendTime(Autopilot, 1, 5_000);
        SendTime(Other, 1, 61_000, component: 100);
        SendTime(Autopilot, 1, 6_000);

        Assert.Equal(("0", "2"), (Links(_router.LinksOf(1, 1)), Links(_router.LinksOf(1, 100))));
    }

    [Fact]
    public void Route_MoreThanTwentyComponents_EachIsFound()
    {
        for (int component = 1; component <= 200; component++)
            Receive(component % 2 == 0 ? Other : Quiet, 1, (byte)(component == 191 ? 250 : component));

        for (int component = 2; component <= 190; component++)
        {
            ulong links = _router.LinksOf(1, (byte)component) & ~(1UL << Autopilot);
            Assert.Equal(component % 2 == 0 ? 1UL << Other : 1UL << Quiet, links);
        }
    }

    [Fact]
    public void Learn_CopyOverAnotherLink_IsLearnedAndNotCounted()
    {
        MavlinkRouterCounters before = _router.Counters;
        _router.Learn(Quiet, MavlinkFrame.Create(default(Heartbeat), 2, 1, 0), isChecked: true);
        _router.Learn(Quiet, MavlinkFrame.Create(default(Heartbeat), 77, 1, 0), isChecked: false);
        _router.Learn(Quiet, MavlinkFrame.Create(default(Heartbeat), 1, 191, 0), isChecked: true);

        Assert.Equal(("2 4", "", ""), (
            Links(_router.LinksOf(2, 1)), Links(_router.LinksOf(77, 1)), Links(_router.LinksOf(1, 191))));
        Assert.Equal(before.Delivered, _router.Counters.Delivered);
    }

    [Fact]
    public void Route_LinkLocalIdThatTheDialectLacks_NeverLeavesItsLink()
    {
        MavlinkFrame frame = MavlinkFrame.Create(new SetupSigning(), 255, 190, 0);

        MavlinkRoute route = _router.Route(Ground, frame, default, isChecked: false);

        Assert.Equal((MavlinkRouteReason.LinkLocal, false, 0UL), (route.Reason, route.DeliverLocally, route.ForwardTo));
    }

    [Fact]
    public void RouteOwn_SetupSigning_GoesToItsTargetAndNeverToAll()
    {
        MavlinkMessageInfo info = Wire.Info<SetupSigning>();

        Assert.Equal("0", Links(
            _router.RouteOwn(
                MavlinkFrame.Create(new SetupSigning { TargetSystem = 1, TargetComponent = 1 }, 1, 191, 0), info)));
        Assert.Equal("", Links(_router.RouteOwn(MavlinkFrame.Create(new SetupSigning(), 1, 191, 0), info)));
    }

    [Fact]
    public void Route_TargetMovesToAnotherLink_GoesToBoth()
    {
        Receive(Quiet, 2, 1);

        Assert.Equal("2 4", Links(_router.LinksOf(2, 1)));
        Assert.Equal("2 4", Links(_router.LinksOf(2, 0)));
    }

    [Fact]
    public void RemoveLink_ForgetsWhoWasSeenOnIt()
    {
        int before = _router.Sources;
        _router.RemoveLink(Other);

        Assert.Equal((0UL, 0UL, "0"), (_router.LinksOf(2, 1), _router.LinksOf(2, 0), Links(_router.LinksOf(1, 0))));
        Assert.Equal(before - 2, _router.Sources);
        Assert.Equal("1 4", Links(Receive(Autopilot, 1, 1).ForwardTo));
        Assert.Throws<ArgumentOutOfRangeException>("link", () => Receive(Other, 2, 1));
    }

    [Fact]
    public void ForgetSystem_ForgetsItAndNoOther()
    {
        _router.ForgetSystem(1);

        Assert.Equal((0UL, 0UL, "2"), (_router.LinksOf(1, 1), _router.LinksOf(1, 0), Links(_router.LinksOf(2, 1))));
        Receive(Autopilot, 1, 1);
        Assert.Equal("0", Links(_router.LinksOf(1, 1)));
    }

    [Fact]
    public void SetOwnAddress_AnotherSystem_IsOursFromThenOn()
    {
        _router.SetOwnAddress(2, 191);
        MavlinkFrame command = MavlinkFrame.Create(
            new CommandLong { TargetSystem = 2, TargetComponent = 191 }, 255, 190, 0);

        Assert.Equal(
            MavlinkRouteReason.ForUs, _router.Route(Ground, command, Wire.Info<CommandLong>(), isChecked: true).Reason);
        Assert.Equal(MavlinkRouteReason.OurOwn, Receive(Ground, 2, 191).Reason);
        Assert.Equal("2", Links(_router.LinksOf(2, 1)));
        Assert.Throws<ArgumentOutOfRangeException>("systemId", () => _router.SetOwnAddress(0, 1));
    }

    [Fact]
    public void AddOwnComponent_WhatIsAddressedToItIsForUsAlone_WhatComesFromItIsAnEcho()
    {
        _router.AddOwnComponent(154);
        MavlinkFrame toIt = MavlinkFrame.Create(
            new CommandLong { TargetSystem = 1, TargetComponent = 154 }, 255, 190, 0);
        MavlinkFrame fromIt = MavlinkFrame.Create(new Heartbeat(), 1, 154, 0);

        MavlinkRoute route = _router.Route(Ground, toIt, targetSystem: 1, targetComponent: 154, isChecked: true);
        MavlinkRoute echo = _router.Route(Ground, fromIt, targetSystem: 0, targetComponent: 0, isChecked: true);

        Assert.Equal((MavlinkRouteReason.ForUs, true, 0UL), (route.Reason, route.DeliverLocally, route.ForwardTo));
        Assert.Equal((MavlinkRouteReason.OurOwn, false, 0UL), (echo.Reason, echo.DeliverLocally, echo.ForwardTo));
        Assert.Throws<ArgumentOutOfRangeException>("componentId", () => _router.AddOwnComponent(0));
    }

    [Fact]
    public void SetLink_ForwardFromALogWhenAsked_GoesToLiveLinks()
    {
        _router.SetLink(Log, MavlinkLinkRules.ForwardFrom);

        Assert.Equal("0 1 2 4", Links(Receive(Log, 9, 1).ForwardTo));
        Assert.Equal("1 2 4", Links(Receive(Autopilot, 1, 1).ForwardTo));
    }

    [Fact]
    public void Route_TableFull_CountsWhomItCannotLearn()
    {
        var router = new MavlinkRouter(1, 191, maxSources: 1);
        router.SetLink(63, MavlinkLinkRules.Live);
        foreach (byte component in new byte[] { 1, 2, 1, 2 })
            router.Route(
                63, MavlinkFrame.Create(default(Heartbeat), 1, component, 0), Wire.Info<Heartbeat>(), isChecked: true);

        Assert.Equal((1, 2), (router.Sources, router.Counters.SourcesRefused));
        Assert.Equal((1UL << 63, 0UL), (router.LinksOf(1, 1), router.LinksOf(1, 2)));
    }

    [Fact]
    public void Counters_AfterFrames_SayWhatWasDecided()
    {
        MavlinkRouterCounters before = _router.Counters;
        Receive(Autopilot, 1, 1);
        Receive(Ground, 1, 191);
        _router.Route(
            Ground, MavlinkFrame.Create(new CommandLong { TargetSystem = 3 }, 255, 190, 0), Wire.Info<CommandLong>(),
            isChecked: true);
        AssertLinkLocal(new RadioStatus(), isLocal: true);
        MavlinkRouterCounters after = _router.Counters;

        Assert.Equal((2, 1), (after.Delivered - before.Delivered, after.Forwarded - before.Forwarded));
        Assert.Equal((1, 1, 1), (after.OurOwn - before.OurOwn, after.UnknownTargets - before.UnknownTargets,
            after.LinkLocal - before.LinkLocal));
    }

    [Fact]
    public void Constructor_AddressZero_Throws()
    {
        Assert.Throws<ArgumentOutOfRangeException>("systemId", () => new MavlinkRouter(0, 1));
        Assert.Throws<ArgumentOutOfRangeException>("componentId", () => new MavlinkRouter(1, 0));
        Assert.Throws<ArgumentOutOfRangeException>("maxSources", () => new MavlinkRouter(1, 1, 0));
        Assert.Throws<ArgumentOutOfRangeException>("link", () => _router.SetLink(64, MavlinkLinkRules.Live));
    }

    private MavlinkRoute Receive(int link, byte system, byte component) =>
        _router.Route(
            link, MavlinkFrame.Create(default(Heartbeat), system, component, 0), Wire.Info<Heartbeat>(),
            isChecked: true);

    private void SendTime(int link, byte system, uint bootTimeMs, byte component = 1) => _router.Route(
        link, MavlinkFrame.Create(new SystemTime { TimeBootMs = bootTimeMs }, system, component, 0),
        Wire.Info<SystemTime>(), isChecked: true);

    private void AssertLinkLocal<T>(T message, bool isLocal)
        where T : struct, IMavlinkMessage
    {
        MavlinkRoute route = _router.Route(
            Ground, MavlinkFrame.Create(message, 255, 190, 0), Wire.Info<T>(), isChecked: true);
        Assert.Equal(
            (MavlinkRouteReason.LinkLocal, isLocal, 0UL), (route.Reason, route.DeliverLocally, route.ForwardTo));
    }

    private static string Links(ulong mask)
    {
        IEnumerable<int> links = Enumerable.Range(0, MavlinkRouter.MaxLinks).Where(link => (mask & (1UL << link)) != 0);
        return string.Join(" ", links);
    }
}
