using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink.Messages;
using Rabit.Uav.HealthMonitoring;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.HealthMonitoring;

public class HealthRulesTests
{
    private static readonly HealthOptions Options = new();

    [Theory]
    [InlineData(ManagerState.Running, false, 0.1, true, HealthReasons.None)]
    [InlineData(ManagerState.Running, false, 1.1, true, HealthReasons.None)]
    [InlineData(ManagerState.Running, false, 1.11, false, HealthReasons.ManagerStuck)]
    [InlineData(ManagerState.Starting, false, 0.5, true, HealthReasons.None)]
    [InlineData(ManagerState.Starting, false, 2, false, HealthReasons.ManagerStuck)]
    [InlineData(ManagerState.Faulted, false, 0.1, false, HealthReasons.ManagerFaulted)]
    [InlineData(ManagerState.Faulted, true, 10, false, HealthReasons.ManagerFaulted)]
    [InlineData(ManagerState.Running, true, 0.1, false, HealthReasons.ManagerFaulted)]
    [InlineData(ManagerState.Running, true, 10, false, HealthReasons.ManagerFaulted | HealthReasons.ManagerStuck)]
    [InlineData(ManagerState.Restarting, false, 10, false, HealthReasons.ManagerFaulted)]
    [InlineData(ManagerState.Hanging, false, 10, false, HealthReasons.ManagerHangs)]
    [InlineData(ManagerState.Created, false, 0, false, HealthReasons.None)]
    [InlineData(ManagerState.Stopped, false, 10, false, HealthReasons.None)]
    public void Manager_IsEvaluatedByStateFaultsAndSilence(
        ManagerState state, bool faultedLately, double quietSeconds, bool isAlive, HealthReasons expected)
    {
        var facts = new ManagerFacts(
            "m", state, TimeSpan.FromSeconds(0.1), 3, faultedLately, TimeSpan.FromSeconds(quietSeconds));
        var findings = new List<HealthFinding>();
        new HealthRuleSet<ManagerFacts>(HealthRules.OfManagers)
            .Evaluate(facts, facts.Name, Options, TimeSpan.Zero, findings);

        Assert.Equal(expected, ReasonsOf(findings));
        Assert.Equal(isAlive, HealthRules.IsAlive(facts, Options));
        Assert.All(findings, f => Assert.Equal((HealthLevel.Critical, "m"), (f.Level, f.Subject)));
    }

    [Theory]
    [InlineData(1.00, HealthReasons.None, HealthLevel.Unknown)]
    [InlineData(0.26, HealthReasons.None, HealthLevel.Unknown)]
    [InlineData(0.25, HealthReasons.BatteryLow, HealthLevel.Warning)]
    [InlineData(0.11, HealthReasons.BatteryLow, HealthLevel.Warning)]
    [InlineData(0.10, HealthReasons.BatteryCritical, HealthLevel.Critical)]
    [InlineData(0.00, HealthReasons.BatteryCritical, HealthLevel.Critical)]
    [InlineData(double.NaN, HealthReasons.None, HealthLevel.Unknown)]
    public void Battery_IsEvaluatedByWhatRemains(double remaining, HealthReasons expected, HealthLevel level)
        => AssertVehicle(
            Connected() with { BatteryTime = TimeSpan.Zero, BatteryRemaining = remaining }, expected, level);

    [Fact]
    public void Battery_NeverMeasured_IsNotEvaluated()
        => AssertVehicle(Connected() with { BatteryRemaining = 0 }, HealthReasons.None, HealthLevel.Unknown);

    [Theory]
    [InlineData(MavState.Active, HealthReasons.None, HealthLevel.Unknown)]
    [InlineData(MavState.Standby, HealthReasons.None, HealthLevel.Unknown)]
    [InlineData(MavState.Critical, HealthReasons.AutopilotCritical, HealthLevel.Critical)]
    [InlineData(MavState.Emergency, HealthReasons.AutopilotCritical, HealthLevel.Critical)]
    [InlineData(MavState.FlightTermination, HealthReasons.AutopilotCritical, HealthLevel.Critical)]
    public void Autopilot_ReportsACriticalState_IsCritical(MavState state, HealthReasons expected, HealthLevel level)
        => AssertVehicle(Connected() with { SystemStatus = state }, expected, level);

    [Theory]
    [InlineData(0, false, 0, false, HealthReasons.NoAutopilot, HealthLevel.Warning)]
    [InlineData(1, true, 1, false, HealthReasons.None, HealthLevel.Unknown)]
    [InlineData(1, true, 5, false, HealthReasons.None, HealthLevel.Unknown)]
    // not reported, but we can count
    [InlineData(1, true, 5.1, false, HealthReasons.AutopilotLost, HealthLevel.Critical)]
    [InlineData(1, false, 1, false, HealthReasons.AutopilotLost, HealthLevel.Critical)]
    [InlineData(1, false, 60, true, HealthReasons.None, HealthLevel.Unknown)]               // the log is at its end
    public void Autopilot_IsEvaluatedByItsHeartbeat(
        byte system, bool isConnected, double ageSeconds, bool isReplayOver, HealthReasons expected, HealthLevel level)
    {
        VehicleState state = new() { SystemId = system, IsConnected = isConnected, BatteryRemaining = double.NaN };
        AssertVehicle(state, expected, level, ageSeconds, isReplayOver);
    }

