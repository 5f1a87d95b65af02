using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl.Group;

/// <summary>Exactly one vehicle follows a target, whatever the network does.</summary>
public sealed class FollowProtocolTests
{
    [Fact]
    public void Award_SeveralOffer_GoesToTheFirstThere()
    {
        var network = new FollowNetwork(4, seed: 1) { SecondsTo = i => i == 2 ? 3 : 10 };
        network.Announce();
        Assert.True(network.RunUntil(() => network.Following.Length > 0, 3));
        Assert.Equal([2], network.Following);
    }

    [Fact]
    public void Award_SameTime_GoesToTheLowerSystemId()
    {
        var network = new FollowNetwork(4, seed: 1) { SecondsTo = _ => 5 };
        network.Announce(vehicle: 3);
        network.Run(3);
        Assert.Equal([0], network.Following);
    }

    [Fact]
    public void Award_Alone_IsOursAtOnce()
    {
        var network = new FollowNetwork(2, seed: 1) { Reaches = (_, _) => false };
        network.Announce();
        Assert.True(network.RunUntil(() => network.Following.Contains(0), 0.5));
    }

    [Fact]
    public void Award_NoneCan_WaitsUntilOneCan()
    {
        var network = new FollowNetwork(3, seed: 1) { SecondsTo = _ => null };
        network.Announce();
        network.Run(20);
        Assert.Equal(FollowState.Open, network.TaskOf(1).State);
        network.SecondsTo = i => i == 2 ? 7 : null;
        Assert.True(network.RunUntil(() => network.Following.Contains(2), 5));
    }

    [Fact]
    public void Award_NoneCanAndItIsNotSeen_IsGivenUp()
    {
        var network = new FollowNetwork(3, seed: 1) { SecondsTo = _ => null };
        network.Announce();
        network.Run(FollowBook.MaxUnseen.TotalSeconds + 2);
        Assert.All(
            Enumerable.Range(0, 3),
            i => Assert.Equal(FollowResult.Lost, Assert.Single(network.BookOf(i).Entries).Task.Result));
    }

    [Fact]
    public void Award_IsLost_IsRepeated()
    {
        var network = new FollowNetwork(3, seed: 1) { SecondsTo = i => i == 2 ? 3 : 10 };
        network.Drops = (_, task) => task.State == FollowState.Awarded && network.Seconds < 5;
        network.Announce();
        Assert.False(network.RunUntil(() => network.Following.Length > 0, 4.9));
        Assert.True(network.RunUntil(() => network.Following.SequenceEqual([2]), 1));
    }

    [Fact]
    public void Award_OfAVehicleThatIsGone_IsForAnother()
    {
        var network = new FollowNetwork(3, seed: 1) { SecondsTo = i => i == 2 ? 3 : 10 };
        network.Drops = (_, task) => task.State == FollowState.Awarded && task.Follower == 3;
        network.Announce();
        network.Run(3);
        network.Lost.Add(2);
        Assert.True(network.RunUntil(() => network.Following.SequenceEqual([0]), 10));
    }

    [Fact]
    public void Follower_IsLost_AnotherOneFollows()
    {
        var network = new FollowNetwork(3, seed: 1);
        network.Announce();
        Assert.True(network.RunUntil(() => network.Seeing.SequenceEqual([0]), 10));
        network.Lost.Add(0);
        Assert.True(network.RunUntil(() => network.Seeing.Length > 0, 20));
        Assert.Equal([1], network.Seeing);
        network.Run(20);
        Assert.Equal([1], network.Following);
    }

    [Fact]
    public void HandOver_SomeoneCan_OneSeesItAllTheTimeAndThenOnlyTheOther()
    {
        var network = new FollowNetwork(3, seed: 1);
        network.Announce();
        Assert.True(network.RunUntil(() => network.Seeing.SequenceEqual([0]), 10));
        network.FollowedBy(0).HandOver(1, TimeSpan.FromSeconds(network.Seconds));
        for (int i = 0; i < 200; i++)
        {
            network.Run(0.1);
            Assert.True(network.Seeing.Length > 0, $"none sees it at {network.Seconds}");
        }

        Assert.Equal([1], network.Following);
        Assert.Equal((FollowState.Awarded, (byte)2), (network.TaskOf(2).State, network.TaskOf(2).Follower));
    }

