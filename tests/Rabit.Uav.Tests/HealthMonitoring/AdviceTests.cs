using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.HealthMonitoring;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.HealthMonitoring;

/// <summary>What Health Monitoring advises Mission Control, and reports to the ground station.</summary>
public class AdviceTests
{
    [Theory]
    [InlineData(0.26, HealthAdvice.None)]
    [InlineData(0.25, HealthAdvice.ReturnToLaunch)]
    [InlineData(0.11, HealthAdvice.ReturnToLaunch)]
    [InlineData(0.10, HealthAdvice.Land)]
    public void Battery_InFlight_IsReturnToLaunchThenLand(double remaining, HealthAdvice expected)
    {
        using var rig = new HealthRig();
        rig.PostMission(MissionPhase.Searching);
        rig.Fly(2);
        rig.PostVehicle(remaining);
        rig.Run(1.5);
        Assert.Equal(HealthAdvice.None, rig.Report.Advice);
        rig.Run(1);
        Assert.Equal(expected, rig.Report.Advice);
        if (expected != HealthAdvice.None)
            Assert.Contains("battery", rig.Report.AdviceText!, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(MissionPhase.NoMission, false)]
    [InlineData(MissionPhase.WaitingForVehicle, false)]
    [InlineData(MissionPhase.Arming, true)]
    [InlineData(MissionPhase.TakingOff, true)]
    [InlineData(MissionPhase.InTransit, true)]
    [InlineData(MissionPhase.Searching, true)]
    [InlineData(MissionPhase.Revisiting, true)]
    [InlineData(MissionPhase.Returning, true)]
    [InlineData(MissionPhase.Landing, true)]
    [InlineData(MissionPhase.Done, false)]
    [InlineData(MissionPhase.HandedOver, false)]
    [InlineData(MissionPhase.Failed, false)]
    public void Advice_IsForMissionsInFlightOnly(MissionPhase phase, bool isAdvised)
    {
        using var rig = new HealthRig();
        rig.PostMission(phase);
        rig.PostVehicle(remaining: 0.2);
        rig.Run(3);
        Assert.Equal(isAdvised ? HealthAdvice.ReturnToLaunch : HealthAdvice.None, rig.Report.Advice);
        Assert.Equal(HealthReasons.BatteryLow, rig.Report.Reasons & HealthReasons.BatteryLow);
    }

    [Fact]
    public void Advice_ReasonIsOver_IsKept()
    {
        using var rig = new HealthRig();
        rig.PostMission(MissionPhase.Searching);
        rig.PostVehicle(remaining: 0.05);
        rig.Run(2.5);
        Assert.Equal((HealthAdvice.Land, "battery nearly empty (5 %)"), (rig.Report.Advice, rig.Report.AdviceText));
        rig.Fly(3);
        rig.PostVehicle(remaining: 0.2);
        rig.Run(0.3);
        Assert.Equal((HealthAdvice.Land, "battery nearly empty (5 %)"), (rig.Report.Advice, rig.Report.AdviceText));
    }

    [Fact]
    public void AutopilotLost_IsReturnToLaunchOnlyOnceItIsBack()
    {
        using var rig = new HealthRig();
        rig.PostMission(MissionPhase.Searching);
        rig.Fly(2);
        rig.PostVehicle(isConnected: false);
        rig.Run(3);
        Assert.Equal(
            (HealthReasons.AutopilotLost, HealthAdvice.None),
            (rig.Report.Reasons & HealthReasons.AutopilotLost, rig.Report.Advice));
        rig.Fly(1);
        Assert.Equal(HealthAdvice.ReturnToLaunch, rig.Report.Advice);
        Assert.Contains("autopilot lost", rig.Report.AdviceText!, StringComparison.Ordinal);
    }

    [Fact]
    public void AutopilotLost_OnTheGroundBefore_IsNoAdviceInFlight()
    {
        using var rig = new HealthRig();
        rig.Fly(2);
        rig.PostVehicle(isConnected: false);
        rig.Run(3);
        rig.Fly(1);
        rig.PostMission(MissionPhase.Searching);
        rig.Fly(2);
        Assert.Equal(HealthAdvice.None, rig.Report.Advice);
    }

    [Fact]
    public void Manager_FaultedOrIsStuck_IsReturnToLaunch()
    {
        var findings = new List<HealthFinding>();
        var facts = new ManagerFacts(
            "autopilot", Rabit.Core.ManagerState.Running, TimeSpan.FromSeconds(0.2), 1, true, TimeSpan.FromSeconds(9));
        new HealthRuleSet<ManagerFacts>(HealthRules.OfManagers)
            .Evaluate(facts, facts.Name, new HealthOptions(), TimeSpan.Zero, findings);
        Assert.Equal([HealthReasons.ManagerFaulted, HealthReasons.ManagerStuck], findings.Select(f => f.Reason));
        Assert.All(findings, f => Assert.Equal(HealthAdvice.ReturnToLaunch, f.Advice));
    }

    [Fact]
    public void Camera_SilentWhileItShouldSearch_IsReturnToLaunchAfterThreeSeconds()
    {
        using var rig = new HealthRig();
        rig.PostMission(MissionPhase.Searching);
        rig.Fly(10);
        rig.PostImaging(ImagingMode.Search, lastFrame: TimeSpan.FromSeconds(1));   // it was off until now
        rig.Fly(2);
        Assert.Equal(HealthReasons.None, rig.Report.Reasons);
        TimeSpan last = rig.Reactor.Now;
        rig.PostImaging(ImagingMode.Search, last);
        rig.Fly(2);
        Assert.Equal(HealthReasons.None, rig.Report.Reasons);
        rig.Fly(2);
        Assert.Equal(
            (HealthReasons.CameraSilent, HealthLevel.Warning, HealthAdvice.ReturnToLaunch),
            (rig.Report.Reasons, rig.Report.Level, rig.Report.Advice));
        Assert.Equal("the camera delivers no pictures (last at 12.0 s)", rig.Report.AdviceText);
    }

    [Fact]
    public void Detector_AtFault_IsReportedForAWhileWithoutAdvice()
    {
        using var rig = new HealthRig();
        rig.PostMission(MissionPhase.Searching);
        rig.Fly(10);
        rig.PostImaging(ImagingMode.Off, lastFrame: null, detectorFailures: 2);
        rig.Fly(2);
        Assert.Equal(
            (HealthReasons.DetectorFault, HealthLevel.Warning, HealthAdvice.None),
            (rig.Report.Reasons, rig.Report.Level, rig.Report.Advice));
        Assert.Equal("the target detector is at fault (2 times so far)", rig.Report.Text);
        rig.Fly(5);
        Assert.Equal(HealthReasons.None, rig.Report.Reasons);
    }

    [Fact]
    public void Pictures_UnusableWhileATargetIsFollowed_AreNoReasonToHold()
    {
        using var rig = new HealthRig();
        rig.PostMission(MissionPhase.Revisiting);
        FlyWithBlur(rig, ImagingMode.Follow, 60);
        Assert.Equal((HealthReasons.None, HealthAdvice.None), (rig.Report.Reasons, rig.Report.Advice));
        FlyWithBlur(rig, ImagingMode.Search, 5);
        Assert.Equal(
            (HealthReasons.PicturesUnusable, HealthAdvice.Hold), (rig.Report.Reasons, rig.Report.Advice));
        FlyWithBlur(rig, ImagingMode.Follow, 5);
        Assert.Equal((HealthReasons.None, HealthAdvice.None), (rig.Report.Reasons, rig.Report.Advice));
    }

    [Fact]
    public void Camera_SilentWhileATargetIsFollowed_IsReturnToLaunch()
    {
        using var rig = new HealthRig();
        rig.PostMission(MissionPhase.Revisiting);
        rig.PostImaging(ImagingMode.Follow, lastFrame: TimeSpan.FromSeconds(1));
        rig.Fly(10);
        Assert.Equal(
            (HealthReasons.CameraSilent, HealthAdvice.ReturnToLaunch), (rig.Report.Reasons, rig.Report.Advice));
    }

    private static void FlyWithBlur(HealthRig rig, ImagingMode mode, int seconds)
    {
        for (int i = 0; i < seconds; i++)
        {
            rig.PostImaging(mode, rig.Reactor.Now, usableShare: 0.1);
            rig.Fly(1);
        }
    }

    [Theory]
    [InlineData(ImagingMode.Off, true)]
    [InlineData(ImagingMode.Search, false)]
    public void Camera_OffOrNone_IsNotMissed(ImagingMode mode, bool hasCamera)
    {
        using var rig = new HealthRig();
        rig.PostMission(MissionPhase.Searching);
        rig.PostImaging(mode, lastFrame: null, hasCamera);
        rig.Fly(20);
        Assert.Equal((HealthReasons.None, HealthAdvice.None), (rig.Report.Reasons, rig.Report.Advice));
    }

    [Fact]
    public void Wind_TooStrongForFiveSeconds_IsReturnToLaunch()
    {
        using var rig = new HealthRig();
        rig.PostMission(MissionPhase.Searching);
        rig.PostLink();
        void Blow(double metresPerSecond, int seconds)
        {
            for (int i = 0; i < seconds; i++)
            {
                rig.PostVehicle(wind: metresPerSecond);
                rig.Run(1);
            }
        }

        Blow(12, 10);
        Blow(15, 4);
        Blow(11, 1);
        Blow(15, 4);
        Assert.Equal((HealthReasons.None, HealthAdvice.None), (rig.Report.Reasons, rig.Report.Advice));
        Blow(15, 2);
        Assert.Equal((HealthReasons.WindHigh, HealthAdvice.ReturnToLaunch), (rig.Report.Reasons, rig.Report.Advice));
        Assert.Equal("wind too strong (15 m/s)", rig.Report.AdviceText);
        Blow(double.NaN, 6);
        Assert.Equal(HealthReasons.None, rig.Report.Reasons);
    }

    [Fact]
    public void Texts_LevelChanges_AreSentOnceAndNotTooOften()
    {
        using var rig = new HealthRig();
        rig.PostAddress();
        rig.Fly(10);
        Assert.Empty(Texts(rig));

        rig.PostLink(LinkState.Silent);
        rig.PostVehicle();
        rig.Run(0.3);
        Statustext text = Assert.Single(Texts(rig));
        Assert.Equal(
            (MavSeverity.Warning, "Rabit: link udpin:0.0.0.0:14550 is silent", 0),
            (text.Severity, text.Text.ToString(), text.Id));
        for (int i = 0; i < 20; i++)
        {
            rig.PostVehicle(state: i % 2 == 0 ? MavState.Critical : MavState.Active);
            rig.Run(0.5);
        }

        Assert.InRange(Texts(rig).Count, 2, 3);
        Assert.Equal(MavSeverity.Critical, Texts(rig)[1].Severity);
        rig.Fly(10);
        Statustext last = Texts(rig)[Texts(rig).Count - 1];
        Assert.Equal((MavSeverity.Info, "Rabit: all OK"), (last.Severity, last.Text.ToString()));
    }

    [Fact]
    public void Texts_Advice_IsSent()
    {
        using var rig = new HealthRig();
        rig.PostAddress();
        rig.PostMission(MissionPhase.Searching);
        rig.Fly(1);
        rig.PostVehicle(remaining: 0.2);
        rig.Run(2.5);
        Assert.Equal("Rabit: return to launch! battery low (20 %)", Texts(rig).Single().Text.ToString());
    }

    [Theory]
    [InlineData(43, 1)]
    [InlineData(44, 2)]
    [InlineData(92, 2)]
    [InlineData(93, 3)]
    [InlineData(1000, 4)]
    public void Texts_LongOnes_AreCutIntoChunksThatEndWithAShorterOne(int length, int chunks)
    {
        var texts = new StatusTextSender(TimeSpan.FromSeconds(5));
        var report = new HealthReport { Level = HealthLevel.Warning, Text = new string('x', length) };
        IReadOnlyList<Statustext> cut = texts.NextChunks(report, TimeSpan.Zero);
        Assert.Equal(chunks, cut.Count);
        Assert.Equal(Enumerable.Range(0, chunks), cut.Select(p => (int)p.ChunkSeq));
        Assert.Equal(chunks == 1, cut[0].Id == 0);
        string whole = string.Concat(cut.Select(p => p.Text.ToString()));
        Assert.Equal("Rabit: " + new string('x', Math.Min(length, 192)), whole);
        if (chunks > 1)
            Assert.True(cut[chunks - 1].Text.ToString().Length < 50);
    }

    [Fact]
    public void Texts_OutsideOfAscii_AreReadAsTheyWere()
    {
        var texts = new StatusTextSender(TimeSpan.FromSeconds(5));
        string text = string.Concat(Enumerable.Repeat("5 \u20ac, 30 \u00b0C, \U0001F681; ", 5));
        var report = new HealthReport { Level = HealthLevel.Warning, Text = text };
        var receiver = new MavlinkStatusTextReceiver();
        var sender = new MavlinkSender(1, 191);
        foreach (Statustext chunk in texts.NextChunks(report, TimeSpan.Zero))
            receiver.Handle(sender.Create(chunk), TimeSpan.Zero);
        Assert.True(receiver.TryTake(TimeSpan.Zero, out MavlinkStatusText read));
        Assert.Equal(("Rabit: " + text, true), (read.Text, read.IsComplete));
    }

    private static IReadOnlyList<Statustext> Texts(HealthRig rig) => rig.Sink.MessagesOf<Statustext>();
}
