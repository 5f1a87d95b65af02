using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Queues;
using Rabit.Core.WakeUp;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// Contract 3.5 in every interleaving of batches with the close of a queue, of one sender and of many: of each batch as
/// many values are counted as its push returned, the first of them; what a batch takes out was put in, once, in order.
/// So nothing is taken out beyond what was counted when the close had returned.
/// </summary>
public sealed class BatchCloseExplorationTests(ITestOutputHelper output)
{
    private const string Pair = "pair";
    private const string Ring = "ring";
    private const int Capacity = 2;

    // The notes: which values are in, which were taken out, and how many the thread that closes counts.
    private const int Accepted = 0;
    private const int Popped = 1;
    private const int Counted = 2;
    private const int Notes = 3;

    /// <summary>
    /// Kind, memory, whether a push wakes the receiver, how many values each push of each sender has, and each pop.
    /// </summary>
    public static TheoryData<string, string, bool, string, string> Small() => new()
    {
        { Pair, "SequentiallyConsistent", false, "2", "2" },
        { Pair, "SequentiallyConsistent", false, "1 2", "2" },
        { Pair, "StoreBuffers", false, "2", "2" },
        { Pair, "StoreBuffers", true, "2", "2" },
        { Pair, "Weak", false, "2", "2" },
        { Ring, "SequentiallyConsistent", false, "2|1", "2" },
        { Ring, "StoreBuffers", false, "2|1", "" },
        { Ring, "StoreBuffers", false, "2", "2" },
        { Ring, "Weak", false, "2", "2" },
    };

    /// <summary>As <see cref="Small"/>.</summary>
    public static TheoryData<string, string, bool, string, string> Large() => new()
    {
        { Pair, "StoreBuffers", false, "2 2", "2" },
        { Pair, "StoreBuffers", false, "1 2", "2 1" },
        { Pair, "Weak", false, "1 2", "2" },
        { Pair, "Weak", true, "2", "2" },
        { Ring, "StoreBuffers", false, "2|1", "2" },
        { Ring, "StoreBuffers", true, "2", "2" },
        { Ring, "Weak", false, "2|1", "" },
        { Ring, "Weak", false, "2 2", "2" },
    };

    [Theory, Trait("Clause", "3.5"), Trait("Clause", "3.1")]
    [MemberData(nameof(Small))]
    public void Close_BesideBatchesInEveryInterleaving_EachValueIsRejectedOrCounted(
        string kind, string memory, bool wakes, string pushes, string pops)
        => AssertNothingIsLost(kind, memory, wakes, pushes, pops);

    [Theory, Trait("Category", "Long")]
    [MemberData(nameof(Large))]
    public void Close_BesideBatchesInEveryInterleavingOfMore_EachValueIsRejectedOrCounted(
        string kind, string memory, bool wakes, string pushes, string pops)
        => AssertNothingIsLost(kind, memory, wakes, pushes, pops);

    /// <summary>That the exploration finds what it is for.</summary>
    [Theory, Trait("Clause", "3.5")]
    [InlineData(SeededCloseFault.CountersBeforeTheClose, "2", "", "are counted")]
    [InlineData(SeededCloseFault.TailNotSettled, "2", "", "are counted")]
    [InlineData(SeededCloseFault.NoFenceOnAllThreads, "2", "", "are counted")]
    [InlineData(SeededCloseFault.CountersByTheTail, "2", "", "are counted")]
    [InlineData(SeededCloseFault.NoLookOfThePush, "2", "", "are counted")]
    [InlineData(SeededCloseFault.AlwaysInTime, "2", "", "are counted")]
    [InlineData(SeededCloseFault.BatchMovesTheTailOneByOne, "2", "", "are counted")]
    [InlineData(SeededCloseFault.SequenceBeforeTheTail, "2", "2", "was not accepted")]
    [InlineData(SeededCloseFault.ReceiverBySequenceAlone, "2", "2", "was not accepted")]
    [InlineData(SeededCloseFault.ReceiverLooksForTheSettledTail, "2", "2", "was not accepted")]
    [InlineData(SeededCloseFault.BatchByItsFirstValue, "1 1", "2", "was not accepted")]
    [InlineData(SeededCloseFault.BatchLooksForTheCloseFirst, "2", "2", "was not accepted")]
    public void Exploration_OfATwinOfOneSenderWithAFault_FindsIt(
        SeededCloseFault fault, string pushes, string pops, string expected)
    {
        ExplorationResult OfTwin(SeededCloseFault with) => Explore(
            "StoreBuffers", new FaultyClosingRing(with, Capacity), pushes, pops, mayFenceAll: true,
            countsFirst: with == SeededCloseFault.CountersBeforeTheClose);

        AssertFound(OfTwin(SeededCloseFault.None), OfTwin(fault), expected);
    }

    /// <summary>As above, of many senders.</summary>
    [Theory, Trait("Clause", "3.5")]
    [InlineData(SeededBatchFault.CountersBeforeTheClose, "2|1", "", "are counted")]
    [InlineData(SeededBatchFault.CloseByAFlag, "2|1", "", "are counted")]
    [InlineData(SeededBatchFault.ReservesOneByOne, "2", "", "are counted")]
    [InlineData(SeededBatchFault.CountsWhatWasOffered, "1|2", "", "are counted")]
    [InlineData(SeededBatchFault.NoSwap, "1|1", "", "are counted")]
    [InlineData(SeededBatchFault.ReceiverByTheTail, "2", "2", "was not pushed")]
    public void Exploration_OfATwinOfManySendersWithAFault_FindsIt(
        SeededBatchFault fault, string pushes, string pops, string expected)
    {
        ExplorationResult OfTwin(SeededBatchFault with) => Explore(
            "StoreBuffers", new FaultyClosingBatches(with, Capacity), pushes, pops, mayFenceAll: false,
            countsFirst: with == SeededBatchFault.CountersBeforeTheClose);

        AssertFound(OfTwin(SeededBatchFault.None), OfTwin(fault), expected);
    }

