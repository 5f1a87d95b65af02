using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Uav.Communications;
using Rabit.Links;
using Rabit.Uav.Messages;
using Rabit.Uav.Tests.Communications;
using Xunit;

namespace Rabit.Uav.Tests;

/// <summary>
/// All managers on the recorded flights: what they report does not depend on pace or order, and is what was flown.
/// </summary>
public sealed class UavSystemTests
{
    private static readonly string[] FlightNames = ["ardupilot-flight", "px4-flight"];

    public static TheoryData<string> Flights => [.. FlightNames];

    [Theory]
    [MemberData(nameof(Flights))]
    public void Replay_AtMaximumSpeed_AgreesWithTheSidecar(string name)
    {
        using UavSystem uav = Run(out ReactorResult result, out LinkStatus status, 0, Url(name, "max"));
        using JsonDocument sidecar = TestData.Json(name + ".json");
        JsonElement facts = sidecar.RootElement;
        LinkSummary link = Assert.Single(uav.Communications.SummariseLinks());

        Assert.Equal((0, "communications: the recorded flight is over"), (result.ExitCode, result.StopReason));
        Assert.Equal((0L, 0L, 0L), (status.FramesDroppedIn, status.FramesOut, link.BytesLost));
        Assert.Equal(facts.GetProperty("records").GetInt64(), link.Frames);
        Assert.Equal(SidecarFacts.Counts(facts), link.Counts
            .Select(c => SidecarFacts.Line(c.MessageId, c.SystemId, c.ComponentId, (int)c.Version, c.Count))
            .OrderBy(l => l, StringComparer.Ordinal));
        Assert.Equal(
            SidecarFacts.Sources(facts),
            link.Sources.Select(s => SidecarFacts.Line(s.SystemId, s.ComponentId, s.Frames, s.Missing, s.OutOfOrder)));
        Assert.All(link.Counts, c => Assert.NotNull(c.Name));
    }

    [Theory]
    [MemberData(nameof(Flights))]
    public void Replay_AnySpeedAndAnySeed_GivesTheSame(string name)
    {
        string expected;
        using (UavSystem uav = Run(out _, out _, 0, Url(name, "max")))
            expected = Describe(uav);

        for (int seed = 1; seed <= 3; seed++)
        {
            using UavSystem other = Run(out _, out _, seed, Url(name, "max"));
            Assert.True(expected == Describe(other), $"Seed {seed} gives another summary.");
        }

        using UavSystem paced = Run(out _, out _, 0, Url(name, "1000"));
        Assert.Equal(expected, Describe(paced));
    }

    [Fact]
    public void Replay_TwoLogsAtOnce_CountsEachByItself()
    {
        using UavSystem uav = Run(out ReactorResult result, out _, 0, FlightNames.Select(n => Url(n, "max")).ToArray());

        Assert.Equal("communications: all links have ended", result.StopReason);
        Assert.Equal(new long[] { 20921, 23151 }, uav.Communications.SummariseLinks().Select(l => l.Frames));
    }

    [Fact]
    public void Replay_NeverAsksForRates()
    {
        using UavSystem uav = Run(out _, out _, 0, Url(FlightNames[0], "max"));

        Assert.Equal(["HEARTBEAT"], uav.Communications.CountOwnFrames().Select(c => c.Name));
    }

    [Fact]
    public void Time_IsVirtualForAnotherSpeedThanOneAndStartsWithTheFirstStamp()
    {
        using UavSystem fast = Open(0, Url(FlightNames[1], "max"));
        using UavSystem slow = Open(0, Url(FlightNames[1], "1"));

        Assert.IsType<RealTime>(slow.Time);
        Assert.IsType<VirtualTime>(fast.Time);
        Assert.Equal(
            1795227493254076L, (fast.Time.Clock.GetUtcNow().Ticks - DateTimeOffset.FromUnixTimeSeconds(0).Ticks) / 10);
    }

    private static LinkUrl Url(string name, string speed)
        => LinkUrl.Parse($"tlog:{TestData.PathOf(name + ".tlog")}?speed={speed}");

    private static UavSystem Open(long seed, params LinkUrl[] links)
        => UavSystem.Open(new UavOptions { Links = links, Seed = seed });

    private static UavSystem Run(out ReactorResult result, out LinkStatus status, long seed, params LinkUrl[] links)
    {
        UavSystem uav = Open(seed, links);
        RabitReactor reactor = uav.CreateReactor(new ReactorOptions { StopsOnSignals = false });
        MessageSubscriber<LinkStatus> subscriber = reactor.Workspace.Subscribe<LinkStatus>(MessageNames.LinkStatus(0));
        result = reactor.Run();
        subscriber.Fetch();
        status = subscriber.Value;
        return uav;
    }

    private static string Describe(UavSystem uav)
    {
        var lines = new List<string>();
        foreach (LinkSummary link in uav.Communications.SummariseLinks())
        {
            lines.Add(SidecarFacts.Line(link.Frames, link.BytesLost, link.FirstDamageOffset ?? -1));
            lines.AddRange(
                link.Counts.Select(
                    c => SidecarFacts.Line(c.MessageId, c.SystemId, c.ComponentId, (int)c.Version, c.Count)));
            lines.AddRange(
                link.Sources.Select(
                    s => SidecarFacts.Line(s.SystemId, s.ComponentId, s.Frames, s.Missing, s.OutOfOrder)));
        }

        lines.AddRange(
            uav.Communications.CountOwnFrames()
                .Select(c => SidecarFacts.Line(c.MessageId, c.SystemId, c.ComponentId, c.Count)));
        return string.Join("\n", lines);
    }
}
