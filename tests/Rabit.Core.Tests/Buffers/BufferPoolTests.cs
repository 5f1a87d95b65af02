using System;
using System.Linq;
using System.Threading;
using Rabit.Core.Locks;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Buffers;

/// <summary>
/// Contract 2.5: a large buffer has one owner at a time, and one that was handed on or given back is dead for who had
/// it.
/// </summary>
public sealed class BufferPoolTests
{
    private readonly BufferPool _pool = new("pictures", 2, 16);

    [Fact, Trait("Clause", "2.5")]
    public void TryRent_FreeBuffer_HasItsBytesAndItsHolder()
    {
        BufferLease lease = Rent("camera");

        Assert.False(lease.IsEmpty);
        Assert.Equal(16, lease.Span.Length);
        Assert.Equal(16, lease.Array.Length);
        lease.Span[3] = 7;
        Assert.Equal(7, lease.Array[3]);
        Assert.Equal(1, _pool.Free);
        Assert.Equal(["camera"], _pool.Holders());
    }

    [Fact, Trait("Clause", "1.8")]
    public void LockOfAPool_WhereTheSystemHasSuch_InheritsThePriority()
        => Assert.Equal(PriorityInheritanceMutex.IsThere, _pool.InheritsPriority);

    [Fact, Trait("Clause", "2.5")]
    public void TryRent_NoneFree_IsFalseEmptyAndCounted()
    {
        Rent("a");
        Rent("b");

        Assert.False(_pool.TryRent("c", out BufferLease none));
        Assert.False(_pool.TryRent("c", out _));
        Assert.True(none.IsEmpty);
        Assert.Equal(2, _pool.Refused);
        Assert.Equal(0, _pool.Free);
        Assert.Equal(
            "Pool 'pictures': 0 of 2 buffers are free, 2 times none was; 'a' has 1; 'b' has 1.", _pool.Describe());
    }

    [Fact, Trait("Clause", "2.5")]
    public void Describe_AllGivenBack_NamesNoOwner()
    {
        Rent("a").Dispose();
        Assert.Equal("Pool 'pictures': 2 of 2 buffers are free, 0 times none was.", _pool.Describe());
        Assert.Empty(_pool.Holders());
    }

    [Fact, Trait("Clause", "2.5")]
    public void HandTo_NewOwner_OldCopiesThrowAndNamePoolAndHolder()
    {
        BufferLease old = Rent("camera");
        BufferLease copy = old;
        old.Span[0] = 42;

        BufferLease owned = old.HandTo("detector");

        Assert.Equal(42, owned.Span[0]);
        Assert.Equal(["detector"], _pool.Holders());
        foreach (BufferLease stale in new[] { old, copy })
        {
            AssertRefused(() => _ = stale.Array, "'pictures'", "'detector' has it now");
            AssertRefused(() => _ = stale.Span.Length, "'pictures'", "'detector' has it now");
            AssertRefused(() => stale.HandTo("thief"), "'pictures'", "'detector' has it now");
        }

        Assert.Equal(["detector"], _pool.Holders());
    }

    [Fact, Trait("Clause", "2.5")]
    public void Dispose_ByAnOldOwner_DoesNotTakeItFromTheNewOne()
    {
        BufferLease old = Rent("camera");
        BufferLease owned = old.HandTo("detector");

        old.Dispose();

        Assert.Equal(1, _pool.Free);
        Assert.Equal(16, owned.Span.Length);
        owned.Dispose();
        Assert.Equal(2, _pool.Free);
    }

    [Fact, Trait("Clause", "2.5")]
    public void Dispose_Twice_GivesBackOnce()
    {
        BufferLease lease = Rent("camera");
        lease.Dispose();
        lease.Dispose();
        default(BufferLease).Dispose();
        Assert.Equal(2, _pool.Free);

        BufferLease first = Rent("a");
        lease.Dispose();
        BufferLease second = Rent("b");

        Assert.NotSame(first.Array, second.Array);
        Assert.Equal(0, _pool.Free);
    }

    [Fact, Trait("Clause", "2.5")]
    public void Use_AfterGivingBack_ThrowsAndNamesTheLastHolder()
    {
        BufferLease lease = Rent("camera");
        BufferLease copy = lease;
        lease.Dispose();

        AssertRefused(() => _ = copy.Array, "'pictures'", "after it was returned", "'camera' had it last");
        AssertRefused(() => copy.HandTo("b"), "'pictures'", "after it was returned");

        // The one who rents it next is not the one who gave it back, even if it is the same buffer.
        Rent("x");
        Rent("y");
        AssertRefused(() => _ = copy.Array, "'pictures'", "has it now");
    }

