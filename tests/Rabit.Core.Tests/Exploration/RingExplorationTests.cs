using System;
using System.Linq;
using Rabit.Core.Queues;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// Contract 3.1 and 3.2 in every interleaving of the two lock-free queues: nothing is lost, doubled or seen before it
/// is there; first in first out for each sender; never more than the capacity, and rejected only when it is full; the
/// counters are those of one instant. The positions wrap round meanwhile.
/// </summary>
public sealed class RingExplorationTests(ITestOutputHelper output)
{
    private const string Pair = "pair";
    private const string Ring = "ring";

    /// <summary>Kind, memory, pushes of each sender, pops, batch, looks at the counters.</summary>
    public static TheoryData<string, string, string, int, int, int> Small() => new()
    {
        { Pair, "SequentiallyConsistent", "4", 4, 1, 0 },
        { Pair, "SequentiallyConsistent", "2", 2, 2, 1 },
        { Pair, "StoreBuffers", "4", 4, 1, 0 },
        { Pair, "Weak", "5", 5, 1, 0 },
        { Pair, "Weak", "3", 3, 2, 0 },
        { Pair, "Weak", "1", 1, 1, 1 },
        { Pair, "SequentiallyConsistent", "2", 2, 3, 0 },
        { Pair, "Weak", "1", 2, 3, 0 },
        { Ring, "SequentiallyConsistent", "1 1", 2, 3, 0 },
        { Ring, "StoreBuffers", "2 1", 2, 1, 0 },
        { Ring, "Weak", "1 1", 2, 1, 0 },
        { Ring, "Weak", "1 1", 2, 2, 0 },
        { Ring, "Weak", "4", 4, 1, 0 },
    };

    /// <summary>As <see cref="Small"/>.</summary>
    public static TheoryData<string, string, string, int, int, int> Large() => new()
    {
        { Pair, "SequentiallyConsistent", "4", 4, 1, 1 },
        { Pair, "Weak", "3", 3, 1, 1 },
        { Pair, "Weak", "2", 2, 3, 0 },
        { Ring, "SequentiallyConsistent", "1 1", 2, 1, 1 },
        { Ring, "SequentiallyConsistent", "2 2", 3, 1, 0 },
        { Ring, "StoreBuffers", "2 2", 3, 1, 0 },
        { Ring, "Weak", "1 1", 1, 1, 1 },
        { Ring, "Weak", "2 1", 3, 1, 0 },
        { Ring, "Weak", "1 1 1", 2, 1, 0 },
    };

    [Theory, Trait("Clause", "3.1"), Trait("Clause", "3.2")]
    [MemberData(nameof(Small))]
    public void Queue_InEveryInterleaving_LosesNothingAndKeepsItsOrder(
        string kind, string memory, string pushes, int pops, int batch, int looks)
        => AssertNoFault(kind, memory, pushes, pops, batch, looks);

    [Theory, Trait("Category", "Long")]
    [MemberData(nameof(Large))]
    public void Queue_InEveryInterleavingOfMore_LosesNothingAndKeepsItsOrder(
        string kind, string memory, string pushes, int pops, int batch, int looks)
        => AssertNoFault(kind, memory, pushes, pops, batch, looks);

    /// <summary>Kind, memory, engine, values of each sender, capacity, batch, whether senders wait.</summary>
    public static TheoryData<string, string, string, string, int, int, bool> SmallWakes() => new()
    {
        { Pair, "Weak", "event", "2", 2, 1, false },
        { Pair, "StoreBuffers", "futex", "2", 2, 1, false },
        { Ring, "StoreBuffers", "event", "1 1", 2, 1, false },
        { Ring, "Weak", "event", "2", 2, 1, false },
        { Pair, "StoreBuffers", "event", "3", 1, 1, true },
        { Pair, "Weak", "event", "2", 1, 1, true },
        { Ring, "StoreBuffers", "event", "4", 2, 1, true },
        { Ring, "Weak", "futex", "2", 1, 1, true },
        { Pair, "StoreBuffers", "event", "2", 2, 2, false },
        { Ring, "StoreBuffers", "event", "2", 2, 2, false },
        { Ring, "Weak", "event", "2", 2, 2, false },
        { Pair, "StoreBuffers", "event", "3", 1, 2, true },
        { Ring, "StoreBuffers", "event", "4", 2, 2, true },
        { Pair, "StoreBuffers", "event", "4", 4, 2, false },
        { Ring, "StoreBuffers", "event", "4", 4, 2, false },
    };

