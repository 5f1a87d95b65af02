using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl.Group;

/// <summary>A target that moves is followed by one vehicle of a group, and the others fly its lanes.</summary>
public sealed class GroupFollowingTests
{
    private const string ForwardCamera = ", \"camera\": { \"pitchDegrees\": -45 }";
    private const string Field = "[[60,-180],[60,180],[360,180],[360,-180]]";

    [Fact]
    public void Target_Moves_IsFollowedByOneAndTheOthersTakeOverItsLanes()
    {
        using GroupRig rig = Open(3, followSeconds: 40);
        Add(rig, Walker(0.5));
        Assert.True(rig.RunUntil(() => Following(rig).Length > 0, 300), rig.Story);
        int follower = Following(rig)[0];
        Assert.True(rig.RunUntil(() => Others(rig, follower).All(i => LanesOf(rig, i, follower) == 0), 8), rig.Story);
        Assert.True(rig.RunUntil(() => rig.Rigs[follower].Vehicle.Sees(0), 30), rig.Story);
        for (int i = 0; i < 30; i++)
        {
            rig.Run(1);
            Assert.True(rig.Rigs[follower].Vehicle.Sees(0), $"out of view at {rig.Seconds}: {rig.Story}");
            Assert.Equal([follower], Following(rig));
            Assert.Equal(ImagingMode.Follow, rig.Rigs[follower].Vehicle.Imaging.Mode);
        }

        Assert.True(rig.RunToEnd(), rig.Story);
        FollowTask task = Assert.Single(Tasks(rig));
        Assert.Equal(FollowResult.Followed, task.Result);
        Assert.True(task.InView >= TimeSpan.FromSeconds(40), rig.Story);
        Assert.All(rig.Rigs, r => Assert.Equal(MissionOutcome.Accomplished, r.Status.Result.Outcome));
        Assert.Equal(
            1,
            rig.Rigs.Sum(r => r.Decisions.Count(d => d.Contains("Searching -> Revisiting: to follow moving target"))));
    }

    [Fact]
    public void Target_OfAMovingClassStandsStill_IsFollowedOnce()
    {
        using GroupRig rig = Open(2, followSeconds: 20);
        Add(rig, _ => (200, 20));
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.Equal(FollowResult.Followed, Assert.Single(Tasks(rig)).Result);
        Assert.Equal(1, rig.Rigs.Sum(r => r.Status.Revisits));
    }

    [Fact]
    public void Target_FoundAlone_IsFollowedByTheFinder()
    {
        using GroupRig rig = Open(1, followSeconds: 20);
        Add(rig, Walker(0.5));
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.Equal(FollowResult.Followed, Assert.Single(Tasks(rig)).Result);
    }

    // Over the target a camera that is fixed and looks forward does not show it.
    [Fact]
    public void Target_CameraOfOneIsFixedAndLooksForward_IsFollowedByTheOther()
    {
        using GroupRig rig = Open(2, followSeconds: 20, cameraOfAllButTheLast: ForwardCamera);
        Add(rig, Walker(0.5));
        Assert.True(rig.RunToEnd(), rig.Story);

        FollowTask task = Assert.Single(Tasks(rig));
        Assert.Equal((FollowResult.Followed, (byte)2), (task.Result, task.Follower));
        Assert.DoesNotContain(rig.Rigs[0].Decisions, d => d.Contains("to follow moving target"));
        Assert.Single(
            rig.Rigs[0].Decisions,
            d => d.Contains("needs a camera that looks down, or a gimbal, to be followed: not for us"));
    }

    // One that is silent is not pointed.
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Target_CameraIsOnAGimbal_IsForItWhereTheGimbalReports(bool reports)
    {
        using GroupRig rig = Open(
            2, followSeconds: 20, cameraOfAllButTheLast: ForwardCamera.Replace("}", ", \"gimbal\": true }"));
        rig.Lost.Add(1);
        MissionRig first = rig.Rigs[0];
        first.Vehicle.More = (ref VehicleState state) =>
        {
            state.Attitude = EulerAngles.FromRadians(0, 0, first.Vehicle.Yaw);
            state.GimbalTime = reports ? first.Now : null;
        };
        Add(rig, Walker(0.5));
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.Equal(reports, rig.Rigs[0].Decisions.Any(d => d.Contains("to follow moving target 1 of vehicle 1")));
    }

