using System;
using System.Diagnostics;
using System.Linq;
using System.Threading;
using Rabit.Core.Messages;
using Rabit.Core.WakeUp;
using Rabit.Core.Wiring;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Messages;

/// <summary>
/// Contract 2.4 with threads that never pause: no value is torn, none older than one already seen, every post is either
/// news or counted as missed, and neither side keeps the other from getting on. Posters go on until each fetcher has
/// had its news, and fetchers until the posters have had their posts, so starving either is standing still.
/// </summary>
[Trait("Category", "Stress")]
public sealed class MessageStressTests
{
    private const int Fetchers = 2;
    private const int MinPosts = 20_000;

    // A fetcher that sleeps in the lock is woken when the machine gets around to it: on one with twenty times too much
    // to do that takes a tenth of a second each time. So few are asked for; on an idle machine there are millions a
    // second.
    private const int MinNews = 200;

    private static readonly TimeSpan MinTime = TimeSpan.FromMilliseconds(150);

    // Only a test that fails takes this long.
    private static TimeSpan MaxWait => TestTimeout.Limit + TestTimeout.Limit;

    public static TheoryData<int, int> Ways() => new() { { 1, 4 }, { 1, 1 }, { 1, 0 }, { 2, 4 }, { 2, 0 } };

    [Theory, Trait("Clause", "2.4")]
    [MemberData(nameof(Ways))]
    public void StructWithReferences_FlatOut_IsWholeInOrderAndCounted(int posters, int tries)
        => Run(posters, new SharedValue<TestBlock>(
            MessagePlaces.New("block"), default, posters == 1, version: -MinPosts / 2, tries),
            (copy, n) => copy.Value = new TestBlock(n), b => b.IsWhole ? b.Number : -1);

    [Theory, Trait("Clause", "2.4")]
    [MemberData(nameof(Ways))]
    public void LargeStruct_FlatOut_IsWholeInOrderAndCounted(int posters, int tries)
        => Run(posters, new SharedValue<Large>(MessagePlaces.New("large"), default, posters == 1, tries: tries),
            (copy, n) => copy.Value = new Large(n), l => l.NumberIfWhole);

    [Theory, Trait("Clause", "2.4")]
    [MemberData(nameof(Ways))]
    public void ImmutableClass_FlatOut_IsWholeInOrderAndCounted(int posters, int tries)
        => Run(
            posters, new SharedValue<TestNote>(MessagePlaces.New("note"), new TestNote(0), posters == 1, tries: tries),
            (copy, n) => copy.Value = new TestNote(n), n => n.IsWhole ? n.Number : -1);

    [Theory, Trait("Clause", "2.4"), Trait("Clause", "2.5")]
    [InlineData(1)]
    [InlineData(2)]
    public void SelfCopyingClass_FlatOut_IsWholeInOrderAndCounted(int posters)
        => Run(posters, new SharedObject<TestScan>(MessagePlaces.New("scan"), new TestScan()),
            (copy, n) => copy.Value.Fill(n), s => s.IsWhole ? s.Number : -1);

    private static void Run<T>(
        int posters, SharedMessage<T> shared, Action<LocalCopy<T>, long> fill, Func<T, long> numberOf)
    {
        int first = shared.Version;
        var done = new Progress(posters, Fetchers);
        Thread[] threads =
        [
            .. Enumerable.Range(0, posters).Select(p => done.Thread(() => Post(shared, done, p, fill))),
            .. Enumerable.Range(0, Fetchers).Select(f => done.Thread(() => Fetch(shared, done, f, first, numberOf))),
        ];
        foreach (Thread thread in threads)
            thread.Start();
        foreach (Thread thread in threads)
            thread.Join();

        done.AssertFine();
    }