    /// <summary>As <see cref="SmallWakes"/>.</summary>
    public static TheoryData<string, string, string, string, int, int, bool> LargeWakes() => new()
    {
        { Pair, "StoreBuffers", "event", "4", 2, 1, true },
        { Pair, "Weak", "event", "4", 2, 1, true },
        { Pair, "Weak", "futex", "3", 2, 1, false },
        { Ring, "StoreBuffers", "event", "2 1", 2, 1, false },
        { Ring, "Weak", "event", "1 1", 2, 1, false },
        { Ring, "Weak", "event", "4", 2, 1, true },
        { Ring, "StoreBuffers", "futex", "1 1", 2, 1, false },
        { Ring, "StoreBuffers", "event", "2 1", 2, 2, false },
        { Pair, "Weak", "event", "4", 2, 2, true },
        { Ring, "Weak", "event", "4", 2, 2, true },
    };

    [Theory, Trait("Clause", "1.4"), Trait("Clause", "3.1")]
    [MemberData(nameof(SmallWakes))]
    public void PushAndPop_OfSleepersInEveryInterleaving_WakeThem(
        string kind, string memory, string engine, string pushes, int capacity, int batch, bool wait)
        => AssertWakes(kind, memory, engine, pushes, capacity, batch, wait);

    [Theory, Trait("Category", "Long")]
    [MemberData(nameof(LargeWakes))]
    public void PushAndPop_OfMoreSleepersInEveryInterleaving_WakeThem(
        string kind, string memory, string engine, string pushes, int capacity, int batch, bool wait)
        => AssertWakes(kind, memory, engine, pushes, capacity, batch, wait);

    /// <summary>That the exploration finds what it is for.</summary>
    [Theory]
    [InlineData(SeededRingFault.CapacityOffByOne)]
    [InlineData(SeededRingFault.SequenceBeforeTheValue)]
    [InlineData(SeededRingFault.PlainSequence)]
    [InlineData(SeededRingFault.SequenceNotChecked)]
    [InlineData(SeededRingFault.ValueReadFirst)]
    [InlineData(SeededRingFault.HeadBeforeTheRead)]
    public void Exploration_OfATwinWithAFault_FindsIt(SeededRingFault fault)
    {
        var scenario = new RingScenario([4], Pops: 3, Capacity: 2);

        ExplorationResult right = Explore(
            "Weak", new RingModel(scenario, new FaultyRing(SeededRingFault.None, scenario.Capacity)));
        ExplorationResult wrong = Explore(
            "Weak", new RingModel(scenario, new FaultyRing(fault, scenario.Capacity)));

        output.WriteLine(wrong.ToString());
        Assert.True(right.Fault is null, right.ToString());
        Assert.NotNull(wrong.Fault);
    }

    /// <summary>As above, for several values at once.</summary>
    [Fact]
    public void Exploration_OfATwinThatShowsTheLastValueFirst_FindsIt()
    {
        var scenario = new RingScenario([1], Pops: 1, Capacity: 4) { Batch = 3 };

        ExplorationResult right = Explore(
            "Weak", new RingModel(scenario, new FaultyRing(SeededRingFault.None, scenario.Capacity)));
        ExplorationResult wrong = Explore(
            "Weak", new RingModel(scenario, new FaultyRing(SeededRingFault.LastBeforeTheOthers, scenario.Capacity)));

        output.WriteLine(wrong.ToString());
        Assert.True(right.Fault is null, right.ToString());
        Assert.NotNull(wrong.Fault);
    }