    [Fact]
    public void Follower_IsLost_AnotherOneFollows()
    {
        using GroupRig rig = Open(3, followSeconds: 120);
        Add(rig, Walker(0.5));
        Assert.True(rig.RunUntil(() => Following(rig).Length > 0, 300), rig.Story);
        rig.Run(15);
        int lost = Following(rig)[0];
        rig.Lost.Add(lost);
        Assert.True(rig.RunUntil(() => Following(rig).Any(i => rig.Rigs[i].Vehicle.Sees(0)), 60), rig.Story);
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.Contains(Tasks(rig), t => t.Result == FollowResult.Followed && t.Follower != lost + 1);
    }

    [Fact]
    public void Follower_BatteryIsLow_IsRelievedWithTheTargetInView()
    {
        using GroupRig rig = Open(3, followSeconds: 400, area: "[[60,-80],[60,80],[360,80],[360,-80]]");
        Add(rig, Walker(0.3));
        Assert.True(rig.RunUntil(() => Following(rig).Length > 0, 300), rig.Story);
        int first = Following(rig)[0];
        Assert.True(rig.RunUntil(() => rig.Rigs[first].Vehicle.Sees(0), 40), rig.Story);
        double from = rig.Seconds;
        StandInVehicle vehicle = rig.Rigs[first].Vehicle;
        double unseen = 0;
        Assert.True(
            rig.RunUntil(
                () =>
                {
                    vehicle.Battery = Math.Max(0.05, 0.5 - ((rig.Seconds - from) * 0.002));
                    bool isSeen = Following(rig).Any(i => rig.Rigs[i].Vehicle.Sees(0));
                    unseen += isSeen ? 0 : 0.1;
                    return Following(rig).SequenceEqual([.. Others(rig, first).Intersect(Following(rig))])
                        && Following(rig).Length == 1;
                },
                300),
            rig.Story);
        Assert.True(unseen <= 1, $"{unseen} s unseen: {rig.Story}");
        Assert.Contains("another one is to relieve us", rig.Story);
        Assert.True(rig.RunUntil(() => rig.Rigs[first].Status.Phase == MissionPhase.Returning, 300), rig.Story);
    }

    [Fact]
    public void Target_IsLostAndSeenAgain_IsFollowedOn()
    {
        // So high that from one turn of the search what lies at the one before is in view.
        using GroupRig rig = Open(2, followSeconds: 60, firstLayer: 1);
        double? hidden = null;
        Func<TimeSpan, (double, double)?> walker = Walker(0.8);
        Add(rig, t => hidden is { } from && t.TotalSeconds > from && t.TotalSeconds < from + 20 ? null : walker(t));
        Assert.True(rig.RunUntil(() => Following(rig).Any(i => rig.Rigs[i].Vehicle.Sees(0)), 300), rig.Story);
        rig.Run(5);
        hidden = rig.Rigs[0].Now.TotalSeconds;
        Assert.True(rig.RunUntil(() => Tasks(rig).Any(t => t.Progress == FollowProgress.Searching), 15), rig.Story);
        Assert.True(rig.RunUntil(() => Tasks(rig).Any(t => t.Progress == FollowProgress.InView), 40), rig.Story);
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.Equal(FollowResult.Followed, Assert.Single(Tasks(rig)).Result);
    }

