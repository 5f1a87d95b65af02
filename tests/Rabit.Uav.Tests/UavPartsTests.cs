using System;
using System.Linq;
using Rabit.Core;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Rabit.Uav.Tests.Communications;
using Xunit;

namespace Rabit.Uav.Tests;

/// <summary>
/// Options of the managers through the options of the whole, and managers that are left out or replaced.
/// </summary>
public sealed class UavPartsTests
{
    [Theory]
    [InlineData(UavManagers.Communications,
        "Queue 'outgoing frames' has no receiver, but 'autopilot', 'health' sends to it.")]
    [InlineData(UavManagers.AutopilotInterface,
        "subscribes to message 'own address', but|Queue 'autopilot frames' has no receiver|message 'vehicle'")]
    [InlineData(UavManagers.ImageProcessing,
        "subscribes to message 'imaging', but|Queue 'poses' has no receiver, but 'autopilot' sends to it.")]
    [InlineData(UavManagers.SensorFusion, "subscribes to message 'tracks', but|Queue 'target reports' has no receiver")]
    [InlineData(UavManagers.MissionControl,
        "subscribes to message 'mission', but|Queue 'vehicle command results' has no receiver, but 'autopilot' sends "
            + "to it.")]
    [InlineData(UavManagers.HealthMonitoring, "subscribes to message 'health', but")]
    public void Without_OneManager_TheWiringNamesWhatIsMissing(UavManagers without, string expected)
    {
        UavOptions options = Options();
        options.Without = without;
        if (without == UavManagers.Communications)
            options.OpenLinks = [];
        using UavSystem uav = UavSystem.Open(options);
        RabitReactor reactor = uav.CreateReactor(new ReactorOptions { StopsOnSignals = false });

        var fault = Assert.Throws<RabitWiringException>(reactor.Start);

        Assert.All(expected.Split('|'), text => Assert.Contains(text, fault.Message));
    }

    [Fact]
    public void Without_TheManagerIsNotThere_AndSaysSo()
    {
        UavOptions options = Options();
        options.Without = UavManagers.ImageProcessing;
        using UavSystem uav = UavSystem.Open(options);

        var fault = Assert.Throws<InvalidOperationException>(() => uav.ImageProcessing);

        Assert.Equal("ImageProcessing was left out: UavOptions.Without has it.", fault.Message);
        Assert.NotNull(uav.SensorFusion);
    }

    [Fact]
    public void ImageProcessing_ReplacedByTheUsers_RunsInItsPlace()
    {
        var own = new OwnImageProcessing();
        UavOptions options = Options();
        options.Without = UavManagers.ImageProcessing;
        options.OtherManagers = [own];
        using UavSystem uav = UavSystem.Open(options);
        RabitReactor reactor = uav.CreateReactor(new ReactorOptions { StopsOnSignals = false });

        reactor.Start();
        reactor.RunFor(TimeSpan.FromSeconds(2));
        reactor.Stop("the test is over");
        ReactorResult result = reactor.Finish();

        Assert.Equal(0, result.ExitCode);
        Assert.True(own.UnitsOfWork > 0);
    }

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
        { "Dialect or Subscriptions is null, or that of Communications", o => o.Dialect = null! },
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
        Assert.Equal(42001, Assert.Single(made.VehicleMessageRoutes).PayloadType);
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

    /// <summary>The least that stands in for Image Processing.</summary>
    private sealed class OwnImageProcessing : RabitManager
    {
        private readonly QueueReceiver<PoseSample> _poses;

        public OwnImageProcessing()
            : base("own imaging")
        {
            _poses = Receive<PoseSample>(MessageNames.Poses, whenFull: QueueFullMode.DropOldest);
            Publish<ImagingStatus>(MessageNames.Imaging);
            WakeUpDelay = TimeSpan.FromMilliseconds(100);
        }

        public int UnitsOfWork { get; private set; }

        protected override void ExecuteUnitOfWork()
        {
            while (_poses.TryPop(out _))
            {
            }

            UnitsOfWork++;
        }
    }
}
