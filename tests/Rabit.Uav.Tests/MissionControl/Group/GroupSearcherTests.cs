using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl.Group;

/// <summary>As long as lanes are left one vehicle searches, however many targets there are to follow.</summary>
public sealed class GroupSearcherTests
{
    private const string Field = "[[60,-180],[60,180],[360,180],[360,-180]]";

    // Two that are awarded a target each learn of it by their reports, and wait a little.
    private const double MaxSecondsWithoutSearcher = 5;

    [Theory]
    [InlineData(2, 2, 60)]
    [InlineData(3, 3, 60)]
    [InlineData(3, 5, 200)]
    public void Targets_AsManyAsVehicles_OneSearchesOnAndAllAreFollowedInTheEnd(
        int vehicles, int targets, double followSeconds)
    {
        using GroupRig rig = Open(vehicles, targets, followSeconds);
        double longest = RunToEnd(rig);
        Assert.True(longest <= MaxSecondsWithoutSearcher, $"{longest} s without one that searches: {rig.Story}");
        Assert.All(rig.Rigs, r => Assert.Equal(MissionOutcome.Accomplished, r.Status.Result.Outcome));
        Assert.Equal(targets, Tasks(rig).Count(t => t.Result == FollowResult.Followed));
        Assert.Contains("waits: lanes are left", rig.Story, StringComparison.Ordinal);
    }

    [Fact]
    public void Target_VehicleIsAlone_IsFollowedOnceTheLanesAreFlown()
    {
        using GroupRig rig = Open(1, 1);
        Assert.True(rig.RunUntil(() => Following(rig).Any(), 1000), rig.Story);
        Assert.True(rig.Rigs[0].Status.Coverage >= 0.98, rig.Story);
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.Equal(FollowResult.Followed, Assert.Single(Tasks(rig)).Result);
    }

    // One comes late: from then on another one is free for what waits.
    [Fact]
    public void Target_AnotherVehicleComes_IsFollowedThen()
    {
        using GroupRig rig = Open(2, 1);
        rig.SwitchedOn = 1;
        Assert.True(rig.RunUntil(() => Tasks(rig).Count > 0, 300), rig.Story);
        rig.Run(20);
        Assert.Empty(Following(rig));
        rig.SwitchedOn = 2;
        Assert.True(rig.RunUntil(() => Following(rig).Any(), 90), rig.Story);
        Assert.True(rig.Rigs[0].Status.Coverage < 0.9, rig.Story);
        Assert.Single(Following(rig));
    }

    [Fact]
    public void Searcher_IsLost_WhoFollowsAloneGoesOnAndSearchesThen()
    {
        using GroupRig rig = Open(2, 1, followSeconds: 40);
        Assert.True(rig.RunUntil(() => Following(rig).Any(), 300), rig.Story);
        int follower = Following(rig).Single();
        rig.Lost.Add(1 - follower);
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.True(rig.Rigs[follower].Status.Coverage >= 0.98, rig.Story);
        Assert.Contains(Tasks(rig), t => t.Result == FollowResult.Followed && t.Follower == follower + 1);
    }

    [Fact]
    public void Searcher_IsLostAndTwoFollow_TheFirstOfThemSearches()
    {
        using GroupRig rig = Open(3, 2, followSeconds: 300);
        Assert.True(rig.RunUntil(() => Following(rig).Count() == 2, 400), rig.Story);
        int[] followers = Following(rig).ToArray();
        rig.Lost.Add(Enumerable.Range(0, 3).Single(i => !followers.Contains(i)));
        Assert.True(rig.RunUntil(() => !Following(rig).Contains(followers[0]), 10), "within 10 s " + rig.Story);
        Assert.Contains("lanes are left, and no other vehicle searches", rig.Story, StringComparison.Ordinal);
        Assert.Equal([followers[1]], Following(rig));
        rig.Run(20);
        Assert.Equal([followers[1]], Following(rig));
        Assert.Equal(MissionPhase.Searching, rig.Rigs[followers[0]].Status.Phase);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    public void Targets_LossAndPartition_OneSearchesOn(int seed)
    {
        using GroupRig rig = Open(3, 3, seed: seed);
        rig.Loss = 0.4;
        double longest = 0;
        for (int part = 0; part < 3; part++)
        {
            // The isolated one decides by itself: there the limit is for the others.
            rig.Reaches = part == 1 ? (a, b) => (a == seed % 3) == (b == seed % 3) : (_, _) => true;
            longest = Math.Max(longest, RunToEnd(rig, maxSeconds: part == 2 ? 1500 : 60 * (part + 1)));
        }

        Assert.True(longest <= 2 * MaxSecondsWithoutSearcher, $"{longest} s without one that searches: {rig.Story}");
        Assert.All(rig.Rigs, r => Assert.Equal(MissionPhase.Done, r.Status.Phase));
        Assert.True(rig.Rigs.Max(r => r.Status.Coverage) >= 0.98, rig.Story);
    }

    // Runs to the end; the longest time in which all in the air followed, with lanes left.
    private static double RunToEnd(GroupRig rig, double maxSeconds = 1500)
    {
        double longest = 0;
        double without = 0;
        rig.RunUntil(
            () =>
            {
                int[] able = Running(rig).Where(i => rig.Rigs[i].Status.Phase
                    is MissionPhase.InTransit or MissionPhase.Searching or MissionPhase.Revisiting).ToArray();
                bool isMissed = able.Length > 0 && able.SequenceEqual(Following(rig))
                    && able.Max(i => rig.Rigs[i].Status.Coverage) < 0.97;
                without = isMissed ? without + 0.1 : 0;
                longest = Math.Max(longest, without);
                return Running(rig).All(i => rig.Rigs[i].Status.Phase is MissionPhase.Done or MissionPhase.Failed);
            },
            maxSeconds);
        return longest;
    }

    private static IEnumerable<int> Running(GroupRig rig)
        => Enumerable.Range(0, rig.SwitchedOn).Where(i => !rig.Lost.Contains(i));

    private static IEnumerable<int> Following(GroupRig rig) => Running(rig)
        .Where(i => rig.Rigs[i].Status.Phase == MissionPhase.Revisiting
            && rig.Rigs[i].Status.Text?.Contains("moving target") == true);

    private static List<FollowTask> Tasks(GroupRig rig) => Running(rig)
        .SelectMany(i => rig.StatusOf(i).Followings)
        .Where(t => t.Result != FollowResult.SameTarget)
        .GroupBy(t => (t.Finder, t.Session, t.Number))
        .Select(g => g.OrderByDescending(t => t.Decision).First()).ToList();

    // Each goes to and fro at a place of its own, so that one waits where it was last seen.
    private static GroupRig Open(int vehicles, int targets, double followSeconds = 60, int seed = 1)
    {
        var rig = new GroupRig(
            vehicles,
            MissionRig.Mission(
                ", \"targetMotions\": { \"red\": \"walking\" }, "
                    + "\"revisit\": { \"maxWayFraction\": 4, \"followSeconds\": "
                    + followSeconds.ToString(CultureInfo.InvariantCulture) + " }",
                Field),
            seed);
        for (int target = 0; target < targets; target++)
        {
            double north = 90 + (240.0 * target / targets);
            double east = (target % 2 == 0 ? -1 : 1) * (40 + (30 * target));
            for (int i = 0; i < vehicles; i++)
            {
                int home = 20 * i; // the homes are 20 m apart
                rig.Rigs[i].Vehicle.Movers.Add(
                    t => (north + (15 * Math.Sin(t.TotalSeconds / 25)), east - home));
            }
        }

        return rig;
    }
}
