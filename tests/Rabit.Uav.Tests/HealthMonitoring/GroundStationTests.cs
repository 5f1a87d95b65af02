using System;
using Rabit.Core;
using Rabit.Uav.HealthMonitoring;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.HealthMonitoring;

/// <summary>The loss of the ground station, by the times of the mission; and gusts.</summary>
public class GroundStationTests
{
    [Fact]
    public void GroundStation_NeverReceived_IsNotLost()
    {
        using var rig = new HealthRig();
        rig.PostMission(MissionPhase.Searching);
        rig.Fly(60);
        Assert.Equal((HealthReasons.None, HealthAdvice.None), (rig.Report.Reasons, rig.Report.Advice));
    }

    [Theory]
    [InlineData(3, HealthReasons.None, HealthAdvice.None)]
    [InlineData(6, HealthReasons.GroundStationLost, HealthAdvice.None)]
    [InlineData(11, HealthReasons.GroundStationLost, HealthAdvice.Hold)]
    [InlineData(31, HealthReasons.GroundStationLost, HealthAdvice.ReturnToLaunch)]
    public void GroundStation_Silent_IsWarnedOfHeldForAndReturnedFor(
        int seconds, HealthReasons reasons, HealthAdvice advice)
    {
        using HealthRig rig = RigWith(new GroundStationLoss());
        TimeSpan last = Receive(rig, 10);
        Lose(rig, last, seconds);
        Assert.Equal((reasons, advice), (rig.Report.Reasons, rig.Report.Advice));
    }

    [Theory]
    [InlineData(null, null, HealthAdvice.None)]
    [InlineData(10, null, HealthAdvice.Hold)]
    [InlineData(null, 60, HealthAdvice.ReturnToLaunch)]
    public void GroundStation_Silent_IsAsTheMissionSays(int? holdAfter, int? returnAfter, HealthAdvice advice)
    {
        using HealthRig rig = RigWith(new GroundStationLoss
        {
            HoldAfter = holdAfter is { } hold ? TimeSpan.FromSeconds(hold) : null,
            ReturnAfter = returnAfter is { } back ? TimeSpan.FromSeconds(back) : null,
        });
        Lose(rig, Receive(rig, 5), 70);
        Assert.Equal((HealthReasons.GroundStationLost, advice), (rig.Report.Reasons, rig.Report.Advice));
    }

    [Fact]
    public void GroundStation_IsBack_EndsTheHoldAfterThreeSeconds()
    {
        using HealthRig rig = RigWith(new GroundStationLoss());
        Lose(rig, Receive(rig, 5), 15);
        Assert.Equal(HealthAdvice.Hold, rig.Report.Advice);
        Receive(rig, 2);
        Assert.Equal(HealthAdvice.Hold, rig.Report.Advice);
        Receive(rig, 3);
        Assert.Equal((HealthReasons.None, HealthAdvice.None), (rig.Report.Reasons, rig.Report.Advice));
    }

    [Fact]
    public void Gusts_AboveTheirLimitInTwoSeconds_AreReturnToLaunch()
    {
        using var rig = new HealthRig();
        rig.PostMission(MissionPhase.Searching);
        rig.PostLink();
        void Blow(params double[] metresPerSecond)
        {
            foreach (double speed in metresPerSecond)
            {
                rig.PostVehicle(wind: speed);
                rig.PostLink();
                rig.Run(1);
            }
        }

        Blow(8, 8, 8, 30, 8, 8, 8, 8);   // one estimate is an outlier
        Assert.Equal(HealthReasons.None, rig.Report.Reasons);
        Blow(8, 8, 8, 8, 8, 8, 17, 17, 17, 8, 8, 8, 8, 8, 8, 8);
        Assert.Equal(HealthReasons.None, rig.Report.Reasons);
        Blow(8, 8, 18.4, 19, 8);
        Assert.Equal((HealthReasons.WindHigh, HealthAdvice.ReturnToLaunch), (rig.Report.Reasons, rig.Report.Advice));
        Assert.Equal("gusts too strong (18 m/s)", rig.Report.AdviceText);
        Blow(8, 8, 8, 8, 8, 8);
        Assert.Equal(HealthReasons.WindHigh, rig.Report.Reasons);
        Blow(8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8);
        Assert.Equal(HealthReasons.None, rig.Report.Reasons);
    }

    private static HealthRig RigWith(GroundStationLoss loss)
    {
        var rig = new HealthRig(new VirtualTime(1), new HealthOptions { GroundStationLoss = loss });
        rig.PostMission(MissionPhase.Searching);
        return rig;
    }

    private static TimeSpan Receive(HealthRig rig, int seconds)
    {
        TimeSpan last = default;
        for (int i = 0; i < seconds; i++)
        {
            last = rig.Reactor.Now;
            Lose(rig, last, 1);
        }

        return last;
    }

    private static void Lose(HealthRig rig, TimeSpan last, int seconds)
    {
        for (int i = 0; i < seconds; i++)
        {
            rig.PostVehicle();
            rig.PostLink(groundStation: last);
            rig.Run(1);
        }
    }
}
