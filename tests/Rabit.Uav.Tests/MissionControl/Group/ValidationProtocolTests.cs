using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl.Group;

/// <summary>Exactly one vehicle validates a target, whatever the network does.</summary>
public sealed class ValidationProtocolTests
{
    [Fact]
    public void Award_SeveralOffer_GoesToTheFirstThere()
    {
        var network = new ValidationNetwork(4, seed: 1) { SecondsTo = i => i == 2 ? 5 : 10 };
        network.Announce();
        Assert.True(network.RunUntil(() => network.Underway.Length > 0, 3));
        Assert.Equal([2], network.Underway);
    }

    [Fact]
    public void Award_SameTime_GoesToTheLowerSystemId()
    {
        var network = new ValidationNetwork(4, seed: 1) { SecondsTo = _ => 5 };
        network.Announce();
        network.Run(3);
        Assert.Equal([1], network.Underway);
    }

    [Fact]
    public void Award_AllDecline_WaitsUntilOneCan()
    {
        var network = new ValidationNetwork(3, seed: 1) { SecondsTo = _ => null };
        network.Announce();
        network.Run(20);
        Assert.Equal(ValidationState.Open, network.Task.State);
        network.SecondsTo = i => i == 2 ? 7 : null;
        Assert.True(network.RunUntil(() => network.Underway.Contains(2), 5));
    }

    [Fact]
    public void Task_Alone_SendsNothing()
    {
        var network = new ValidationNetwork(2, seed: 1) { Reaches = (_, _) => false };
        network.Announce();
        network.Run(60);
        Assert.Equal(0, network.Sent);
    }

    [Fact]
    public void Task_Closed_IsSilentAfterAWhile()
    {
        var network = new ValidationNetwork(3, seed: 1);
        network.Announce();
        Assert.True(network.RunUntil(() => network.Task.State == ValidationState.Closed, 60));
        network.Run(10);
        int sent = network.Sent;
        network.Run(60);
        Assert.Equal(sent, network.Sent);
        Assert.InRange(sent, 50, 150); // half a minute of one message each half second, and answers
    }

    [Fact]
    public void Validator_IsLost_AnotherOneIsAwarded()
    {
        var network = new ValidationNetwork(3, seed: 1);
        network.Announce();
        Assert.True(network.RunUntil(() => network.Underway.Length == 1, 5));
        network.Lost.Add(network.Underway[0]);
        Assert.True(network.RunUntil(() => network.Task.State == ValidationState.Closed, 60));
        Assert.Equal([2], network.Finished);
        Assert.Equal(2, network.Task.Award);
    }

    [Fact]
    public void Validator_Declines_AnotherOneIsAwardedAtOnce()
    {
        var network = new ValidationNetwork(3, seed: 1);
        network.Announce();
        Assert.True(network.RunUntil(() => network.Underway.Contains(1), 5));
        network.SecondsTo = i => i == 1 ? null : 10;
        network.BidderOf(1).DeclineAll(TimeSpan.FromSeconds(network.Seconds));
        Assert.True(network.RunUntil(() => network.Underway.Contains(2), 4));
    }

    [Fact]
    public void Answer_ToAnEarlierAward_ChangesNothing()
    {
        var network = new ValidationNetwork(2, seed: 1);
        network.Announce();
        Assert.True(network.RunUntil(() => network.Underway.Length == 1, 5));
        network.Reaches = (_, _) => false;
        network.Run(15);
        network.Reaches = (_, _) => true;
        Assert.True(network.RunUntil(() => network.Task is { State: ValidationState.Awarded, Award: 2 }, 5));
        var late = new ValidationBid
        {
            Session = network.Task.Session,
            Number = 1,
            Award = 1,
            State = ValidationBidState.Declined,
        };
        network.Finder.Receive(2, late, TimeSpan.FromSeconds(network.Seconds));
        Assert.Equal(ValidationState.Awarded, network.Task.State);
    }

