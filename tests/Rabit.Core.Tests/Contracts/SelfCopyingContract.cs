using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Tests.Messages;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 2.5: classes that copy themselves.</summary>
public abstract class SelfCopyingContract(TimeKind kind) : ContractTests(kind)
{
    [Fact, Trait("Clause", "2.1"), Trait("Clause", "2.5")]
    public void PostAndFetch_SelfCopyingClass_CopiesIntoInstancesThatAreNotShared()
    {
        using Pair pair = Connect();
        pair.Run.On(pair.Poster, () =>
        {
            Assert.Equal(3, pair.Publisher.Value.Number);
            pair.Publisher.Value.Fill(7);
            pair.Publisher.Post();
            pair.Publisher.Value.Fill(8);
        });
        pair.Run.On(pair.Fetcher, () =>
        {
            Assert.Equal(3, pair.Subscriber.Value.Number);
            Assert.True(pair.Subscriber.Fetch());
            Assert.Equal(7, pair.Subscriber.Value.Number);
            Assert.True(pair.Subscriber.Value.IsWhole);
        });
    }

    [Fact, Trait("Clause", "2.2"), Trait("Clause", "2.5")]
    public void Fetch_ChangedLocally_StaysLocalAndIsLostAtTheNextFetch()
    {
        using Pair pair = Connect();
        MessageSubscriber<TestScan> other = pair.Run.Reactor.Workspace.Subscribe<TestScan>("scan");
        pair.Run.On(pair.Fetcher, () => pair.Subscriber.Value.Fill(99));
        Assert.False(other.Fetch());
        Assert.Equal(3, other.Value.Number);

        pair.Run.On(pair.Poster, () => Assert.Equal(3, pair.Publisher.Value.Number));
        pair.Run.On(pair.Fetcher, () =>
        {
            Assert.False(pair.Subscriber.ForceFetch());
            Assert.Equal(3, pair.Subscriber.Value.Number);
        });
    }

    [Fact, Trait("Clause", "2.2"), Trait("Clause", "2.5")]
    public void PostOfAValue_SelfCopyingClass_CopiesTheInstanceThatStaysTheCallers()
    {
        using Pair pair = Connect();
        TestScan scan = TestScan.Filled(7);
        pair.Run.On(pair.Poster, () =>
        {
            pair.Publisher.Post(scan);
            Assert.NotSame(scan, pair.Publisher.Value);
            scan.Fill(8);
            Assert.Equal(7, pair.Publisher.Value.Number);

            pair.Publisher.Value.Fill(9);
            pair.Publisher.Post(pair.Publisher.Value);
        });
        pair.Run.On(pair.Fetcher, () =>
        {
            Assert.True(pair.Subscriber.Fetch(out TestScan fetched));
            Assert.Same(pair.Subscriber.Value, fetched);
            Assert.Equal(9, fetched.Number);
            Assert.True(fetched.IsWhole);
        });
    }

    [Fact, Trait("Clause", "2.4"), Trait("Clause", "2.5")]
    public void PostOfAValue_CopyMethodThrows_LeavesTheLocalCopyWholeAndPostsNothing()
    {
        using Pair pair = Connect();
        TestScan scan = TestScan.Filled(7);
        scan.OnCopy = () => throw new FormatException("bad point");
        pair.Run.On(pair.Poster, () =>
        {
            InvalidOperationException error = Assert.Throws<InvalidOperationException>(() => pair.Publisher.Post(scan));

            AssertNames(error, "'scan'", "TestScan.CopyTo", "posted", "FormatException", "bad point");
            AssertNames(Assert.Throws<InvalidOperationException>(() => pair.Publisher.Post(null!)), "'scan'", "null");
            Assert.Equal((3, 0), (pair.Publisher.Value.Number, pair.Publisher.Stamp.Version));
            Assert.True(pair.Publisher.Value.IsWhole);
        });
        pair.Run.On(pair.Fetcher, () => Assert.False(pair.Subscriber.Fetch()));
    }