    [Fact, Trait("Clause", "2.5")]
    public void Use_EmptyLease_Throws()
    {
        AssertRefused(() => _ = default(BufferLease).Array, "empty");
        AssertRefused(() => default(BufferLease).HandTo("a"), "empty");
    }

    [Fact, Trait("Clause", "2.5")]
    public void Constructor_BadArguments_SaysWhich()
    {
        Assert.Contains(
            "A pool needs a name", Assert.Throws<ArgumentException>(() => new BufferPool(" ", 1, 1)).Message,
            StringComparison.Ordinal);
        Assert.Contains(
            "'p'", Assert.Throws<ArgumentOutOfRangeException>(() => new BufferPool("p", 0, 1)).Message,
            StringComparison.Ordinal);
        Assert.Contains(
            "'p'", Assert.Throws<ArgumentOutOfRangeException>(() => new BufferPool("p", 1, 0)).Message,
            StringComparison.Ordinal);
        Assert.Contains(
            "'pictures'", Assert.Throws<ArgumentException>(() => _pool.TryRent("", out _)).Message,
            StringComparison.Ordinal);
        Assert.Contains(
            "new owner", Assert.Throws<ArgumentException>(() => Rent("a").HandTo("")).Message,
            StringComparison.Ordinal);
        Assert.Equal((1, 1), (new BufferPool("p", 1, 1).Count, new BufferPool("p", 1, 1).BufferBytes));
    }

    [Fact, Trait("Clause", "2.5")]
    public void RentHandOnAndGiveBack_SteadyState_AllocatesNothing()
    {
        RentAndGiveBack();
        Assert.Equal(0, Allocated.By(() =>
        {
            for (int i = 0; i < 1000; i++)
                RentAndGiveBack();
        }));

        void RentAndGiveBack()
        {
            _pool.TryRent("camera", out BufferLease lease);
            lease.Span[0]++;
            BufferLease owned = lease.HandTo("detector");
            owned.Span[1]++;
            owned.Dispose();
        }
    }

    [Fact, Trait("Clause", "2.5")]
    public void Pool_ManyThreads_NeverGivesABufferToTwo()
    {
        const int Threads = 4;
        const int Rounds = 20_000;
        var pool = new BufferPool("shared", 3, 4);
        long clashes = 0;
        long got = 0;
        using var start = new ManualResetEventSlim();
        Thread[] threads = Enumerable.Range(1, Threads).Select(n => new Thread(() => Contender((byte)n))).ToArray();
        foreach (Thread thread in threads)
            thread.Start();
        start.Set();
        foreach (Thread thread in threads)
            Assert.True(thread.Join(TestTimeout.Limit));

        Assert.Equal(0, clashes);
        Assert.True(got > 0);
        Assert.Equal(3, pool.Free);
        Assert.Empty(pool.Holders());

        void Contender(byte number)
        {
            string name = "contender " + number;
            start.Wait();
            for (int i = 0; i < Rounds; i++)
            {
                if (!pool.TryRent(name, out BufferLease lease))
                {
                    Thread.Yield();
                    continue;
                }

                Interlocked.Increment(ref got);
                BufferLease owned = lease.HandTo(name);
                owned.Span.Fill(number);
                if ((i & 15) == 0)
                    Thread.Yield();
                foreach (byte b in owned.Span)
                {
                    if (b != number)
                        Interlocked.Increment(ref clashes);
                }

                // A stale copy that is disposed again and again, perhaps while another owner has it, does no harm.
                lease.Dispose();
                owned.Dispose();
                owned.Dispose();
            }
        }
    }

    [Fact, Trait("Clause", "2.5")]
    public void HandTo_TwoThreadsWithOneLease_OneWins()
    {
        for (int round = 0; round < 500; round++)
        {
            BufferLease lease = Rent("camera");
            int wins = 0;
            using var barrier = new Barrier(2);
            Thread[] threads = new[] { "a", "b" }.Select(name => new Thread(() =>
            {
                barrier.SignalAndWait();
                try
                {
                    lease.HandTo(name).Dispose();
                    Interlocked.Increment(ref wins);
                }
                catch (InvalidOperationException)
                {
                    // The other one was first.
                }
            })).ToArray();
            foreach (Thread thread in threads)
                thread.Start();
            foreach (Thread thread in threads)
                thread.Join();
            Assert.Equal(1, wins);
            Assert.Equal(2, _pool.Free);
        }
    }

    private BufferLease Rent(string owner)
    {
        Assert.True(_pool.TryRent(owner, out BufferLease lease));
        return lease;
    }

    private static void AssertRefused(Action use, params string[] parts)
    {
        string text = Assert.Throws<InvalidOperationException>(use).Message;
        Assert.All(parts, part => Assert.Contains(part, text, StringComparison.Ordinal));
    }
}