    private void AssertFound(ExplorationResult right, ExplorationResult wrong, string expected)
    {
        output.WriteLine(wrong.ToString());
        Assert.True(right.Fault is null, right.ToString());
        Assert.Contains(expected, wrong.Fault, StringComparison.Ordinal);
    }

    private void AssertNothingIsLost(string kind, string memory, bool wakes, string pushes, string pops)
    {
        // A receiver that is woken is what makes a push fence. Its wake stays pending, so that there is one at most.
        WakeUpEvent<ExploredSyncPoints>? receiver = wakes ? new() : null;
        MessageQueue<int, ExploredSyncPoints> queue = kind == Pair
            ? new SingleProducerRing<int, ExploredSyncPoints>("q", Capacity, receiver, start: -1)
            : new MultiProducerRing<int, ExploredSyncPoints>("q", Capacity, receiver, start: -1);

        ExplorationResult result = Explore(memory, queue, pushes, pops, mayFenceAll: kind == Pair);

        output.WriteLine(result.ToString());
        Assert.True(result.Fault is null, result.ToString());
    }

    private static ExplorationResult Explore(
        string memory, MessageQueue<int, ExploredSyncPoints> queue, string pushes, string pops, bool mayFenceAll,
        bool countsFirst = false)
    {
        string[] senders = pushes.Split('|');
        Action[] threads =
        [
            .. senders.Select((sizes, i) => new Action(() => Push(queue, i, Numbers(sizes)))),
            () => Close(queue, countsFirst),
            .. pops.Length > 0 ? [() => Pop(queue, senders.Length, Numbers(pops))] : Array.Empty<Action>(),
        ];

        // The locations: head, tail, head as it was last seen, half wraps, limit, last mark, last tail, state and time
        // of the wake, and of each slot its value and sequence.
        // Without folding: a sender keeps what it has read for longer than places that look alike are watched.
        return Explorer.Explore(
            new SmallModel(Notes, Check, threads) { MayFenceAll = mayFenceAll, Locations = 9 + (2 * Capacity) },
            new ExplorerOptions(MemoryModels.Named(memory)) { WatchedSteps = 0 });
    }

    private static int[] Numbers(string text) => [.. text.Split(' ').Select(int.Parse)];

    private static void Check(ExploredState state)
    {
        int accepted = state.Note(Accepted);
        int count = Enumerable.Range(0, 31).Count(bit => (accepted & (1 << bit)) != 0);
        state.Require(count == state.Note(Counted), $"{count} were accepted, {state.Note(Counted)} are counted");
        int others = state.Note(Popped) & ~accepted;
        state.Require(others == 0, $"{others:x} was not accepted and was taken out all the same");
    }

    // Each value is a bit, so that one that was rejected differs from the one that is pushed after it.
    private static int Value(int sender, int number) => 1 << ((8 * sender) + number);

    private static void Push(MessageQueue<int, ExploredSyncPoints> queue, int sender, int[] sizes)
    {
        int accepted = 0;
        int next = 0;
        foreach (int size in sizes)
        {
            int[] values = [.. Enumerable.Range(next, size).Select(n => Value(sender, n))];
            int count = size > 1 ? queue.PushFrom(values) : queue.Push(values[0]) == PushResult.Queued ? 1 : 0;
            accepted += values.Take(count).Sum();
            next += size;
        }

        ExploredSyncPoints.Note((sender, accepted), state => state.Note(Accepted) |= accepted);
    }

    private static void Pop(MessageQueue<int, ExploredSyncPoints> queue, int senders, int[] sizes)
    {
        var popped = new List<int>();
        foreach (int size in sizes)
        {
            int[] values = new int[size];
            int count = size > 1 ? queue.PopInto(values) : queue.TryPop(out values[0]) ? 1 : 0;
            popped.AddRange(values.Take(count));
        }

        ExploredSyncPoints.Note(string.Join(",", popped), state =>
        {
            foreach (int value in popped)
            {
                state.Require(value != 0 && (value & (value - 1)) == 0, $"{value:x} was not pushed");
                state.Require((state.Note(Popped) & value) == 0, $"{value:x} was taken out twice");
                state.Note(Popped) |= value;
            }

            for (int sender = 0; sender < senders; sender++)
            {
                int[] own = [.. popped.Where(v => (v & (0xFF << (8 * sender))) != 0)];
                state.Require(own.SequenceEqual(own.OrderBy(v => v)), "values of a sender were taken out of order");
            }
        });
    }

    private static void Close(MessageQueue<int, ExploredSyncPoints> queue, bool countsFirst)
    {
        int counted = countsFirst ? (int)queue.Counters.Pushed : 0;
        queue.Close();
        if (!countsFirst)
            counted = (int)queue.Counters.Pushed;
        ExploredSyncPoints.Note(counted, state => state.Note(Counted) = counted);
    }
}