    [Fact, Trait("Clause", "2.5")]
    public void Initial_ChangedByItsMakerAfterTheStart_ChangesNoCopy()
    {
        TestScan initial = TestScan.Filled(3);
        using Pair pair = Connect(initial);
        initial.Fill(5);

        pair.Run.On(pair.Poster, () => Assert.Equal(3, pair.Publisher.Value.Number));
        Assert.Equal(3, pair.Run.Reactor.Workspace.Subscribe<TestScan>("scan").Value.Number);
    }

    [Fact, Trait("Clause", "2.4"), Trait("Clause", "2.5")]
    public void Post_CopyMethodThrows_ThrowsToThePosterAndHarmsNoOther()
    {
        using Pair pair = Connect();
        pair.Run.On(pair.Poster, () =>
        {
            pair.Publisher.Value.Fill(7);
            pair.Publisher.Post();
            pair.Publisher.Value.Fill(8);
            pair.Publisher.Value.OnCopy = () => throw new FormatException("bad point");

            InvalidOperationException thrown = Assert.Throws<InvalidOperationException>(pair.Publisher.Post);

            AssertNames(thrown, "'scan'", "TestScan.CopyTo", "posted", "FormatException", "bad point");
            Assert.Equal(1, pair.Publisher.Stamp.Version);
        });
        pair.Run.On(pair.Fetcher, () =>
        {
            Assert.True(pair.Subscriber.FetchAndCountMissed(out int missed));
            Assert.Equal(0, missed);
            Assert.Equal(7, pair.Subscriber.Value.Number);
            Assert.True(pair.Subscriber.Value.IsWhole);
        });
        pair.Run.On(pair.Poster, () =>
        {
            pair.Publisher.Value.OnCopy = null;
            pair.Publisher.Post();
        });
        pair.Run.On(pair.Fetcher, () =>
        {
            Assert.True(pair.Subscriber.Fetch());
            Assert.Equal(8, pair.Subscriber.Value.Number);
            Assert.True(pair.Subscriber.Value.IsWhole);
        });
    }

    [Fact, Trait("Clause", "2.4"), Trait("Clause", "2.5")]
    public void Fetch_CopyMethodThrows_ThrowsToTheFetcherWhoKeepsItsWholeValueAndTriesAgain()
    {
        using Pair pair = Connect();
        bool fails = false;
        pair.Run.On(pair.Poster, () =>
        {
            pair.Publisher.Value.Fill(7);
            pair.Publisher.Value.OnCopy = () =>
            {
                if (fails)
                    throw new FormatException("bad point");
            };
            pair.Publisher.Post();
        });
        pair.Run.On(pair.Fetcher, () =>
        {
            fails = true;
            AssertNames(
                Assert.Throws<InvalidOperationException>(() => pair.Subscriber.Fetch()), "'scan'", "TestScan.CopyTo",
                "fetched", "bad point");
            Assert.Equal(3, pair.Subscriber.Value.Number);
            Assert.True(pair.Subscriber.Value.IsWhole);
            Assert.Equal(0, pair.Subscriber.Stamp.Version);

            fails = false;
            Assert.True(pair.Subscriber.Fetch());
            Assert.Equal(7, pair.Subscriber.Value.Number);
        });
    }

    [Fact, Trait("Clause", "1.7"), Trait("Clause", "2.5")]
    public void CopyMethodThrows_NotCaught_IsAFaultInTheLogThatNamesManagerAndMessage()
    {
        using Pair pair = Connect();
        pair.Poster.FaultPolicy = FaultPolicy.StopSystem;
        pair.Poster.OnUnit = () =>
        {
            pair.Publisher.Value.OnCopy = () => throw new FormatException("bad point");
            pair.Publisher.Post();
        };
        pair.Poster.WakeUp();
        Assert.Equal(1, pair.Run.FinishByItself().ExitCode);

        RabitLogEntry entry = pair.Run.Log.First(e => e.Kind == RabitLogKind.Fault);
        Assert.Equal("poster", entry.Source);
        Assert.Contains("'scan'", entry.Text, StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "2.5")]
    public void CopyMethod_ThatUsesItsOwnMessage_IsAnErrorThatNamesIt()
    {
        using Pair pair = Connect();
        pair.Run.On(pair.Poster, () =>
        {
            pair.Publisher.Value.OnCopy = pair.Publisher.Post;
            AssertNames(Assert.Throws<InvalidOperationException>(pair.Publisher.Post), "'scan'", "which it is copying");
            pair.Publisher.Value.OnCopy = null;
            pair.Publisher.Value = null!;
            AssertNames(Assert.Throws<InvalidOperationException>(pair.Publisher.Post), "'scan'", "null");
        });
        pair.Run.On(pair.Fetcher, () => Assert.False(pair.Subscriber.Fetch()));
    }

