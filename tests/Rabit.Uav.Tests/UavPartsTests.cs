using System;
using System.Linq;
using Rabit.Core;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Tests.Shared;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Communications;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Tests.Communications;
using Rabit.Uav.Tests.HealthMonitoring;
using Rabit.Uav.Tests.ImageProcessing;
using Rabit.Uav.Tests.MissionControl;
using Rabit.Uav.GroundControl;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Uav.Tests;

/// <summary>
/// Options of the managers through the options of the whole.
/// </summary>
public sealed class UavPartsTests
{
    [Fact]
    public void Subscriptions_OfBothPlaces_AreServed()
    {
        var first = new PayloadManager<WinchState>("first");
        var second = new PayloadManager<WinchState>("second");
        var pair = new MemoryLinkPair("vehicle");
        UavOptions options = Options(pair.A);
        options.Dialect = WinchState.Dialect;
        options.OtherManagers = [first, second];
        options.Subscriptions = [new MavlinkSubscription("first") { MessageIds = [WinchState.MavlinkId] }];
        options.Communications.Subscriptions = [new MavlinkSubscription("second")];
        using UavSystem uav = UavSystem.Open(options);
        RabitReactor reactor = uav.CreateReactor(new ReactorOptions { StopsOnSignals = false });

        reactor.Start();
        byte[] bytes = Frames.Of(new WinchState { LineCentimetres = 9 });
        pair.B.Write(bytes, 0, bytes.Length);
        reactor.RunFor(TimeSpan.FromSeconds(1));
        reactor.Stop("the test is over");
        reactor.Finish();

        Assert.Equal(9, Assert.Single(first.Taken).LineCentimetres);
        Assert.Single(second.Taken);
        Assert.Equal(
            [("first", 1L), ("second", 1L)],
            uav.Communications.CountSubscriptions().Select(c => (c.Queue, c.Delivered)));
    }