    [Theory]
    [InlineData(LinkState.Receiving, false, 100, HealthReasons.None, HealthLevel.Unknown)]
    [InlineData(LinkState.Waiting, false, 5, HealthReasons.None, HealthLevel.Unknown)]
    [InlineData(LinkState.Waiting, false, 5.1, HealthReasons.LinkSilent, HealthLevel.Warning)]
    [InlineData(LinkState.Silent, false, 1, HealthReasons.LinkSilent, HealthLevel.Warning)]
    [InlineData(LinkState.Failed, false, 1, HealthReasons.LinkDown, HealthLevel.Critical)]
    [InlineData(LinkState.Failed, true, 1, HealthReasons.LinkDown, HealthLevel.Critical)]
    [InlineData(LinkState.Ended, false, 1, HealthReasons.LinkDown, HealthLevel.Critical)]
    [InlineData(LinkState.Ended, true, 1, HealthReasons.None, HealthLevel.Unknown)]
    public void Link_IsEvaluatedByItsState(
        LinkState state, bool isRecorded, double watchedSeconds, HealthReasons expected, HealthLevel level)
    {
        var status = new LinkStatus { State = state, Url = "udp", Progress = isRecorded ? 1 : double.NaN };
        AssertLink(
            new LinkFacts(
                "udp", status, framesDropped: 0, hasDroppedRecently: false, hasRejectedRecently: false,
                TimeSpan.FromSeconds(watchedSeconds)),
            expected, level);
    }

    [Theory]
    [InlineData(true, HealthReasons.FramesDropped, HealthLevel.Warning)]
    [InlineData(false, HealthReasons.None, HealthLevel.Unknown)]
    public void Link_IsEvaluatedByFramesThatWereDroppedLately(
        bool droppedLately, HealthReasons expected, HealthLevel level)
    {
        var status = new LinkStatus
        {
            State = LinkState.Receiving,
            FramesDroppedIn = 3,
            FramesDroppedOut = 4,
            Progress = double.NaN
        };
        AssertLink(new LinkFacts("udp", status, 7, droppedLately, false, TimeSpan.Zero), expected, level);
    }

    [Theory]
    [InlineData(true, HealthReasons.SignaturesRejected, HealthLevel.Warning)]
    [InlineData(false, HealthReasons.None, HealthLevel.Unknown)]
    public void Link_IsEvaluatedByFramesThatWereRejectedLately(
        bool rejectedLately, HealthReasons expected, HealthLevel level)
    {
        var status = new LinkStatus { State = LinkState.Receiving, Progress = double.NaN };
        AssertLink(new LinkFacts("udp", status, 0, false, rejectedLately, TimeSpan.Zero), expected, level);
    }

    [Theory]
    [InlineData(true, HealthReasons.AddressConflict, HealthLevel.Warning)]
    [InlineData(false, HealthReasons.None, HealthLevel.Unknown)]
    public void Link_IsEvaluatedByFramesWithAnotherOnesAddress(
        bool isRecent, HealthReasons expected, HealthLevel level)
    {
        var status = new LinkStatus { State = LinkState.Receiving, AddressConflicts = 2, Progress = double.NaN };
        AssertLink(
            new LinkFacts("udp", status, 0, false, false, TimeSpan.Zero, isRecent), expected, level);
    }

    [Theory]
    [InlineData(0, 0, 1, HealthReasons.CommandsUnanswered, HealthLevel.Warning)]
    [InlineData(1, 0, 4, HealthReasons.None, HealthLevel.Unknown)]
    [InlineData(0, 1, 4, HealthReasons.None, HealthLevel.Unknown)]
    [InlineData(0, 0, 0, HealthReasons.None, HealthLevel.Unknown)]
    public void Vehicle_IsEvaluatedByWhetherItAnswersCommands(
        int accepted, int refused, int unanswered, HealthReasons expected, HealthLevel level)
        => AssertVehicle(
            Connected(), expected, level, requests: new RateRequestCounts(accepted, refused, unanswered, sent: 9));

