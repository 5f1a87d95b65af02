using System;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl.Group;

/// <summary>The heights of the goals of a vehicle in a group, while its barometer drifts.</summary>
public sealed class HeightOffsetTests
{
    private const string Field = "[[60,-180],[60,180],[360,180],[360,-180]]";

    // By its receiver it is higher than by its barometer: it flies lower by that, and the other way round.
    [Theory]
    [InlineData(3, 37)]
    [InlineData(-3, 43)]
    [InlineData(12, 35)]
    [InlineData(-12, 45)]
    public void Goals_BarometerDrifts_FollowItByUpToFiveMetres(double above, double expected)
    {
        using GroupRig rig = Open();
        Drift(rig, above);
        Assert.Equal(expected, LastGoal(rig), 0.6);
        Assert.InRange(rig.Rigs[0].Vehicle.Height, expected - 1, expected + 1);
    }

    // What was always so is no drift.
    [Fact]
    public void Goals_ReceiverIsOffFromTheStart_AreThoseOfTheMission()
    {
        using GroupRig rig = Open();
        rig.Rigs[0].Vehicle.GnssAboveMetres = 4;
        Drift(rig, 4);
        Assert.Equal(40, LastGoal(rig), 0.01);
    }

    [Fact]
    public void Goals_ReceiverIsKnownOnlyInTheAir_AreThoseOfTheMission()
    {
        using GroupRig rig = Open();
        rig.Rigs[0].Vehicle.GnssAboveMetres = null;
        Drift(rig, 4);
        Assert.Equal(40, LastGoal(rig), 0.01);
    }

    [Theory]
    [InlineData(-8, ", \"limits\": { \"maxHeightMetres\": 44 }", 42)]
    [InlineData(-8, ", \"limits\": { \"maxHeightMetres\": 50 }, \"revisit\": { \"heightMetres\": 46 }", 42)]
    [InlineData(8, ", \"revisit\": { \"heightMetres\": 7 }", 38)]
    public void Goals_BarometerDrifts_StayInsideTheLimitsOfTheMission(
        double above, string limits, double expected)
    {
        using GroupRig rig = Open(limits);
        Drift(rig, above);
        Assert.Equal(expected, LastGoal(rig), 0.01);
    }

    // A vehicle that was held low climbs in place first, to the height that its goal has.
    [Fact]
    public void Continue_LowWithADriftedBarometer_GoesOnSearching()
    {
        using GroupRig rig = Open();
        Drift(rig, 5);
        rig.Rigs[0].Manager.Land("test", "weather");
        Assert.True(rig.RunUntil(() => rig.Rigs[0].Vehicle.Height < 15, 120), rig.Story);
        rig.Rigs[0].Manager.Hold("test", "wait");
        rig.Run(5);
        rig.Rigs[0].Manager.ContinueMission("test", "go on");
        Assert.True(rig.RunUntil(() => rig.Rigs[0].Status.Phase == MissionPhase.Searching, 200), rig.Story);
    }

    private static GroupRig Open(string limits = "")
    {
        // Of more vehicles the higher ones would be above such limits.
        var rig = new GroupRig(limits.Length == 0 ? 2 : 1, MissionRig.Mission(limits, Field));
        rig.Rigs[0].Vehicle.GnssAboveMetres = 0;
        return rig;
    }

    // While it searches, and until that is known.
    private static void Drift(GroupRig rig, double above)
    {
        Assert.True(rig.RunUntil(() => rig.Rigs[0].Status.Phase == MissionPhase.Searching, 200), rig.Story);
        rig.Rigs[0].Vehicle.GnssAboveMetres = above;
        rig.Run(90);
        Assert.Equal(MissionPhase.Searching, rig.Rigs[0].Status.Phase);
    }

    private static double LastGoal(GroupRig rig)
    {
        string goal = rig.Rigs[0].Decisions.Last(d => d.Contains("go to", StringComparison.Ordinal));
        return double.Parse(
            Regex.Match(goal, @"height (\d+\.\d+) m").Groups[1].Value, CultureInfo.InvariantCulture);
    }
}