    [Fact]
    public void HandOver_NoneCan_GoesOn()
    {
        var network = new FollowNetwork(3, seed: 1) { SecondsTo = i => i == 0 ? 5 : null };
        network.Announce();
        Assert.True(network.RunUntil(() => network.Seeing.SequenceEqual([0]), 10));
        network.FollowedBy(0).HandOver(1, TimeSpan.FromSeconds(network.Seconds));
        network.Run(30);
        Assert.Equal([0], network.Seeing);
    }

    [Fact]
    public void Targets_TwoAndOneVehicleIsFree_TheSecondWaits()
    {
        var network = new FollowNetwork(2, seed: 1) { SecondsTo = i => i == 1 ? 5 : null };
        network.Announce();
        network.Announce(northDegrees: 0.01);
        Assert.True(network.RunUntil(() => network.Seeing.SequenceEqual([1]), 12));
        FollowEntry first = network.FollowedBy(1);
        network.Run(20);
        Assert.Same(first, network.FollowedBy(1));
        first.Close(2, FollowResult.Followed, TimeSpan.FromSeconds(network.Seconds));
        Assert.True(network.RunUntil(() => network.Following.Length == 1 && network.FollowedBy(1) != first, 6));
    }

    // 1000 bytes a second are shared with all else; a message has some 100.
    [Fact]
    public void Tasks_Many_AreRepeatedSoSlowlyThatTheRadioIsNotFilled()
    {
        var network = new FollowNetwork(2, seed: 1) { SecondsTo = _ => null };
        for (int i = 0; i < 12; i++)
            network.Announce(northDegrees: 0.01 * i);
        network.Run(10);
        int sent = 0;
        network.Drops = (sender, _) => sender == 0 && ++sent < 0;
        network.Run(20);
        Assert.InRange(sent, 70, 85);
        Assert.All(network.BookOf(1).Entries, e => Assert.Equal(1, e.Task.Decider));
    }

    [Fact]
    public void Tasks_ManyAndFortyPercentLost_TheirFollowersAreNotTakenForLost()
    {
        for (int seed = 1; seed <= 20; seed++)
        {
            var network = new FollowNetwork(3, seed) { SecondsTo = _ => null, Loss = 0.4 };
            for (int i = 0; i < 12; i++)
                network.Announce(northDegrees: 0.01 * i);
            network.Run(80);
            Assert.All(
                Enumerable.Range(0, 3).SelectMany(i => network.BookOf(i).Entries),
                e => Assert.True(e.Task.Decider == 1, $"seed {seed}: {e.Task.Number} is of {e.Task.Decider}"));
        }
    }

    // What the operator says holds, whatever was decided meanwhile where that was not received.
    [Theory]
    [InlineData(FollowResult.Followed)]
    [InlineData(FollowResult.Lost)]
    public void Task_RejectedBehindAPartition_IsRejectedForAllAfterIt(FollowResult result)
    {
        var network = new FollowNetwork(2, seed: 1);
        network.Announce();
        Assert.True(network.RunUntil(() => network.Seeing.SequenceEqual([0]), 10));
        network.Reaches = (_, _) => false;
        TimeSpan now = TimeSpan.FromSeconds(network.Seconds);
        network.BookOf(1).Entries.Single().Close(2, FollowResult.Rejected, now);
        FollowEntry followed = network.FollowedBy(0);
        followed.HandOver(1, now);
        followed.Close(1, result, now);
        network.Reaches = (_, _) => true;
        network.Run(3);
        Assert.All(
            Enumerable.Range(0, 2),
            i => Assert.Equal(FollowResult.Rejected, Assert.Single(network.BookOf(i).Entries).Task.Result));
    }

