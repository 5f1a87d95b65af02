using System;
using System.Collections.Generic;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// A subscription that joins a message while it is ended, by several threads too, and posts go on (contract 2.6): one
/// that has ended is not left among the message's subscriptions, one that has not is, and a poster that knows that an
/// end has returned calls nothing.
/// </summary>
internal sealed class SubscriptionModel : ExploredModel
{
    /// <summary>The note that says whether it is among the subscriptions.</summary>
    public const int IsListed = 0;

    private readonly SubscriptionUnderTest _subscription;
    private readonly int _enders;
    private readonly int _posts;
    private readonly List<ExploredThread> _threads = [];
    private int _endHasReturned;   // by this a poster knows

    public SubscriptionModel(SubscriptionUnderTest subscription, int enders, int posters, int posts)
    {
        _subscription = subscription;
        _enders = enders;
        _posts = posts;
        _threads.Add(new Joiner(this));
        for (int i = 0; i < enders; i++)
            _threads.Add(new Ender(this, i));
        for (int i = 0; i < posters; i++)
            _threads.Add(new Poster(this, i));
    }

    public override IReadOnlyList<ExploredThread> Threads => _threads;

    public override int Notes => 1;

    public override void CheckQuiet(ExploredState state, Func<int, bool> mayRest)
    {
        for (int thread = 0; thread < _threads.Count; thread++)
            state.Require(mayRest(thread), $"{_threads[thread].Name} hangs");
        state.Require(
            state.Note(IsListed) == (_enders == 0 ? 1 : 0),
            _enders == 0 ? "it is not among the subscriptions" : "it has ended and is still among the subscriptions");
    }

    private sealed class Joiner(SubscriptionModel model) : ExploredThread("joiner")
    {
        public override object Begin => 0;

        public override object? Run(object from)
        {
            model._subscription.Join();
            return null;
        }
    }

    private sealed class Ender(SubscriptionModel model, int number) : ExploredThread($"ender {number}")
    {
        public override object Begin => 0;

        public override object? Run(object from)
        {
            model._subscription.End();
            default(ExploredSyncPoints).VolatileWrite(ref model._endHasReturned, 1);
            return null;
        }
    }

    private sealed class Poster(SubscriptionModel model, int number) : ExploredThread($"poster {number}")
    {
        public override object Begin => 1;

        public override object? Run(object from)
        {
            int post = (int)from;
            bool knows = default(ExploredSyncPoints).VolatileRead(ref model._endHasReturned) != 0;
            bool calls = model._subscription.Post();
            ExploredSyncPoints.Note(
                (knows, calls), s => s.Require(!(knows && calls), "a post after the end has called the handler"));
            return post < model._posts ? post + 1 : null;
        }
    }
}
