using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Links;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests;

/// <summary>Managers that are left out or replaced.</summary>
public sealed class LeftOutManagerTests
{
    public static TheoryData<UavManagers, string[]> Missing => new()
    {
        { UavManagers.Communications, [
            "Queue 'autopilot frames' has no sender, but 'autopilot' receives it: LEFTOUT, would send to it.",
            "Queue 'outgoing frames' has no receiver, but 'autopilot', 'health' send to it: LEFTOUT, would receive it.",
            "Queue 'outgoing target reports' has no receiver, but 'sensor fusion' sends to it: LEFTOUT, would "
                + "receive it.",
            "Queue 'target reports' has no sender, but 'sensor fusion' receives it: LEFTOUT, would send to it."] },
        { UavManagers.AutopilotInterface, [
            "'health' subscribes to message 'autopilot statistics', but it has no publisher: LEFTOUT, would publish "
                + "it.",
            "'mission control' subscribes to message 'command authority', but it has no publisher: LEFTOUT, would "
                + "publish it.",
            "'health' subscribes to message 'navigation', but it has no publisher: LEFTOUT, would publish it.",
            "'communications', 'image processing', 'health' subscribe to message 'own address', but it has no "
                + "publisher: LEFTOUT, would publish it.",
            "'communications', 'mission control', 'health' subscribe to message 'vehicle', but it has no publisher: "
                + "LEFTOUT, would publish it.",
            "Queue 'autopilot frames' has no receiver, but 'communications' sends to it: LEFTOUT, would receive it.",
            "Queue 'poses' has no sender, but 'image processing' receives it: LEFTOUT, would send to it.",
            "Queue 'vehicle command results' has no sender, but 'mission control' receives it: LEFTOUT, would send to "
                + "it.",
            "Queue 'vehicle commands' has no receiver, but 'mission control' sends to it: LEFTOUT, would receive "
                + "it."] },
        { UavManagers.ImageProcessing, [
            "'mission control', 'health' subscribe to message 'imaging', but it has no publisher: LEFTOUT, would "
                + "publish it.",
            "Queue 'camera observations' has no sender, but 'sensor fusion' receives it: LEFTOUT, would send to it.",
            "Queue 'poses' has no receiver, but 'autopilot' sends to it: LEFTOUT, would receive it.",
            "Queue 'searched ground' has no sender, but 'mission control' receives it: LEFTOUT, would send to it."] },
        { UavManagers.SensorFusion, [
            "'mission control' subscribes to message 'tracks', but it has no publisher: LEFTOUT, would publish it.",
            "Queue 'camera observations' has no receiver, but 'image processing' sends to it: LEFTOUT, would receive "
                + "it.",
            "Queue 'outgoing target reports' has no sender, but 'communications' receives it: LEFTOUT, would send to "
                + "it.",
            "Queue 'target reports' has no receiver, but 'communications' sends to it: LEFTOUT, would receive it.",
            "Queue 'track decisions' has no receiver, but 'mission control' sends to it: LEFTOUT, would receive it."] },
        { UavManagers.MissionControl, [
            "'image processing' subscribes to message 'imaging command', but it has no publisher: LEFTOUT, would "
                + "publish it.",
            "'health' subscribes to message 'mission', but it has no publisher: LEFTOUT, would publish it.",
            "Queue 'searched ground' has no receiver, but 'image processing' sends to it: LEFTOUT, would receive it.",
            "Queue 'track decisions' has no sender, but 'sensor fusion' receives it: LEFTOUT, would send to it.",
            "Queue 'vehicle command results' has no receiver, but 'autopilot' sends to it: LEFTOUT, would receive it.",
            "Queue 'vehicle commands' has no sender, but 'autopilot' receives it: LEFTOUT, would send to it."] },
        { UavManagers.HealthMonitoring, [
            "'mission control' subscribes to message 'health', but it has no publisher: LEFTOUT, would publish it."] },
    };

    [Theory]
    [MemberData(nameof(Missing))]
    public void Without_OneManager_TheErrorNamesEachMissingPartOnce(UavManagers without, string[] expected)
    {
        using UavSystem uav = Open(without);
        RabitReactor reactor = Reactor(uav);

        var fault = Assert.Throws<RabitWiringException>(reactor.Start);

        string leftOut = $"'{NameOf(without)}', which was left out (UavOptions.Without has {without})";
        Assert.Equal(expected.Select(e => e.Replace("LEFTOUT", leftOut)), fault.Faults);
    }

