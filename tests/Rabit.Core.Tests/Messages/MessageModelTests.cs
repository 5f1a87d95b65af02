using System;
using System.Collections.Generic;
using Rabit.Core.Messages;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;
using Rabit.Core.Wiring;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Core.Tests.Messages;

/// <summary>
/// Contract 2.2 to 2.4 against a model that is too simple to be wrong: a list of all posts. Random sequences of posts,
/// fetches and checks by several owners, every way in which a global copy is kept, from versions near the wrap-around
/// as well.
/// </summary>
public sealed class MessageModelTests(ITestOutputHelper output)
{
    private const int Sequences = 20;
    private const int StepsPerSequence = 300;

    /// <summary>
    /// How the global copy is kept: posters alone or not, fetches with tries before the lock or at once, and the
    /// version that it begins with.
    /// </summary>
    public static TheoryData<bool, int, int> Ways()
    {
        var ways = new TheoryData<bool, int, int>();
        foreach (bool isAlone in new[] { true, false })
        {
            foreach (int tries in new[] { 0, 1, 4 })
            {
                foreach (int firstVersion in new[] { 0, -50, int.MaxValue - 50 })
                    ways.Add(isAlone, tries, firstVersion);
            }
        }

        return ways;
    }

    [Theory, Trait("Clause", "2.2"), Trait("Clause", "2.3"), Trait("Clause", "2.4")]
    [MemberData(nameof(Ways))]
    public void StructMessage_AnySequence_DoesWhatTheModelDoes(bool isAlone, int tries, int firstVersion)
    {
        foreach (ulong seed in Seeds())
        {
            var shared = new SharedValue<TestBlock>(MessagePlaces.New("block"), default, isAlone, firstVersion, tries);
            var comparison = new Comparison<TestBlock>(
                seed, shared, firstVersion, (copy, n) => copy.Value = new TestBlock(n), b => b.IsWhole ? b.Number : -1);
            comparison.Run(posters: isAlone ? 1 : 3);
        }
    }

    [Theory, Trait("Clause", "2.2"), Trait("Clause", "2.3"), Trait("Clause", "2.4")]
    [MemberData(nameof(Ways))]
    public void ImmutableClass_AnySequence_DoesWhatTheModelDoes(bool isAlone, int tries, int firstVersion)
    {
        foreach (ulong seed in Seeds())
        {
            var shared = new SharedValue<TestNote>(
                MessagePlaces.New("note"), new TestNote(0), isAlone, firstVersion, tries);
            var comparison = new Comparison<TestNote>(
                seed, shared, firstVersion, (copy, n) => copy.Value = new TestNote(n), n => n.IsWhole ? n.Number : -1);
            comparison.Run(posters: isAlone ? 1 : 3);
        }
    }

    [Fact, Trait("Clause", "2.2"), Trait("Clause", "2.3"), Trait("Clause", "2.5")]
    public void SelfCopyingClass_AnySequence_DoesWhatTheModelDoes()
    {
        foreach (ulong seed in Seeds())
        {
            var shared = new SharedObject<TestScan>(MessagePlaces.New("scan"), new TestScan());
            var comparison = new Comparison<TestScan>(
                seed, shared, firstVersion: 0, (copy, n) => copy.Value.Fill(n), s => s.IsWhole ? s.Number : -1);
            comparison.Run(posters: 3);
        }
    }

    // The same ones each time, and one that was not tried yet.
    private IEnumerable<ulong> Seeds()
    {
        ulong fresh = unchecked((ulong)Guid.NewGuid().GetHashCode());
        output.WriteLine($"seeds 1 to {Sequences}, and {fresh}");
        for (ulong seed = 1; seed <= Sequences; seed++)
            yield return seed;
        yield return fresh;
    }

    /// <summary>One random sequence, done with the message and with the model.</summary>
    private sealed class Comparison<T>(
        ulong seed, SharedMessage<T> shared, int firstVersion, Action<LocalCopy<T>, long> fill, Func<T, long> numberOf)
    {
        private readonly List<string> _history = [];
        private readonly List<Post> _posts = [];   // the model of the global copy
        private readonly List<Side> _sides = [];
        private SplitMix64 _random = new(seed);

        public void Run(int posters)
        {
            for (int i = 0; i < posters + 2; i++)
            {
                _sides.Add(new Side("owner " + i, shared.CreateCopy()));
                _sides[i].Copy.SeenVersion = firstVersion;
            }

            for (int step = 1; step <= StepsPerSequence; step++)
            {
                int who = _random.Next(_sides.Count);
                if (who < posters && _random.Next(2) == 0)
                    PostBy(_sides[who], step);
                else
                    FetchBy(_sides[who]);
            }
        }

        private void PostBy(Side side, int number)
        {
            _history.Add($"{side.Owner.Name} posts {number}");
            var time = TimeSpan.FromTicks(_random.Next(1000));
            fill(side.Copy, number);
            shared.Post(side.Copy, side.Owner, time);

            // What it had not seen of others is covered now, and will be reported with its next news.
            side.Covered += _posts.Count - side.Seen;
            _posts.Add(new Post(number, time, After(VersionAt(_posts.Count))));
            side.Seen = _posts.Count;
            side.Holds = number;
            CheckCopy(side);
        }

        private void FetchBy(Side side)
        {
            _history.Add($"{side.Owner.Name} fetches");
            bool looksNew = shared.Version != side.Copy.SeenVersion;
            int news = shared.Fetch(side.Copy);

            int unseen = _posts.Count - side.Seen;
            Check(looksNew == (unseen > 0), side, $"looked new: {looksNew}");
            Check(news == (unseen == 0 ? 0 : unseen + side.Covered), side, $"news {news}");
            if (unseen > 0)
                side.Covered = 0;
            side.Seen = _posts.Count;
            side.Holds = _posts.Count == 0 ? 0 : _posts[_posts.Count - 1].Number;
            CheckCopy(side);
        }

        private void CheckCopy(Side side)
        {
            Check(
                numberOf(side.Copy.Value) == side.Holds, side, $"holds {numberOf(side.Copy.Value)}, not {side.Holds}");
            Check(side.Copy.Stamp.Version == VersionAt(side.Seen), side, $"has version {side.Copy.Stamp.Version}");
            if (side.Seen > 0)
                Check(side.Copy.Stamp.Time == _posts[side.Seen - 1].Time, side, $"has time {side.Copy.Stamp.Time}");
        }

        private int VersionAt(int posts) => posts == 0 ? firstVersion : _posts[posts - 1].Version;

        // Plain counts, zero left out.
        private static int After(int version)
            => version == -1 ? 1 : version == int.MaxValue ? int.MinValue : version + 1;

        private void Check(bool isSo, Side side, string what)
            => Assert.True(
                isSo, isSo ? "" : $"seed {seed}: {side.Owner.Name} {what} after: {string.Join("; ", _history)}");

        /// <summary>A post, as the model keeps it.</summary>
        private sealed record Post(long Number, TimeSpan Time, int Version);

        /// <summary>An owner: its real copy, and what the model thinks of it.</summary>
        private sealed class Side(string name, LocalCopy<T> copy)
        {
            public EndpointOwner Owner { get; } = new(name, isManager: true, new WakeUpEvent());

            public LocalCopy<T> Copy { get; } = copy;

            /// <summary>How many posts it has seen or made.</summary>
            public int Seen { get; set; }

            /// <summary>Posts of others that its own covered.</summary>
            public int Covered { get; set; }

            /// <summary>The number in its copy.</summary>
            public long Holds { get; set; }
        }
    }
}
