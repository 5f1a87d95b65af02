using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Messages;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// Posters and fetchers of one message: the slots that keep its posts (<see cref="SlotPool{TSlot, TSync}"/>). A value
/// is two plain words, both the number of the post, so that a torn one shows.
/// </summary>
internal sealed class SlotModel : ExploredModel
{
    /// <summary>What is found of a fetch that tries on although it has had its tries.</summary>
    public const string TriesOn = "a fetch goes on copying what posts spoil";

    /// <summary>What is found of a fetch that looks for the latest slot again without a post in between.</summary>
    public const string LooksOn = "a fetch looks for the latest slot again without a post";

    private readonly SlotsUnderTest _slots;
    private readonly SlotScenario _scenario;
    private readonly List<ExploredThread> _threads = [];

    public SlotModel(SlotScenario scenario, SlotsUnderTest slots)
    {
        _scenario = scenario;
        _slots = slots;
        for (int i = 0; i < scenario.Posts.Count; i++)
            _threads.Add(new Poster(this, i));
        for (int i = 0; i < scenario.Fetchers; i++)
            _threads.Add(new Fetcher(this, i));
    }

    public override IReadOnlyList<ExploredThread> Threads => _threads;

    public override bool FencesAllThreads => _scenario.IsAlone;

    // For each version the number of the post that it is of.
    public override int Notes => 1 + _scenario.Posts.Sum();

    // The latest word, the demand for fences, and of each slot its version, its pins and two words; one slot more.
    public override (int Locations, int Signals, int Writes) Size => (2 + (4 * (1 + _scenario.Slots)), 1, 24);

    public override void CheckQuiet(ExploredState state, Func<int, bool> mayRest)
    {
        for (int thread = 0; thread < _threads.Count; thread++)
            state.Require(mayRest(thread), $"{_threads[thread].Name} hangs");
    }

    private sealed class Poster(SlotModel model, int number) : ExploredThread($"poster {number}")
    {
        public override object Begin => new At(0, 0, string.Join(",", model._scenario.SparesOf(number)));

        public override object? Run(object from)
        {
            (int done, int own, string indices) = (At)from;
            int post = model._scenario.Posts.Take(number).Sum() + done + 1;
            var spares = new SpareSlots([.. indices.Split(',').Select(int.Parse)], isOutside: false);
            int version = model._slots.Store(post, spares);
            ExploredSyncPoints.Note((version, post, own), state =>
            {
                state.Require(version > own, "the version of a poster's own posts went back");
                state.Require(state.Note(version) == 0, $"two posts have version {version}");
                state.Note(version) = post;
            });
            return done + 1 < model._scenario.Posts[number] ? new At(done + 1, version, Order(spares)) : null;
        }

        // The one whose turn it is first.
        private static string Order(SpareSlots spares)
        {
            var order = new List<int>();
            for (int i = 0; i < spares.Count; i++, spares.Skip())
                order.Add(spares.Next);
            return string.Join(",", order);
        }

        private sealed record At(int Done, int Own, string Spares);
    }

    private sealed class Fetcher(SlotModel model, int number) : ExploredThread($"fetcher {number}")
    {
        public override object Begin => new At(0, 0);

        public override object? Run(object from)
        {
            (int done, int seen) = (At)from;
            int version = model._slots.Load(out TwoWordsCopier fetched);
            (int first, int second, int copies) = (fetched.First, fetched.Second, fetched.Copies);
            int unused = PostsWithoutALook(version);
            ExploredSyncPoints.Note((version, first, second, copies, seen, unused), state =>
            {
                state.Require(copies <= model._scenario.Tries + 1, TriesOn);
                state.Require(unused >= 0, LooksOn);
                state.Require(version >= seen, "a fetch went back");
                state.Require(first == second, $"torn: {first} and {second}");
                state.Require(
                    first == state.Note(version), $"version {version} is post {state.Note(version)}, not {first}");
            });
            return done + 1 < model._scenario.Fetches ? new At(done + 1, version) : null;
        }

        // After its tries it looks twice for each time that it pins: before, and whether a post has come since. Each
        // post raises the version by one.
        private int PostsWithoutALook(int version)
        {
            IReadOnlyList<long> looks = ExploredSyncPoints.ReadsOf(ref model._slots.Latest);
            int tries = model._scenario.Tries;
            int again = ((looks.Count - tries) / 2) - 1;
            return again > 0 ? version - LatestSlot.VersionOf(looks[tries]) - again : 0;
        }

        private sealed record At(int Done, int Seen);
    }
}
