using System;
using Rabit.Core.Queues;
using Rabit.Core.WakeUp;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// Contract 3.5 in every interleaving of the positions of a ring of one sender, which moves the tail by a store: a push
/// that races with the end of the run is rejected, or its value is counted; nothing that is rejected is taken out, or
/// ever counted.
/// </summary>
public sealed class LoneSenderCloseExplorationTests(ITestOutputHelper output)
{
    private const int Capacity = 2;

    // The notes: values accepted; those taken out; how many the thread that closes counts; how many another one counts
    // at any time.
    private const int Accepted = 0;
    private const int Popped = 1;
    private const int Counted = 2;
    private const int CountedByOther = 3;
    private const int Notes = 4;

    /// <summary>Memory, whether the move of the tail is a fence, pushes, pops, whether another looks.</summary>
    public static TheoryData<string, bool, int, int, bool> Small() => new()
    {
        { "SequentiallyConsistent", false, 2, 1, false },
        { "SequentiallyConsistent", false, 1, 0, true },
        { "StoreBuffers", false, 2, 1, false },
        { "StoreBuffers", true, 2, 1, false },
        { "StoreBuffers", false, 1, 0, true },
        { "Weak", false, 2, 0, false },
        { "Weak", false, 1, 1, false },
        { "Weak", true, 1, 1, false },
    };

    /// <summary>As <see cref="Small"/>.</summary>
    public static TheoryData<string, bool, int, int, bool> Large() => new()
    {
        { "SequentiallyConsistent", false, 2, 1, true },
        { "StoreBuffers", false, 3, 2, false },
        { "StoreBuffers", false, 1, 1, true },
        { "Weak", false, 2, 1, false },
        { "Weak", false, 1, 1, true },
        { "Weak", true, 2, 1, false },
    };

    [Theory, Trait("Clause", "3.5"), Trait("Clause", "3.1")]
    [MemberData(nameof(Small))]
    public void Close_InEveryInterleaving_EveryPushIsRejectedOrCounted(
        string memory, bool isFenced, int pushes, int pops, bool looks)
        => AssertNothingIsLost(memory, isFenced, pushes, pops, looks);

    [Theory, Trait("Category", "Long")]
    [MemberData(nameof(Large))]
    public void Close_InEveryInterleavingOfMore_EveryPushIsRejectedOrCounted(
        string memory, bool isFenced, int pushes, int pops, bool looks)
        => AssertNothingIsLost(memory, isFenced, pushes, pops, looks);

    private void AssertNothingIsLost(string memory, bool isFenced, int pushes, int pops, bool looks)
    {
        var ring = new Ring();
        Action[] threads =
        [
            () => Push(ring, isFenced, pushes),
            () => Close(ring),
            .. pops > 0 ? [() => Pop(ring, pops)] : Array.Empty<Action>(),
            .. looks ? [() => Look(ring)] : Array.Empty<Action>(),
        ];

        // Without folding: a sender keeps what it has read for longer than places that look alike are watched.
        ExplorationResult result = Explorer.Explore(
            new SmallModel(Notes, Check, threads) { MayFenceAll = true },
            new ExplorerOptions(MemoryModels.Named(memory)) { WatchedSteps = 0 });

        output.WriteLine(result.ToString());
        Assert.True(result.Fault is null, result.ToString());
    }

    private static void Check(ExploredState state)
    {
        int accepted = state.Note(Accepted);
        state.Require(
            accepted == state.Note(Counted), $"{accepted} were accepted, {state.Note(Counted)} are counted");
        state.Require(
            state.Note(Popped) <= accepted, $"{state.Note(Popped)} were taken out of {accepted}");
        int other = state.Note(CountedByOther);
        state.Require(other <= accepted, $"{accepted} were accepted, another thread counts {other}");
    }

    private static void Push(Ring ring, bool isFenced, int times)
    {
        int accepted = 0;
        for (int i = 0; i < times; i++)
        {
            if (ring.Positions.Find<ExploredSyncPoints>(1, Capacity, out int position) == 1
                && ring.Positions.TryMoveTail<ExploredSyncPoints>(position, 1, isFenced))
                accepted++;
        }

        ExploredSyncPoints.Note(accepted, state => state.Note(Accepted) = accepted);
    }

    private static void Pop(Ring ring, int times)
    {
        int popped = 0;
        for (int i = 0; i < times; i++)
        {
            if (ring.Positions.Available<ExploredSyncPoints>(1) == 0)
                continue;
            ring.Positions.MoveHead<ExploredSyncPoints>(1);
            popped++;
        }

        ExploredSyncPoints.Note(popped, state => state.Note(Popped) = popped);
    }

    private static void Close(Ring ring)
    {
        ring.Positions.Close<ExploredSyncPoints>();
        int counted = (int)ring.Positions.Counters<ExploredSyncPoints>(Capacity).Pushed;
        ExploredSyncPoints.Note(counted, state => state.Note(Counted) = counted);
    }

    private static void Look(Ring ring)
    {
        int counted = (int)ring.Positions.Counters<ExploredSyncPoints>(Capacity).Pushed;
        ExploredSyncPoints.Note(counted, state => state.Note(CountedByOther) = counted);
    }

    private sealed class Ring
    {
        public RingPositions Positions = new(start: -1, isAlone: true);
    }
}
