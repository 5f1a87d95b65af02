using System;
using System.Collections.Generic;
using System.Linq;
using Xunit;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// The classic small programs that distinguish memory models (Alglave, Maranget, Tautschnig: "Herding cats", TOPLAS
/// 2014, figure 3), run by the explorer: what x86 and Arm do is found, and what volatile, interlocked operations and
/// fences forbid is not.
/// </summary>
public sealed class MemoryLitmusTests
{
    private static ExploredSyncPoints P => default;

    private readonly int[] _x = new int[1];
    private readonly int[] _y = new int[1];

    [Theory]
    [InlineData("plain", true)]
    [InlineData("volatile", true)]
    [InlineData("fence", false)]
    [InlineData("interlocked", false)]
    public void StoreBuffering_BothReadTheOld_OnlyWithoutAFence(string kind, bool isPossible)
    {
        void Side(int[] mine, int[] others, int note)
        {
            Write(mine, 1, kind);
            if (kind == "fence")
                P.Fence();
            Record(note, Read(others, kind == "interlocked" ? "volatile" : kind));
        }

        Assert.Equal(isPossible, Outcomes(2, () => Side(_x, _y, 0), () => Side(_y, _x, 1)).Contains("0 0"));
    }

    [Theory]
    [InlineData("plain", true)]
    [InlineData("volatile", false)]
    [InlineData("fence", false)]
    [InlineData("interlocked", false)]
    public void MessagePassing_FlagWithoutData_OnlyPlain(string kind, bool isPossible)
    {
        void Writer()
        {
            P.Write(ref _x[0], 1);
            if (kind == "fence")
                P.Fence();
            Write(_y, 1, kind);
        }

        void Reader()
        {
            Record(0, Read(_y, kind));
            if (kind == "fence")
                P.Fence();
            Record(1, P.Read(ref _x[0]));
        }

        HashSet<string> outcomes = Outcomes(2, Writer, Reader);

        Assert.Equal(isPossible, outcomes.Contains("1 0"));
        Assert.Contains("1 1", outcomes);
        Assert.Contains("0 0", outcomes);
    }

    [Fact]
    public void Coherence_TwoReadsOfOneLocation_NeverGoBack()
    {
        HashSet<string> outcomes = Outcomes(
            2,
            () => { P.Write(ref _x[0], 1); P.Write(ref _x[0], 2); },
            () => { Record(0, P.Read(ref _x[0])); Record(1, P.Read(ref _x[0])); });

        Assert.Equal(["0 0", "0 1", "0 2", "1 1", "1 2", "2 2"], outcomes.OrderBy(o => o, StringComparer.Ordinal));
    }

    [Theory]
    [InlineData("plain", true)]
    [InlineData("volatile", true)]
    [InlineData("interlocked", false)]
    public void TwoWritesEach_FirstOnesWin_OnlyWithoutAFence(string kind, bool isPossible)
    {
        HashSet<string> outcomes = Outcomes(
            2,
            () => { Write(_x, 1, kind); Write(_y, 2, kind); RecordTheEnd(); },
            () => { Write(_y, 1, kind); Write(_x, 2, kind); RecordTheEnd(); });

        Assert.Equal(isPossible, outcomes.Contains("1 1"));
    }

    [Fact]
    public void Interlocked_TwoExchanges_AreNotLost()
    {
        HashSet<string> outcomes = Outcomes(
            2,
            () => Record(0, P.Exchange(ref _x[0], 1)),
            () => Record(1, P.CompareExchange(ref _x[0], 2, 1)));

        Assert.Equal(["0 0", "0 1"], outcomes.OrderBy(o => o, StringComparer.Ordinal));
    }