    [Fact, Trait("Clause", "2.5"), Trait("Clause", "4.2")]
    public void Start_SelfCopyingClassThatCannotBeTrusted_IsReportedWithItsName()
    {
        Assert.Contains("'m': Open copies itself but is not sealed", FaultOf(new Open()), StringComparison.Ordinal);
        Assert.Contains(
            "'m': ClonesToItself.Clone gives the same instance", FaultOf(new ClonesToItself()),
            StringComparison.Ordinal);
        Assert.Contains("'m': ClonesToNull.Clone gives null", FaultOf(new ClonesToNull()), StringComparison.Ordinal);
        Assert.Contains(
            "'m': CannotClone.Clone threw FormatException: no", FaultOf(new CannotClone()), StringComparison.Ordinal);
        Assert.Contains("must state a first value", FaultOf<TestScan>(null), StringComparison.Ordinal);
        Assert.Contains("'m': HoldsScan.Scan", FaultOf(default(HoldsScan)), StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "2.5")]
    public void Subscribe_OptionalWithoutAPublisher_IsNull()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        MessageSubscriber<TestScan> subscriber = manager.Subscribe<TestScan>("scan", optional: true);
        run.StartAndSettle();
        run.On(manager, () =>
        {
            Assert.False(subscriber.Fetch());
            Assert.Null(subscriber.Value);
        });
    }

    private static void AssertNames(Exception thrown, params string[] parts)
        => Assert.All(parts, part => Assert.Contains(part, thrown.Message, StringComparison.Ordinal));

    private string FaultOf<T>(T? initial)
    {
        using TestRun run = NewRun();
        run.Add("manager").Publish("m", initial!);
        IReadOnlyList<string> faults = Assert.Throws<RabitWiringException>(run.Start).Faults;
        return Assert.Single(faults);
    }

    private Pair Connect(TestScan? initial = null) => new(NewRun(), initial ?? TestScan.Filled(3));

    /// <summary>One manager that posts a scan and one that fetches it.</summary>
    private sealed class Pair : IDisposable
    {
        public Pair(TestRun run, TestScan initial)
        {
            Run = run;
            Poster = run.Add("poster");
            Fetcher = run.Add("fetcher");
            Publisher = Poster.Publish("scan", initial);
            Subscriber = Fetcher.Subscribe<TestScan>("scan");
            run.StartAndSettle();
        }

        public TestRun Run { get; }

        public ScriptedManager Poster { get; }

        public ScriptedManager Fetcher { get; }

        public MessagePublisher<TestScan> Publisher { get; }

        public MessageSubscriber<TestScan> Subscriber { get; }

        public void Dispose() => Run.Dispose();
    }

#pragma warning disable CA1852, CS0649 // Not sealed on purpose; only its shape matters.
    private class Open : ISelfCopying<Open>
    {
        public Open Clone() => new();

        public void CopyTo(Open target)
        {
        }
    }

    private struct HoldsScan
    {
        public TestScan Scan;
    }
#pragma warning restore

    private sealed class ClonesToItself : ISelfCopying<ClonesToItself>
    {
        public ClonesToItself Clone() => this;

        public void CopyTo(ClonesToItself target)
        {
        }
    }

    private sealed class ClonesToNull : ISelfCopying<ClonesToNull>
    {
        public ClonesToNull Clone() => null!;

        public void CopyTo(ClonesToNull target)
        {
        }
    }

    private sealed class CannotClone : ISelfCopying<CannotClone>
    {
        public CannotClone Clone() => throw new FormatException("no");

        public void CopyTo(CannotClone target)
        {
        }
    }
}

public sealed class SelfCopyingInRealTime() : SelfCopyingContract(TimeKind.Real);

public sealed class SelfCopyingInVirtualTime() : SelfCopyingContract(TimeKind.Virtual);