    // The numbers of one poster go up; those of two differ by being odd and even.
    private static void Post<T>(SharedMessage<T> shared, Progress done, int poster, Action<LocalCopy<T>, long> fill)
    {
        var owner = new EndpointOwner("poster " + poster, isManager: true, new WakeUpEvent());
        LocalCopy<T> copy = shared.CreateCopy();
        copy.SeenVersion = shared.Version;
        for (long n = 1; !done.AllHaveEnough; n++)
        {
            fill(copy, (n * done.Posters) + poster);
            shared.Post(copy, owner, TimeSpan.FromTicks(n));
            done.Posted(poster);
        }
    }

    private static void Fetch<T>(SharedMessage<T> shared, Progress done, int fetcher, int first, Func<T, long> numberOf)
    {
        LocalCopy<T> copy = shared.CreateCopy();
        copy.SeenVersion = first;
        long[] lastOf = new long[done.Posters];
        long last = 0;
        long seen = 0;
        while (!done.AllHaveEnough)
        {
            int news = shared.Version == copy.SeenVersion ? 0 : shared.Fetch(copy);
            long number = numberOf(copy.Value);
            if (number < 0)
                done.Fail("a value was torn");
            if (news == 0)
            {
                if (number != last)
                    done.Fail("the value changed without news");
                continue;
            }

            last = number;
            seen += news;
            int poster = (int)(number % done.Posters);
            if (number <= lastOf[poster])
                done.Fail($"{number} came after {lastOf[poster]}");
            if (copy.Time.Ticks != number / done.Posters)
                done.Fail($"{number} came with the time of {copy.Time.Ticks}");
            if (done.Posters == 1 && number != seen)
                done.Fail($"{number} posts, {seen} of them counted");
            lastOf[poster] = number;
            done.Fetched(fetcher);
        }
    }

    /// <summary>How far all threads are, and the first thing that went wrong.</summary>
    private sealed class Progress(int posters, int fetchers)
    {
        private readonly Stopwatch _elapsed = Stopwatch.StartNew();
        private readonly int[] _posts = new int[posters];   // each written by its thread, read by all
        private readonly int[] _news = new int[fetchers];   // same
        private string? _failure;                           // written once by the first thread, by compare-and-swap

        public int Posters => posters;

        public bool AllHaveEnough
        {
            get
            {
                if (_elapsed.Elapsed > MaxWait)
                    Fail($"standing still: posts {string.Join(" ", _posts)}, news {string.Join(" ", _news)}");
                return Volatile.Read(ref _failure) is not null
                    || (_elapsed.Elapsed > MinTime && HaveAll(_posts, MinPosts) && HaveAll(_news, MinNews));
            }
        }

        public void Posted(int poster) => Volatile.Write(ref _posts[poster], _posts[poster] + 1);

        public void Fetched(int fetcher) => Volatile.Write(ref _news[fetcher], _news[fetcher] + 1);

        public void Fail(string what) => Interlocked.CompareExchange(ref _failure, what, null);

        public Thread Thread(Action work) => new(() =>
        {
            try
            {
                work();
            }
            catch (Exception e)
            {
                // For the thread of the test.
                Fail(e.ToString());
            }
        });

        public void AssertFine()
        {
            Assert.Null(_failure);
            Assert.All(_posts, n => Assert.True(n >= MinPosts));
            Assert.All(_news, n => Assert.True(n >= MinNews));
        }

        private static bool HaveAll(int[] counts, int least)
        {
            for (int i = 0; i < counts.Length; i++)
            {
                if (Volatile.Read(ref counts[i]) < least)
                    return false;
            }

            return true;
        }
    }

    /// <summary>Two thousand bytes: a copy takes so long that posters lap fetchers all the time.</summary>
    private unsafe struct Large
    {
        private const int Length = 250;
        private fixed long _numbers[Length];

        public Large(long number)
        {
            for (int i = 0; i < Length; i++)
                _numbers[i] = number;
        }

        public long NumberIfWhole
        {
            get
            {
                for (int i = 1; i < Length; i++)
                {
                    if (_numbers[i] != _numbers[0])
                        return -1;
                }

                return _numbers[0];
            }
        }
    }
}