    [Fact]
    public void Task_Closed_IsSilentAfterAWhileAndAnswersWhoMissedIt()
    {
        var network = new FollowNetwork(2, seed: 1);
        network.Announce();
        Assert.True(network.RunUntil(() => network.Seeing.SequenceEqual([0]), 10));
        network.Reaches = (_, _) => false;
        network.FollowedBy(0).Close(1, FollowResult.Followed, TimeSpan.FromSeconds(network.Seconds));
        network.Run(20);
        Assert.Equal([1], network.Following);
        network.Reaches = (_, _) => true;
        Assert.True(network.RunUntil(() => network.Following.Length == 0, 3));
    }

    // The one of the two that sees it goes on until the other does: exactly one has it, by what all know.
    [Fact]
    public void Network_FortyPercentLostAndAPartition_OneFollowsThreeSecondsAfterItHeals()
    {
        for (int seed = 1; seed <= 100; seed++)
        {
            var network = new FollowNetwork(3, seed) { Loss = 0.4, Duplicates = 0.2, MaxDelaySeconds = 0.5 };
            network.Announce();
            Assert.True(network.RunUntil(() => network.Seeing.Length > 0, 20), $"seed {seed}");
            int apart = network.Seeing[0];
            network.Reaches = (a, b) => a != apart && b != apart;
            Assert.True(network.RunUntil(() => network.Seeing.Length == 2, 40), $"seed {seed}: both follow");
            network.Run(5);
            network.Reaches = (_, _) => true;
            network.Run(3);
            Assert.True(network.Following.Length == 1, $"seed {seed}: {network.Following.Length} follow");
            int one = network.Following[0];
            network.Run(30);
            Assert.True(
                network.Following.Length == 1 && network.Following[0] == one,
                $"seed {seed}: {one} and then {string.Join(", ", network.Following)}");
        }
    }

    [Fact]
    public void Network_AnyOfManySeeds_OneIsAwarded()
    {
        for (int seed = 1; seed <= 100; seed++)
        {
            var random = new Random(seed);
            var network = new FollowNetwork(4, seed)
            {
                Loss = 0.5 * random.NextDouble(),
                Duplicates = 0.3,
                MaxDelaySeconds = 2 * random.NextDouble(),
            };
            network.Announce(vehicle: random.Next(4));
            network.Run(40);
            Assert.True(network.Seeing.Length == 1, $"seed {seed}: {network.Seeing.Length} see it");
            byte follower = (byte)(network.Seeing[0] + 1);
            Assert.All(Enumerable.Range(0, 4), i => Assert.Equal(follower, network.TaskOf(i).Follower));
        }
    }

    [Fact]
    public void Receive_OfAVehicleThatHasNothingToSay_IsRefused()
    {
        var network = new FollowNetwork(3, seed: 1);
        network.Announce();
        Assert.True(network.RunUntil(() => network.Seeing.SequenceEqual([0]), 10));
        FollowBook book = network.BookOf(1);
        FollowTask task = network.TaskOf(1);
        long refused = book.Refused;
        task.Decision = 100;
        book.Receive(3, task, TimeSpan.FromSeconds(50), 2, _ => 1, TimeSpan.FromSeconds(50));
        Assert.Equal(refused + 1, book.Refused);
        Assert.Equal(1, network.TaskOf(1).Follower);
    }

    [Fact]
    public void Receive_TooManyTasks_AreRefused()
    {
        var network = new FollowNetwork(2, seed: 1);
        FollowBook book = network.BookOf(0);
        for (int i = 0; i <= FollowBook.MaxTasks; i++)
        {
            var task = new FollowTask
            {
                Finder = 9,
                Number = (ushort)i,
                Decision = 1,
                Decider = 9,
                Class = DefaultTargetClasses.Red,
                Position = GeodeticPosition.FromDegrees(47, 8, 0),
            };
            book.Receive(9, task, default, 1, _ => null, default);
        }

        Assert.Equal(FollowBook.MaxTasks, book.Entries.Count());
        Assert.True(book.Refused > 0);
    }
}