    [Fact]
    public void Text_AllReasons_NamesAndFiguresMostSevereFirst()
    {
        var findings = new List<HealthFinding>
        {
            new(HealthReasons.BatteryLow, HealthLevel.Warning, null, 22),
            new(HealthReasons.LinkSilent, HealthLevel.Warning, "udpin:0.0.0.0:14550", (long)LinkState.Silent),
            new(HealthReasons.FramesDropped, HealthLevel.Warning, "1", 12),
            new(HealthReasons.ManagerStuck, HealthLevel.Critical, "autopilot", TimeSpan.FromMilliseconds(200).Ticks),
            new(HealthReasons.AutopilotLost, HealthLevel.Critical, null, TimeSpan.FromSeconds(12.34).Ticks),
        };

        Assert.Equal(
            "autopilot lost (last heartbeat at 12.3 s); manager autopilot is stuck (it should run every 0.2 s); "
            + "battery low (22 %); "
            + "link udpin:0.0.0.0:14550 is silent; link 1 dropped frames (12 so far)",
            HealthText.Of(findings));
    }

    [Fact]
    public void Text_EveryReason_IsOneBitWithARowAndWords()
    {
        HealthReasons all = HealthReasons.None;
        foreach (HealthReasons reason in EnumValues.Of<HealthReasons>())
        {
            if (reason == HealthReasons.None)
                continue;
            Assert.Equal(0, (long)reason & ((long)reason - 1));
            Assert.Equal(HealthReasons.None, all & reason);
            all |= reason;
            string text = HealthText.Of([new HealthFinding(reason, HealthLevel.Warning, "x", 5)])!;
            Assert.DoesNotContain(reason.ToString(), text, StringComparison.Ordinal);
        }

        Assert.Null(HealthText.Of([]));
    }

    [Fact]
    public void Table_EveryRow_SaysWhenItEndsAndWhy()
        => Assert.All(HealthRules.All, rule =>
        {
            Assert.NotEmpty(rule.Condition(Options));
            Assert.NotEmpty(rule.End(Options));
            Assert.NotEmpty(rule.Why);
            Assert.True(rule.Dwell(Options) >= TimeSpan.Zero);
            Assert.True(rule.ClearDwell(Options) >= TimeSpan.Zero);
        });

    [Fact]
    public void WindowedIncrease_CountThatRises_IsReportedForAWhile()
    {
        var rise = new WindowedIncrease();
        TimeSpan within = TimeSpan.FromSeconds(5);
        Assert.False(rise.Update(0, TimeSpan.FromSeconds(0), within));
        Assert.True(rise.Update(1, TimeSpan.FromSeconds(1), within));
        Assert.True(rise.Update(1, TimeSpan.FromSeconds(5.9), within));
        Assert.False(rise.Update(1, TimeSpan.FromSeconds(6), within));
        Assert.True(rise.Update(2, TimeSpan.FromSeconds(7), within));
    }

    private static VehicleState Connected()
        => new() { SystemId = 1, IsConnected = true, SystemStatus = MavState.Active };

    private static void AssertVehicle(
        VehicleState state, HealthReasons expected, HealthLevel level, double ageSeconds = 1, bool isReplayOver = false,
        RateRequestCounts requests = default)
    {
        var findings = new List<HealthFinding>();
        var facts = new VehicleFacts(state, requests, TimeSpan.FromSeconds(ageSeconds), isReplayOver);
        new HealthRuleSet<VehicleFacts>(HealthRules.OfVehicle)
            .Evaluate(facts, subject: null, Options, TimeSpan.Zero, findings);
        var battery = new HealthRuleSet<VehicleFacts>(HealthRules.OfBattery);
        battery.Evaluate(facts, subject: null, Options, TimeSpan.Zero, []);
        battery.Evaluate(facts, subject: null, Options, TimeSpan.FromSeconds(2), findings);
        new HealthRuleSet<BatteryFacts>(HealthRules.OfBatteryState)
            .Evaluate(
                new BatteryCellWatch().Update(state, TimeSpan.FromSeconds(ageSeconds), Options), subject: null, Options,
                TimeSpan.Zero, findings);
        AssertFindings(findings, expected, level, null);
    }

    private static void AssertLink(LinkFacts facts, HealthReasons expected, HealthLevel level)
    {
        var findings = new List<HealthFinding>();
        new HealthRuleSet<LinkFacts>(HealthRules.OfLinks)
            .Evaluate(facts, facts.Name, Options, TimeSpan.Zero, findings);
        AssertFindings(findings, expected, level, "udp");
    }

    private static void AssertFindings(
        List<HealthFinding> findings, HealthReasons expected, HealthLevel level, string? subject)
    {
        Assert.Equal(expected, ReasonsOf(findings));
        Assert.Equal(level, findings.Select(f => f.Level).DefaultIfEmpty(HealthLevel.Unknown).Max());
        Assert.All(findings, f => Assert.Equal(subject, f.Subject));
    }

    private static HealthReasons ReasonsOf(List<HealthFinding> findings)
        => findings.Aggregate(HealthReasons.None, (all, f) => all | f.Reason);
}
