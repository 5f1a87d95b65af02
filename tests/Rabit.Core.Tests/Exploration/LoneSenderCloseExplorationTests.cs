using System;
using Rabit.Core.Queues;
using Rabit.Core.WakeUp;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// Contract 3.5 in every interleaving of a ring of one sender, which moves the tail by a store: a push that races with
/// the end of the run is rejected, or its value is counted; nothing that is rejected is taken out, or ever counted.
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

    /// <summary>Memory, whether the last store of a push is a fence, pushes, pops, whether another looks.</summary>
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

    /// <summary>That the exploration finds what it is for.</summary>
    [Theory, Trait("Clause", "3.5")]
    [InlineData(SeededCloseFault.CountersBeforeTheClose, "are counted")]
    [InlineData(SeededCloseFault.TailNotSettled, "are counted")]
    [InlineData(SeededCloseFault.NoFenceOnAllThreads, "are counted")]
    [InlineData(SeededCloseFault.CountersByTheTail, "are counted")]
    [InlineData(SeededCloseFault.NoLookOfThePush, "are counted")]
    [InlineData(SeededCloseFault.AlwaysInTime, "are counted")]
    [InlineData(SeededCloseFault.SequenceBeforeTheTail, "were taken out of")]
    [InlineData(SeededCloseFault.ReceiverBySequenceAlone, "were taken out of")]
    [InlineData(SeededCloseFault.ReceiverLooksForTheSettledTail, "were taken out of")]
    public void Exploration_OfATwinWithAFault_FindsIt(SeededCloseFault fault, string expected)
    {
        ExplorationResult right = ExploreTwin("StoreBuffers", SeededCloseFault.None);
        ExplorationResult wrong = ExploreTwin("StoreBuffers", fault);

        output.WriteLine(wrong.ToString());
        Assert.True(right.Fault is null, right.ToString());
        Assert.Contains(expected, wrong.Fault, StringComparison.Ordinal);
    }

    /// <summary>What the fence on all threads is for is not seen where each write is seen at once.</summary>
    [Fact]
    public void Exploration_WithoutStoreBuffers_DoesNotFindTheMissingFence()
        => Assert.Null(ExploreTwin("SequentiallyConsistent", SeededCloseFault.NoFenceOnAllThreads).Fault);

    private static ExplorationResult ExploreTwin(string memory, SeededCloseFault fault)
        => Explore(
            memory, new FaultyClosingRing(fault, Capacity), pushes: 2, pops: 1, looks: false,
            countsFirst: fault == SeededCloseFault.CountersBeforeTheClose);

    private void AssertNothingIsLost(string memory, bool isFenced, int pushes, int pops, bool looks)
    {
        // A receiver that is woken is what makes a push fence. Its wake stays pending, so that there is one at most.
        WakeUpEvent<ExploredSyncPoints>? receiver = isFenced ? new() : null;
        var ring = new SingleProducerRing<int, ExploredSyncPoints>("q", Capacity, receiver, start: -1);

        ExplorationResult result = Explore(memory, ring, pushes, pops, looks);

        output.WriteLine(result.ToString());
        Assert.True(result.Fault is null, result.ToString());
    }

    private static ExplorationResult Explore(
        string memory, MessageQueue<int, ExploredSyncPoints> ring, int pushes, int pops, bool looks,
        bool countsFirst = false)
    {
        Action[] threads =
        [
            () => Push(ring, pushes),
            () => Close(ring, countsFirst),
            .. pops > 0 ? [() => Pop(ring, pops)] : Array.Empty<Action>(),
            .. looks ? [() => Look(ring)] : Array.Empty<Action>(),
        ];

        // The locations: head, tail, head as it was last seen, half wraps, limit, last mark, last tail, state and time
        // of the wake, and of each slot its value and sequence.
        // Without folding: a sender keeps what it has read for longer than places that look alike are watched.
        return Explorer.Explore(
            new SmallModel(Notes, Check, threads) { MayFenceAll = true, Locations = 9 + (2 * Capacity) },
            new ExplorerOptions(MemoryModels.Named(memory)) { WatchedSteps = 0 });
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

    private static void Push(MessageQueue<int, ExploredSyncPoints> ring, int times)
    {
        int accepted = 0;
        for (int i = 0; i < times; i++)
        {
            if (ring.Push(i) == PushResult.Queued)
                accepted++;
        }

        ExploredSyncPoints.Note(accepted, state => state.Note(Accepted) = accepted);
    }

    private static void Pop(MessageQueue<int, ExploredSyncPoints> ring, int times)
    {
        int popped = 0;
        for (int i = 0; i < times; i++)
        {
            if (ring.TryPop(out _))
                popped++;
        }

        ExploredSyncPoints.Note(popped, state => state.Note(Popped) = popped);
    }

    private static void Close(MessageQueue<int, ExploredSyncPoints> ring, bool countsFirst)
    {
        int counted = countsFirst ? (int)ring.Counters.Pushed : 0;
        ring.Close();
        if (!countsFirst)
            counted = (int)ring.Counters.Pushed;
        ExploredSyncPoints.Note(counted, state => state.Note(Counted) = counted);
    }

    private static void Look(MessageQueue<int, ExploredSyncPoints> ring)
    {
        int counted = (int)ring.Counters.Pushed;
        ExploredSyncPoints.Note(counted, state => state.Note(CountedByOther) = counted);
    }
}