    [Fact]
    public void Finder_Restarts_ItsNumbersAreNotThoseOfBefore()
    {
        var network = new ValidationNetwork(3, seed: 1);
        network.Announce();
        Assert.True(network.RunUntil(() => network.Task.State == ValidationState.Closed, 60));
        network.Restart(0);
        network.Announce();
        Assert.True(network.RunUntil(() => network.Task.State == ValidationState.Closed, 60));
        Assert.Equal(2, network.Finished.Count);
    }

    [Fact]
    public void Tasks_Many_AreAllValidated()
    {
        var network = new ValidationNetwork(3, seed: 1);
        network.Announce(ValidationFinder.MaxTasks + 5);
        Assert.Equal(5, network.Finder.LeftOut);
        Assert.True(network.RunUntil(() => !network.Finder.IsPending, 2000));
        Assert.Equal(ValidationFinder.MaxTasks, network.Finished.Count);
    }

    [Fact]
    public void AnyNetwork_HundredSeeds_OneResultByOneVehicle()
    {
        for (int seed = 1; seed <= 100; seed++)
        {
            var network = new ValidationNetwork(2 + (seed % 4), seed)
            {
                Loss = seed % 3 * 0.2,
                MaxDelaySeconds = seed % 5 * 0.5,
                Duplicates = seed % 2 * 0.3,
                Shown = seed % 2 == 0 ? ValidationResult.Confirmed : ValidationResult.Rejected,
            };
            network.Announce();
            Assert.True(
                network.RunUntil(
                    () =>
                    {
                        Assert.True(network.Underway.Length <= 1, $"seed {seed}, {network.Seconds} s");
                        return network.Task.State == ValidationState.Closed;
                    },
                    120),
                $"seed {seed}");
            Assert.Equal(network.Shown, network.Task.Result);
            Assert.Single(network.Finished);
        }
    }

    // An older state that comes after it, or twice, changes nothing.
    [Fact]
    public void Reject_AfterTheResultAndMessagesComeLate_StaysOnceItIsKnown()
    {
        for (int seed = 1; seed <= 50; seed++)
        {
            var network = new ValidationNetwork(3, seed) { MaxDelaySeconds = 2, Duplicates = 0.3 };
            network.Announce();
            Assert.True(network.RunUntil(() => network.Task.State == ValidationState.Closed, 120), $"seed {seed}");
            network.Run(0.5);
            network.Finder.Reject(1, network.Task, ownSystemId: 1, TimeSpan.FromSeconds(network.Seconds));
            var known = new HashSet<int>();
            network.RunUntil(
                () =>
                {
                    int[] rejected = new[] { 1, 2 }
                        .Where(i => network.BidderOf(i).Tasks.Single().IsRejectedByOperator).ToArray();
                    Assert.True(known.IsSubsetOf(rejected), $"seed {seed}, {network.Seconds} s");
                    known.UnionWith(rejected);
                    return false;
                },
                10);
            Assert.Equal(2, known.Count);
        }
    }

    [Fact]
    public void Partition_TwentySecondsAndFortyPercentLost_OneValidatorWithinThreeSecondsOfHealing()
    {
        int doubles = 0;
        for (int seed = 1; seed <= 100; seed++)
        {
            var network = new ValidationNetwork(4, seed) { Loss = 0.4, Duplicates = 0.1, JobSeconds = 45 };
            network.Announce();
            Assert.True(network.RunUntil(() => network.Underway.Length == 1, 20), $"seed {seed}");
            int first = network.Underway[0];
            network.Reaches = (from, to) => (from == first) == (to == first);
            network.Run(20);
            doubles += network.Underway.Length == 2 ? 1 : 0;
            network.Reaches = (_, _) => true;
            network.Run(3);
            Assert.True(network.Underway.Length <= 1, $"seed {seed}: {string.Join(", ", network.Underway)}");
            Assert.True(
                network.RunUntil(() => network.Task.State == ValidationState.Closed, 120), $"seed {seed}");
        }

        // Or the partition would show nothing.
        Assert.True(doubles > 50, $"{doubles} of 100");
    }
}