    [Fact]
    public void Without_TwoManagers_WhatOnlyTheyShareIsNotMissed()
    {
        using UavSystem uav = Open(UavManagers.ImageProcessing | UavManagers.SensorFusion);
        RabitReactor reactor = Reactor(uav);

        var fault = Assert.Throws<RabitWiringException>(reactor.Start);

        Assert.DoesNotContain("camera observations", fault.Message, StringComparison.Ordinal);
        Assert.Contains(
            "message 'tracks', but it has no publisher: 'sensor fusion', which was left out", fault.Message,
            StringComparison.Ordinal);
        Assert.Contains("Queue 'searched ground' has no sender", fault.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Without_StatusOfTheManagerLeftOut_IsMissedByName()
    {
        var own = new StatusReader("image processing");
        using UavSystem uav = Open(UavManagers.ImageProcessing, new OwnImageProcessing(), own);
        RabitReactor reactor = Reactor(uav);

        var fault = Assert.Throws<RabitWiringException>(reactor.Start);

        Assert.Equal(
            "'status reader' subscribes to message 'image processing/status', but it has no publisher: "
                + "'image processing', which was left out (UavOptions.Without has ImageProcessing), would publish it.",
            Assert.Single(fault.Faults));
    }

    [Theory]
    [InlineData(UavManagers.Communications)]
    [InlineData(UavManagers.AutopilotInterface)]
    [InlineData(UavManagers.ImageProcessing)]
    [InlineData(UavManagers.SensorFusion)]
    [InlineData(UavManagers.MissionControl)]
    [InlineData(UavManagers.HealthMonitoring)]
    public void Absent_OfEachManager_IsWhatItDeclaresItself(UavManagers manager)
    {
        using UavSystem uav = Open(UavManagers.None);
        RabitReactor reactor = Reactor(uav);
        reactor.Start();
        string[] wiring = reactor.Workspace.DescribeWiring().Split('\n');
        reactor.Stop();
        reactor.Finish();

        AbsentManager absent = Assert.Single(AbsentManagers.Of(manager));

        Assert.Equal(
            PartOf(absent.Name, "  posted by "), Sorted(absent.Publishes.Where(p => !IsLink(p) || p == "link 0")));
        Assert.Equal(PartOf(absent.Name, "  pushed by "), Sorted(absent.Sends));
        Assert.Equal(PartOf(absent.Name, "  popped by "), Sorted(absent.Receives));

        // Its devices, and its status, are its own.
        IEnumerable<string> PartOf(string name, string role) => Sorted(
            from i in Enumerable.Range(0, wiring.Length)
            where wiring[i].StartsWith(role, StringComparison.Ordinal)
            where wiring[i].Substring(role.Length).Split(',').Select(o => o.Replace(" (wakes)", "").Trim())
                .Contains(name)
            let channel = wiring.Take(i).Last(l => l.Length == 0 || l[0] != ' ')
            let begin = channel.IndexOf(' ') + 1
            let title = channel.Substring(begin, channel.IndexOf(" :", StringComparison.Ordinal) - begin)
            where title.IndexOf('/') < 0
            select title);
    }

    [Fact]
    public void Without_TheManagerIsNotThere_AndSaysSo()
    {
        using UavSystem uav = Open(UavManagers.ImageProcessing);

        var fault = Assert.Throws<InvalidOperationException>(() => uav.ImageProcessing);

        Assert.Equal("ImageProcessing was left out: UavOptions.Without has it.", fault.Message);
        Assert.NotNull(uav.SensorFusion);
    }

    [Fact]
    public void ImageProcessing_ReplacedByTheUsers_RunsInItsPlace()
    {
        var own = new OwnImageProcessing();
        using UavSystem uav = Open(UavManagers.ImageProcessing, own);
        RabitReactor reactor = Reactor(uav);

        reactor.Start();
        reactor.RunFor(TimeSpan.FromSeconds(2));
        reactor.Stop("the test is over");
        ReactorResult result = reactor.Finish();

        Assert.Equal(0, result.ExitCode);
        Assert.True(own.UnitsOfWork > 0);
    }

    private static string NameOf(UavManagers manager) => AbsentManagers.Of(manager).Single().Name;

    private static bool IsLink(string name) => name.StartsWith("link ", StringComparison.Ordinal);

    private static IEnumerable<string> Sorted(IEnumerable<string> names)
        => names.OrderBy(n => n, StringComparer.Ordinal);

    private static UavSystem Open(UavManagers without, params RabitManager[] own) => UavSystem.Open(new UavOptions
    {
        OpenLinks = without == UavManagers.Communications ? [] : [new MemoryLinkPair("vehicle").A],
        Time = new VirtualTime(0),
        Without = without,
        OtherManagers = own,
    });

    private static RabitReactor Reactor(UavSystem uav)
        => uav.CreateReactor(new ReactorOptions { StopsOnSignals = false });

    private sealed class StatusReader : RabitManager
    {
        public StatusReader(string of)
            : base("status reader")
            => SubscribeToStatus(of);

        protected override void ExecuteUnitOfWork()
        {
        }
    }

    /// <summary>The least that stands in for Image Processing.</summary>
    private sealed class OwnImageProcessing : RabitManager
    {
        private readonly QueueReceiver<PoseSample> _poses;

        public OwnImageProcessing()
            : base("own imaging")
        {
            _poses = Receive<PoseSample>(MessageNames.Poses, whenFull: QueueFullMode.DropOldest);
            Publish<ImagingStatus>(MessageNames.Imaging);
            Send<CameraObservation>(MessageNames.CameraObservations);
            Send<CameraObservation>(MessageNames.SearchedGround);
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