    /// <summary>
    /// Plain accesses are in order where the writer has a store barrier and the reader a load barrier.
    /// </summary>
    [Theory]
    [InlineData(false, false, true)]
    [InlineData(true, false, true)]
    [InlineData(false, true, true)]
    [InlineData(true, true, false)]
    public void MessagePassing_WithBarriers_OnlyWithBoth(bool storeBarrier, bool loadBarrier, bool isPossible)
    {
        void Writer()
        {
            P.Write(ref _x[0], 1);
            if (storeBarrier)
                P.StoreBarrier();
            P.Write(ref _y[0], 1);
        }

        void Reader()
        {
            Record(0, P.Read(ref _y[0]));
            if (loadBarrier)
                P.LoadBarrier();
            Record(1, P.Read(ref _x[0]));
        }

        Assert.Equal(isPossible, Outcomes(2, Writer, Reader).Contains("1 0"));
    }

    /// <summary>Barriers are no fences: a write may still be delayed past a later read.</summary>
    [Fact]
    public void StoreBuffering_WithBarriers_BothReadTheOld()
    {
        void Side(int[] mine, int[] others, int note)
        {
            P.Write(ref mine[0], 1);
            P.StoreBarrier();
            P.LoadBarrier();
            Record(note, P.Read(ref others[0]));
        }

        Assert.Contains("0 0", Outcomes(2, () => Side(_x, _y, 0), () => Side(_y, _x, 1)));
    }

    /// <summary>A fence that one thread makes for all is enough for both.</summary>
    [Theory]
    [InlineData(false, true)]
    [InlineData(true, false)]
    public void StoreBuffering_OneFencesAllThreads_BothReadTheOldOnlyWithout(bool fences, bool isPossible)
    {
        void Fencing()
        {
            P.Write(ref _x[0], 1);
            if (fences)
                P.FenceAllThreads();
            Record(0, P.Read(ref _y[0]));
        }

        void Other()
        {
            P.Write(ref _y[0], 1);
            Record(1, P.Read(ref _x[0]));
        }

        Assert.Equal(isPossible, Outcomes(2, Fencing, Other).Contains("0 0"));
    }

    [Fact]
    public void SequentialConsistency_StoreBuffering_IsNotFound()
    {
        HashSet<string> outcomes = Outcomes(
            2,
            MemoryModel.SequentiallyConsistent,
            () => { P.Write(ref _x[0], 1); Record(0, P.Read(ref _y[0])); },
            () => { P.Write(ref _y[0], 1); Record(1, P.Read(ref _x[0])); });

        Assert.Equal(["0 1", "1 0", "1 1"], outcomes.OrderBy(o => o, StringComparer.Ordinal));
    }

    /// <summary>
    /// What is explored on a weaker memory need not be on a stronger one: each read may be shown the newest value there
    /// too, and each write be the last.
    /// </summary>
    [Theory]
    [InlineData("plain")]
    [InlineData("volatile")]
    [InlineData("interlocked")]
    public void Outcomes_OfAStrongerMemory_AreFoundOnTheWeakerOnes(string kind)
    {
        Action[][] programs =
        [
            [
                () => { Write(_x, 1, kind); Record(0, Read(_y, kind)); },
                () => { Write(_y, 1, kind); Record(1, Read(_x, kind)); },
            ],
            [
                () => { Write(_x, 1, kind); Write(_y, 1, kind); },
                () => { Record(0, Read(_y, kind)); Record(1, Read(_x, kind)); },
            ],
            [
                () => { Write(_x, 1, kind); Write(_y, 2, kind); RecordTheEnd(); },
                () => { Write(_y, 1, kind); Write(_x, 2, kind); RecordTheEnd(); },
            ],
        ];
        foreach (Action[] program in programs)
        {
            HashSet<string> sequential = Outcomes(2, MemoryModel.SequentiallyConsistent, program);
            HashSet<string> buffered = Outcomes(2, MemoryModel.StoreBuffers, program);
            HashSet<string> weak = Outcomes(2, MemoryModel.Weak, program);

            Assert.Subset(buffered, sequential);
            Assert.Subset(weak, buffered);
        }
    }