    /// <summary>As above, for what is lost: a wake of the receiver or of a sender that is skipped, a value.</summary>
    [Theory]
    [InlineData(SeededRingFault.UnfencedCheckOfThePush, "2", false)]
    [InlineData(SeededRingFault.WakesOnlyWhenEmpty, "2", false)]
    [InlineData(SeededRingFault.UnfencedCheckOfThePop, "4", true)]
    [InlineData(SeededRingFault.NoSwap, "1 1", false)]
    public void Exploration_OfATwinThatLosesAWakeOrAValue_FindsIt(SeededRingFault fault, string pushes, bool wait)
    {
        var scenario = new RingWakeScenario([.. pushes.Split(' ').Select(int.Parse)], Capacity: 2)
        {
            SendersWait = wait,
        };

        ExplorationResult right = Wakes(SeededRingFault.None);
        ExplorationResult wrong = Wakes(fault);

        output.WriteLine(wrong.ToString());
        Assert.True(right.Fault is null, right.ToString());
        Assert.NotNull(wrong.Fault);

        ExplorationResult Wakes(SeededRingFault withFault) => Explore(
            "StoreBuffers", new RingWakeModel(scenario, On("event"), (receiver, sender) =>
                new FaultyRing(withFault, scenario.Capacity, receiver, sender)));
    }

    private void AssertNoFault(string kind, string memory, string pushes, int pops, int batch, int looks)
    {
        // Of more than two at once there are some between the first and the last, which may be of two senders.
        int capacity = batch > 2 ? batch + 1 : 2;
        var scenario = new RingScenario([.. pushes.Split(' ').Select(int.Parse)], pops, capacity)
        {
            Batch = batch,
            Looks = looks,
            IsSeenAtOnce = memory == nameof(MemoryModel.SequentiallyConsistent),
        };

        ExplorationResult result = Explore(
            memory, new RingModel(scenario, Create(kind, scenario.Capacity)));

        output.WriteLine(result.ToString());
        Assert.True(result.Fault is null, result.ToString());
    }

    private void AssertWakes(
        string kind, string memory, string engine, string pushes, int capacity, int batch, bool wait)
    {
        var scenario = new RingWakeScenario([.. pushes.Split(' ').Select(int.Parse)], capacity)
        {
            SendersWait = wait,
            Batch = batch,
        };

        ExplorationResult result = Explore(memory, new RingWakeModel(scenario, On(engine), (receiver, sender) =>
        {
            MessageQueue<int, ExploredSyncPoints> queue = Create(kind, capacity, receiver);
            if (sender is not null)
                queue.AddPopTarget(sender);
            return queue;
        }));

        output.WriteLine(result.ToString());
        Assert.True(result.Fault is null, result.ToString());
    }

    private static MessageQueue<int, ExploredSyncPoints> Create(
        string kind, int capacity, WakeUpEvent<ExploredSyncPoints>? receiver = null) => kind == Pair
            ? new SingleProducerRing<int, ExploredSyncPoints>("q", capacity, receiver, start: -1)
            : new MultiProducerRing<int, ExploredSyncPoints>("q", capacity, receiver, start: -1);

    private static Func<RunClock, IWaitSignal> On(string engine) => engine == "futex"
        ? clock => new FutexWaitSignal<ExploredSyncPoints>(clock)
        : clock => new EventWaitSignal<ExploredSyncPoints>(clock);

    // Without folding: a sender keeps what it has read for longer than places that look alike are watched.
    private static ExplorationResult Explore(string memory, ExploredModel model)
        => Explorer.Explore(
            model,
            new ExplorerOptions(MemoryModels.Named(memory)) { WatchedSteps = 0 });
}