    public static TheoryData<string, Action<UavOptions>> Contradictions => new()
    {
        { "SystemId is 1, but Autopilot.SystemId is 2; set one of them",
            o => (o.SystemId, o.Autopilot.SystemId) = (1, 2) },
        { "ComponentId is 192, but Autopilot.ComponentId is 193; set one of them",
            o => (o.ComponentId, o.Autopilot.ComponentId) = (192, 193) },
        { "Dialect is 'mine', but Communications.Dialect is 'other'; set one of them",
            o => (o.Dialect, o.Communications.Dialect) = (WinchState.Dialect, Other()) },
        { "Dialect is 'mine', but Autopilot.Dialect is 'other'; set one of them",
            o => (o.Dialect, o.Autopilot.Dialect) = (WinchState.Dialect, Other()) },
        { "Autopilot.MayCommand is true, but MayCommand is false", o => o.Autopilot.MayCommand = true },
        { "Communications.Links and Communications.RecordedFiles are what is opened from Links and OpenLinks; leave "
            + "them empty",
            o => o.Communications.Links = o.OpenLinks },
        { "there are links, but Without has Communications", o => o.Without = UavManagers.Communications },
        { "Without is 64, which is none of the managers", o => o.Without = (UavManagers)64 },
        { "one of OtherManagers is null", o => o.OtherManagers = [null!] },
        { "Communications is null", o => o.Communications = null! },
        { "MissionControl is null", o => o.MissionControl = null! },
        { "Dialect is null", o => o.Dialect = null! },
        { "Subscriptions is null", o => o.Subscriptions = null! },
        { "Communications.Dialect is null", o => o.Communications.Dialect = null! },
        { "Autopilot.Dialect is null", o => o.Autopilot.Dialect = null! },
        { "one of Communications.Subscriptions is null", o => o.Communications.Subscriptions = [null!] },
        { "ComponentId is 191, but Autopilot.ComponentId is 192; set one of them",
            o => (o.ComponentId, o.Autopilot.ComponentId) = (191, 192) },
        { "OpenLinks has link memory:vehicle/a more than once, the same object",
            o => o.OpenLinks = [o.OpenLinks[0], o.OpenLinks[0]] },
        { "there is a Detector, but no Camera whose pictures it could search",
            o => o.Imaging.Detector = new RednessDetector() },
        { "there is a LandingMarker, but no Camera whose pictures could show it",
            o => o.Imaging.LandingMarker = new LandingMarkerOptions { SideMetres = 0.5 } },
        { "Image Processing: the side of the landing marker is 0 m; it must be above 0, at most 20", o =>
        {
            o.Imaging.LandingMarker = new LandingMarkerOptions();
            o.Camera = new ScriptedCamera([]);
        } },
        { "laneSpacingMetres of the mission is 60.0, wider than the picture: from heightMetres 40.0 the camera sees "
            + "48.2 m across the lanes",
            o =>
            {
                o.Mission = MissionPlan.Parse(
                    MissionRig.Text().Replace("\"laneSpacingMetres\":30", "\"laneSpacingMetres\":60"), "wide");
                o.Camera = new ScriptedCamera([]);
                o.Imaging.Camera = new CameraModel { Width = 640, Height = 480, FocalX = 530, FocalY = 530 };
            } },
        { "targetMotions of the mission has rde, which is no target class; there are red,", o =>
        {
            o.Mission = MissionPlan.Parse(
                MissionRig.Text().TrimEnd().TrimEnd('}') + ", \"targetMotions\": {\"rde\": \"walking\"} }", "typo");
            o.Camera = new ScriptedCamera([]);
        } },
        { "Image Processing: target class pad has no colour, which the shape detector needs", o =>
        {
            o.Mission = MissionPlan.Parse(
                MissionRig.Text().TrimEnd().TrimEnd('}') + ", \"targetClasses\": {\"pad\": {}} }", "no colour");
            o.Camera = new ScriptedCamera([]);
        } },
        { "2 managers are named 'autopilot'", o => o.OtherManagers = [new WorkingManager("autopilot")] },
        { "vehicle messages are the work of Communications, which Without has", o =>
        {
            o.Without = UavManagers.Communications;
            o.Communications.VehicleMessageRoutes = [null!];
        } },
        { "the subscription of queue 'a' is for component 0",
            o => o.Subscriptions = [new MavlinkSubscription("a") { ComponentId = 0 }] },
        { "2 subscriptions have queue 'a'",
            o => (o.Subscriptions, o.Communications.Subscriptions) = ([new("a")], [new("a")]) },
    };

    [Theory]
    [MemberData(nameof(Contradictions))]
    public void Open_OptionsThatContradict_AreNamed(string expected, Action<UavOptions> configure)
    {
        UavOptions options = Options();
        configure(options);

        var fault = Assert.Throws<ArgumentException>(() => UavSystem.Open(options));

        Assert.Contains(expected, fault.Message);
    }

    [Fact]
    public void Open_FaultsInEveryPlace_NamesThemAll()
    {
        UavOptions options = Options();
        options.OpenLinks = [];
        options.SystemId = 0;
        options.OtherManagers = null!;
        options.Communications.FramesWaitingIn = 0;
        options.Autopilot.HeartbeatTimeout = TimeSpan.Zero;
        options.Imaging.FramesWaiting = 0;
        options.Imaging.Errors = null!;
        options.Imaging.TargetClasses = default;
        options.Fusion.MaxTracks = 0;
        options.MissionControl.MaxGapPasses = 11;
        options.Health.StatusTextPeriod = TimeSpan.Zero;

        var fault = Assert.Throws<ArgumentException>(() => UavSystem.Open(options));

        string[] expected =
        [
            "OtherManagers is null", "A UAV needs at least one link", "SystemId is 0", "Communications: FramesWaiting",
            "Autopilot Interface: HeartbeatTimeout is 00:00:00", "Image Processing: the mount and the errors",
            "Image Processing: FramesWaiting is 0", "Image Processing: there is no target class",
            "Sensor Fusion: MaxTracks is 0", "Mission Control: MaxGapPasses is 11",
            "Health Monitoring: StatusTextPeriod is 00:00:00",
        ];
        Assert.All(expected, text => Assert.Contains(text, fault.Message, StringComparison.Ordinal));
    }