    /// <summary>What a store buffer does, and what it does not: reads stay in order.</summary>
    [Theory]
    [InlineData("plain", true, true)]
    [InlineData("volatile", true, false)]
    [InlineData("interlocked", false, false)]
    public void StoreBuffers_DelayWritesPastReads_AndPlainOnesPastEachOther(string kind, bool delays, bool reorders)
    {
        HashSet<string> buffering = Outcomes(
            2,
            MemoryModel.StoreBuffers,
            () => { Write(_x, 1, kind); Record(0, P.Read(ref _y[0])); },
            () => { Write(_y, 1, kind); Record(1, P.Read(ref _x[0])); });
        HashSet<string> passing = new MemoryLitmusTests().PassThroughStoreBuffers(kind);

        Assert.Equal(delays, buffering.Contains("0 0"));
        Assert.Equal(reorders, passing.Contains("1 0"));
    }

    /// <summary>
    /// Steps of two threads that do not meet interleave in as many ways as the binomial coefficient says.
    /// </summary>
    [Fact]
    public void Interleavings_OfThreadsThatDoNotMeet_AreAsManyAsTheBinomialCoefficient()
    {
        var model = new SmallModel(
            0,
            static _ => { },
            () => { P.Write(ref _x[0], 1); P.Write(ref _x[0], 2); P.Write(ref _x[0], 3); },
            () => { P.Write(ref _y[0], 1); P.Write(ref _y[0], 2); P.Write(ref _y[0], 3); P.Write(ref _y[0], 4); });

        Assert.Equal(
            35,
            Explorer.Explore(model, new ExplorerOptions(MemoryModel.Weak) { TakesFreeSteps = false }).Interleavings);
    }

    private HashSet<string> PassThroughStoreBuffers(string kind)
        => Outcomes(
            2,
            MemoryModel.StoreBuffers,
            () => { Write(_x, 1, kind); Write(_y, 1, kind); },
            () => { Record(0, P.Read(ref _y[0])); Record(1, P.Read(ref _x[0])); });

    private static void Write(int[] location, int value, string kind)
    {
        if (kind == "volatile")
            P.VolatileWrite(ref location[0], value);
        else if (kind == "interlocked")
            P.Exchange(ref location[0], value);
        else
            P.Write(ref location[0], value);
    }

    private static int Read(int[] location, string kind)
        => kind switch
        {
            "volatile" => P.VolatileRead(ref location[0]),
            "interlocked" => P.CompareExchange(ref location[0], 0, 0),
            _ => P.Read(ref location[0]),
        };

    private static void Record(int note, int value)
        => ExploredSyncPoints.Note((note, value), state => state.Note(note) = value);

    // What the locations hold in the end: the last one to record does so after all writes.
    private void RecordTheEnd()
    {
        Record(0, Read(_x, "interlocked"));
        Record(1, Read(_y, "interlocked"));
    }

    private HashSet<string> Outcomes(int notes, params Action[] threads) => Outcomes(notes, MemoryModel.Weak, threads);

    // Free steps make no difference.
    private HashSet<string> Outcomes(int notes, MemoryModel memory, params Action[] threads)
    {
        HashSet<string> all = Explore(notes, new ExplorerOptions(memory) { TakesFreeSteps = false }, threads);
        HashSet<string> found = Explore(notes, new ExplorerOptions(memory), threads);

        Assert.Equal(all.OrderBy(o => o, StringComparer.Ordinal), found.OrderBy(o => o, StringComparer.Ordinal));
        return found;
    }

    private HashSet<string> Explore(int notes, ExplorerOptions options, Action[] threads)
    {
        _x[0] = _y[0] = 0;
        var outcomes = new HashSet<string>(StringComparer.Ordinal);
        var model = new SmallModel(
            notes, state => outcomes.Add(string.Join(" ", Enumerable.Range(0, notes).Select(i => state.Note(i)))),
            threads)
        {
            MayFenceAll = true,
        };
        Assert.Null(Explorer.Explore(model, options).Fault);
        return outcomes;
    }
}