    [Fact]
    public void Target_IsGone_IsSearchedForAndGivenUpAndTheSearchGoesOn()
    {
        using GroupRig rig = Open(2, followSeconds: 60);
        double? gone = null;
        Func<TimeSpan, (double, double)?> walker = Walker(0.8);
        Add(rig, t => t.TotalSeconds > gone ? null : walker(t));
        Assert.True(rig.RunUntil(() => Following(rig).Any(i => rig.Rigs[i].Vehicle.Sees(0)), 300), rig.Story);
        rig.Run(5);
        gone = rig.Rigs[0].Now.TotalSeconds;
        int follower = Following(rig)[0];
        int from = rig.Rigs[follower].Vehicle.Path.Count;
        Assert.True(rig.RunUntil(() => Following(rig).Length == 0, 90), rig.Story);
        double[] north = rig.Rigs[follower].Vehicle.Path.Skip(from).Select(p => p.North).ToArray();
        Assert.InRange(north.Max() - north.Min(), 40, 230);
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.Equal(FollowResult.Lost, Assert.Single(Tasks(rig)).Result);
        Assert.Contains("is lost: searched for within 100.0 m", rig.Story);
        Assert.All(rig.Rigs, r => Assert.Equal(MissionOutcome.Accomplished, r.Status.Result.Outcome));
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Target_OperatorRejectsIt_IsFollowedByNone(bool isRejectedByItsFollower)
    {
        using GroupRig rig = Open(2, followSeconds: 300);
        Add(rig, Walker(0.5));
        Assert.True(rig.RunUntil(() => Following(rig).Any(i => rig.Rigs[i].Vehicle.Sees(0)), 300), rig.Story);
        rig.Run(3);
        int follower = Following(rig)[0];
        int rejects = isRejectedByItsFollower ? follower : 1 - follower;
        if (!isRejectedByItsFollower)
            Assert.True(rig.RunUntil(() => rig.Rigs[rejects].Status.TracksConfirmed == 1, 250), rig.Story);
        rig.Rigs[rejects].Manager.Reject(101, "test", "a dog");
        Assert.True(rig.RunUntil(() => Following(rig).Length == 0, 3), rig.Story);
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.Equal(FollowResult.Rejected, Assert.Single(Tasks(rig)).Result);
        Assert.Contains("rejected by the operator", rig.Story, StringComparison.Ordinal);
        Assert.Equal(1, rig.Rigs.Sum(r => r.Decisions.Count(d => d.Contains("-> Revisiting"))));
    }

    // It is in view of both; only one receives the operator.
    [Fact]
    public void Target_RejectedBehindAPartition_TheTrackOfTheOtherIsRejectedAfterIt()
    {
        using GroupRig rig = Open(2, followSeconds: 600);
        Add(rig, Walker(0.5));
        Assert.True(rig.RunUntil(() => Following(rig).Any(i => rig.Rigs[i].Vehicle.Sees(0)), 300), rig.Story);
        int other = 1 - Following(rig)[0];
        Assert.True(rig.RunUntil(() => rig.Rigs[other].Status.TracksConfirmed == 1, 400), rig.Story);
        rig.Run(2);
        rig.Reaches = (_, _) => false;
        rig.Rigs[other].Manager.Reject(101, "test", "a dog");
        rig.Run(25);
        rig.Reaches = (_, _) => true;
        rig.Run(5);
        Assert.Empty(Following(rig));
        Assert.Equal(0, rig.Rigs[1 - other].Status.TracksConfirmed);
    }

    // Before it is confirmed no task of it is there; another vehicle announces it afterwards.
    [Fact]
    public void Target_OperatorRejectsItsTentativeTrack_IsFollowedByNone()
    {
        using GroupRig rig = Open(2, followSeconds: 60);
        Add(rig, Walker(0.5));
        int? first = null;
        Assert.True(
            rig.RunUntil(
                () => (first = Enumerable.Range(0, 2).Where(i => rig.Rigs[i].Vehicle.Tracks.Count > 0)
                    .Select(i => (int?)i).FirstOrDefault()) is not null,
                300),
            rig.Story);
        Assert.Equal(TrackState.Tentative, Assert.Single(rig.Rigs[first!.Value].Vehicle.Tracks).State);
        rig.Rigs[first.Value].Manager.Reject(101, "test", "a dog");
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.All(Tasks(rig), t => Assert.Equal(FollowResult.Rejected, t.Result));
        Assert.DoesNotContain("to follow moving target", rig.Rigs[first.Value].Story, StringComparison.Ordinal);
    }

    // Another one of its class has come beside it since then.
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Target_RejectedAfterItWasFollowed_ATrackThatBeganLaterBesideItIsNot(bool isRejectedAtOnce)
    {
        using GroupRig rig = Open(2, followSeconds: 10);
        double? followed = null;
        Add(rig, _ => (200, 20));
        Add(rig, t => t.TotalSeconds > followed + 15 ? (202, 24) : null);
        Assert.True(rig.RunUntil(() => Tasks(rig).Any(t => t.Result == FollowResult.Followed), 600), rig.Story);
        followed = rig.Rigs[0].Now.TotalSeconds;
        MissionRig follower = rig.Rigs.Single(r => r.Vehicle.Tracks.Count > 0);
        if (isRejectedAtOnce)
            follower.Manager.Reject(101, "test", "a dog");
        Assert.True(
            rig.RunUntil(() => follower.Vehicle.Tracks.Any(t => t.Id == 102 && IsConfirmed(t)), 900), rig.Story);
        rig.Run(1);
        if (!isRejectedAtOnce)
            follower.Manager.Reject(101, "test", "a dog");
        rig.Run(5);
        Assert.Equal(FollowResult.Rejected, Assert.Single(Tasks(rig)).Result);
        Assert.True(IsConfirmed(follower.Vehicle.Tracks.Single(t => t.Id == 102)), rig.Story);
        static bool IsConfirmed(TargetTrack t) => (t.State, t.Decision) == (TrackState.Confirmed, TargetDecision.None);
    }

    // Another vehicle follows it already; this one has no link to its task yet.
    [Fact]
    public void Target_OperatorRejectsATentativeTrackOfWhatAnotherFollows_IsFollowedByNone()
    {
        using GroupRig rig = Open(2, followSeconds: 600);
        Add(rig, Walker(0.5));
        Assert.True(rig.RunUntil(() => Following(rig).Any(i => rig.Rigs[i].Vehicle.Sees(0)), 300), rig.Story);
        int other = 1 - Following(rig)[0];
        Assert.True(rig.RunUntil(() => rig.Rigs[other].Vehicle.Tracks.Count > 0, 400), rig.Story);
        Assert.Equal(TrackState.Tentative, Assert.Single(rig.Rigs[other].Vehicle.Tracks).State);
        rig.Rigs[other].Manager.Reject(101, "test", "a dog");
        Assert.True(rig.RunUntil(() => Following(rig).Length == 0, 3), rig.Story);
        Assert.Equal(FollowResult.Rejected, Assert.Single(Tasks(rig)).Result);
    }

    // Nothing is kept from being searched any more.
    [Fact]
    public void Target_NoBudgetAndAllIsSeen_IsFollowed()
    {
        using GroupRig rig = Open(1, followSeconds: 20, maxWayFraction: 0.001);
        Add(rig, _ => (200, 20));
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.Equal(FollowResult.Followed, Assert.Single(Tasks(rig)).Result);
    }

    [Fact]
    public void Target_NoBudgetAndLanesAreLeft_IsLeftOutAndLoggedOnce()
    {
        using GroupRig rig = Open(2, followSeconds: 20, maxWayFraction: 0.001);
        Add(rig, _ => (200, 20));
        Assert.True(rig.RunUntil(() => Tasks(rig).Count > 0, 600), rig.Story);
        rig.Run(20);
        Assert.Empty(Following(rig));
        Assert.All(
            rig.Rigs, r => Assert.Single(r.Decisions, d => d.Contains("revisits 0.0 m are used: not for us")));
    }

    // Nearer to each other than two tracks of one target may be.
    [Fact]
    public void Targets_TwoBesideEachOther_AreBothFollowed()
    {
        using GroupRig rig = Open(2, followSeconds: 20);
        Add(rig, _ => (200, 20));
        Add(rig, _ => (203, 28));
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.Equal(2, Tasks(rig).Count(t => t.Result == FollowResult.Followed));
    }

    [Fact]
    public void Targets_TwoAndOneVehicle_AreFollowedOneAfterTheOther()
    {
        using GroupRig rig = Open(1, followSeconds: 20);
        Add(rig, _ => (120, 0));
        Add(rig, _ => (125, 60));
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.Equal(2, Tasks(rig).Count(t => t.Result == FollowResult.Followed));
    }

    // Those that come late are asked while they take off, and the same one is nearest to two targets.
    [Fact]
    public void Targets_SeveralAndVehiclesComeLate_NoneIsAwardedTwoAndOneFollowsFromItsWayToTheArea()
    {
        using GroupRig rig = Open(4, followSeconds: 100);
        rig.SwitchedOn = 1;
        for (int i = 0; i < 3; i++)
        {
            int east = 40 * i;
            Add(rig, t => Walker(0.5)(t) is var (n, e) ? (n, e + east) : null);
        }

        Assert.True(rig.RunUntil(() => Tasks(rig).Count == 3, 500), rig.Story);
        rig.SwitchedOn = 4;
        Assert.True(
            rig.RunUntil(
                () =>
                {
                    int most = Tasks(rig).Where(t => t.State == FollowState.Awarded).GroupBy(t => t.Follower)
                        .Select(g => g.Count()).DefaultIfEmpty().Max();
                    Assert.True(most <= 1, $"{most} are of one at {rig.Seconds}: {rig.Story}");
                    return Following(rig).Length == 3;
                },
                60),
            rig.Story);
        Assert.Contains("InTransit -> Revisiting: to follow", rig.Story, StringComparison.Ordinal);
        Assert.All(Tasks(rig), t => Assert.Equal(2, t.Decision));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void Partition_BothPartsFollow_OneFollowsAfterItHeals(int seed)
    {
        using GroupRig rig = Open(3, seed, followSeconds: 200);
        rig.Loss = 0.4;
        Add(rig, Walker(0.4));
        Assert.True(rig.RunUntil(() => Following(rig).Any(i => rig.Rigs[i].Vehicle.Sees(0)), 300), rig.Story);
        int first = Following(rig)[0];
        rig.Reaches = (a, b) => a != first && b != first;
        Assert.True(rig.RunUntil(() => Following(rig).Count(i => rig.Rigs[i].Vehicle.Sees(0)) == 2, 90), rig.Story);
        rig.Run(5);
        rig.Reaches = (_, _) => true;
        Assert.True(rig.RunUntil(() => Following(rig).Length == 1, 8), rig.Story);
        for (int i = 0; i < 20; i++)
        {
            rig.Run(1);
            Assert.Single(Following(rig));
        }
    }

    private static int[] Following(GroupRig rig) => Enumerable.Range(0, rig.Rigs.Count)
        .Where(i => !rig.Lost.Contains(i) && rig.Rigs[i].Status.Phase == MissionPhase.Revisiting
            && rig.Rigs[i].Status.Text?.Contains("moving target") == true).ToArray();

    private static IEnumerable<int> Others(GroupRig rig, int vehicle)
        => Enumerable.Range(0, rig.Rigs.Count).Where(i => i != vehicle);

    private static int LanesOf(GroupRig rig, int asKnownBy, int vehicle)
        => rig.StatusOf(asKnownBy).Members.Single(m => m.SystemId == vehicle + 1).Lanes;

    private static List<FollowTask> Tasks(GroupRig rig) => Enumerable.Range(0, rig.Rigs.Count)
        .Where(i => !rig.Lost.Contains(i))
        .SelectMany(i => rig.StatusOf(i).Followings)
        .Where(t => t.Result != FollowResult.SameTarget)
        .GroupBy(t => (t.Finder, t.Session, t.Number))
        .Select(g => g.OrderByDescending(t => t.Decision).First()).ToList();

    // To and fro across the middle of the field.
    private static Func<TimeSpan, (double North, double East)?> Walker(double speed)
        => t => (200 + (60 * Math.Sin(t.TotalSeconds * speed / 60)), 20);

    // The homes are 20 m apart.
    private static void Add(GroupRig rig, Func<TimeSpan, (double North, double East)?> mover)
    {
        for (int i = 0; i < rig.Rigs.Count; i++)
        {
            int east = 20 * i;
            rig.Rigs[i].Vehicle.Movers.Add(
                t => mover(t) is var (n, e) ? (n, e - east) : null);
        }
    }

    private static GroupRig Open(
        int vehicles, int seed = 1, double followSeconds = 20, string area = Field, int firstLayer = 0,
        double maxWayFraction = 2, string cameraOfAllButTheLast = "")
    {
        MissionPlan Mission(string camera) => MissionRig.Mission(
            camera + ", \"targetMotions\": { \"red\": \"walking\" }, "
                + "\"revisit\": { \"maxWayFraction\": "
                + maxWayFraction.ToString(System.Globalization.CultureInfo.InvariantCulture)
                + ", \"followSeconds\": "
                + followSeconds.ToString(System.Globalization.CultureInfo.InvariantCulture) + " }",
            area);
        return new GroupRig(
            vehicles, Mission(cameraOfAllButTheLast), seed,
            (number, options) => options.Group!.HeightLayer = firstLayer + number,
            missionOfTheLast: Mission(string.Empty));
    }
}
