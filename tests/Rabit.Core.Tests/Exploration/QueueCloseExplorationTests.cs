using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Queues;
using Rabit.Core.WakeUp;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// Contract 3.5 in every interleaving of the positions of a ring of many senders: a push that races with the end of the
/// run is rejected, or its value is among those that the counters report as left.
/// </summary>
public sealed class QueueCloseExplorationTests(ITestOutputHelper output)
{
    private const int Capacity = 2;

    public static IEnumerable<object[]> Cases()
        => from memory in new[] { MemoryModel.StoreBuffers, MemoryModel.Weak }
           from isWarm in new[] { false, true }
           from senders in new[] { 1, 2 }
           select new object[] { memory.ToString(), isWarm, senders };

    [Theory, Trait("Clause", "3.5"), Trait("Clause", "3.1")]
    [MemberData(nameof(Cases))]
    public void Close_OfManySenders_EveryPushIsRejectedOrReported(string memory, bool isWarm, int senders)
        => AssertNothingIsLost(memory, new Ring(isWarm), [.. Enumerable.Repeat<Func<Ring, int>>(Reserve, senders)]);

    [Theory, Trait("Clause", "3.5"), Trait("Clause", "3.1")]
    [InlineData(false)]
    [InlineData(true)]
    public void Close_OfASenderThatGoesOn_EveryPushIsRejectedOrReported(bool isWarm)
    {
        int Twice(Ring ring) => Reserve(ring) + Reserve(ring);
        AssertNothingIsLost("StoreBuffers", new Ring(isWarm), Twice, Reserve);
    }

    /// <summary>That the exploration finds what it is for: counters that are read before the queue is closed.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Counters_ReadBeforeTheClose_AreFoundToMissAPush(bool isWarm)
        => Assert.NotNull(Explore(MemoryModel.StoreBuffers, new Ring(isWarm), _ => { }, Reserve).Fault);

    /// <summary>
    /// As above: a close that leaves the tail where it is, in reach of a sender that has looked before. It is that of
    /// the positions of a single sender, who does not move its tail by a swap.
    /// </summary>
    [Theory, Trait("Clause", "3.5")]
    [InlineData(false)]
    [InlineData(true)]
    public void Close_ThatLeavesTheTailInReach_IsFoundToMissAPush(bool isWarm)
    {
        ExplorationResult result = Explore(
            MemoryModel.StoreBuffers, new Ring(isWarm, isAlone: true),
            r => r.Positions.Close<ExploredSyncPoints>(), Reserve);

        Assert.Equal("1 were accepted, 0 reported", result.Fault);
    }

    private static int Reserve(Ring ring)
        => ring.Positions.Reserve<ExploredSyncPoints>(1, Capacity, out _);

    private void AssertNothingIsLost(string memory, Ring ring, params Func<Ring, int>[] senders)
    {
        MemoryModel model = MemoryModels.Named(memory);
        ExplorationResult result = Explore(
            model, ring, r => r.Positions.Close<ExploredSyncPoints>(), senders);

        output.WriteLine(result.ToString());
        Assert.True(result.Fault is null, result.ToString());
    }

    private static ExplorationResult Explore(
        MemoryModel memory, Ring ring, Action<Ring> close, params Func<Ring, int>[] senders)
    {
        // The notes: what each push returned, and what was reported.
        int reported = senders.Length;
        var threads = senders.Select((push, i) => new Action(() =>
        {
            int accepted = push(ring);
            ExploredSyncPoints.Note((i, accepted), state => state.Note(i) = accepted);
        })).ToList();
        threads.Add(() =>
        {
            close(ring);
            int left = ring.Positions.Counters<ExploredSyncPoints>(Capacity).Resident - ring.LeftBefore;
            ExploredSyncPoints.Note((reported, left), state => state.Note(reported) = left);
        });
        void Check(ExploredState state)
        {
            int accepted = Enumerable.Range(0, reported).Sum(i => state.Note(i));
            state.Require(
                accepted == state.Note(reported), $"{accepted} were accepted, {state.Note(reported)} reported");
        }

        // Without folding: a sender keeps what it has read for longer than places that look alike are watched.
        return Explorer.Explore(
            new SmallModel(reported + 1, Check, [.. threads]) { MayFenceAll = ring.Positions.IsAlone },
            new ExplorerOptions(memory) { WatchedSteps = 0 });
    }

    /// <summary>The positions alone; warm ones have a place for a push that need not look at the head.</summary>
    private sealed class Ring
    {
        public RingPositions Positions;

        public Ring(bool isWarm, bool isAlone = false)
        {
            Positions = new RingPositions(start: -1, isAlone);
            if (!isWarm)
                return;
            Positions.Reserve<SyncPoints>(2, Capacity, out _);
            Positions.MoveHead<SyncPoints>(Positions.Head<SyncPoints>(), 2);
            Positions.Reserve<SyncPoints>(1, Capacity, out _);
            LeftBefore = 1;
        }

        public int LeftBefore { get; }
    }
}