    [Fact]
    public void ForAutopilot_WhatOnlyOneSets_Holds()
    {
        UavOptions options = Options();
        options.Autopilot = new AutopilotOptions
        {
            SystemId = 7,
            ComponentId = 192,
            HeartbeatTimeout = TimeSpan.FromSeconds(3),
            RequestsRates = false
        };
        options.MayCommand = true;

        AutopilotOptions made = ManagerOptions.ForAutopilot(options);

        Assert.Equal(((byte?)7, (byte)192, 3.0), (made.SystemId, made.ComponentId, made.HeartbeatTimeout.TotalSeconds));
        Assert.Equal((false, true), (made.RequestsRates, made.MayCommand));
        Assert.False(options.Autopilot.MayCommand);
    }

    [Fact]
    public void ForAutopilot_LandingMarkerIsDeclared_SendsLandingTargetsAndAsksForTheLocalPosition()
    {
        UavOptions options = Options();
        Assert.False(ManagerOptions.ForAutopilot(options).SendsLandingTarget);
        options.Imaging.LandingMarker = new LandingMarkerOptions { SideMetres = 0.5 };

        AutopilotOptions made = ManagerOptions.ForAutopilot(options);

        Assert.True(made.SendsLandingTarget);
        Assert.Single(made.RequestedRates, r => r.MessageId == LocalPositionNed.MavlinkId);
    }

    [Fact]
    public void ForCommunications_KeepsWhatTheUserSet()
    {
        UavOptions options = Options();
        options.Communications = new CommunicationsOptions
        {
            FramesWaitingIn = 17,
            PositionRateHz = 5,
            VehicleMessageBytesPerSecond = 2000
        };

        CommunicationsOptions made = ManagerOptions.ForCommunications(options, options.OpenLinks, []);

        Assert.Equal((17, 5.0, 2000), (made.FramesWaitingIn, made.PositionRateHz, made.VehicleMessageBytesPerSecond));
        Assert.Same(options.OpenLinks, made.Links);
        Assert.Empty(options.Communications.Links);
        Assert.Equal(1, Assert.Single(made.VehicleMessageRoutes).MessageType);
    }

    [Theory]
    [InlineData(UavManagers.None, true)]
    [InlineData(UavManagers.MissionControl, false)]
    public void GroundCommands_WithMissionControl_AreReceived(UavManagers without, bool expected)
    {
        UavOptions options = Options();
        (options.GroundCommands, options.Without) = (new GroundCommandOptions(), without);
        Assert.Equal(
            expected, ManagerOptions.SubscriptionsOf(options).Any(s => s.MessageIds.Contains(CommandLong.MavlinkId)));
    }

    [Fact]
    public void Open_ManagerRefusesItsOptions_ClosesTheLinks()
    {
        int port = FreePort.Udp();
        var options = new UavOptions { Links = [LinkUrl.Parse($"udpin:127.0.0.1:{port}")] };
        options.Communications.FramesWaitingIn = 0;

        var fault = Assert.Throws<ArgumentException>(() => UavSystem.Open(options));

        Assert.Contains("Communications: FramesWaitingIn is 0", fault.Message);
        using UdpListenLink again = UdpListenLink.Open("127.0.0.1", port);
    }

    private static UavOptions Options(IByteLink? link = null)
        => new() { OpenLinks = [link ?? new MemoryLinkPair("vehicle").A], Time = new VirtualTime(0) };

    private static MavlinkDialect Other() => MavlinkDialect.Combine("other", MavlinkDialect.All);
}
