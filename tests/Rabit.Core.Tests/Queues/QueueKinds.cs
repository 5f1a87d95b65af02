using System;
using Rabit.Core.Diagnostics;
using Rabit.Core.Queues;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Tests.Queues;

/// <summary>The kinds of queue that the wiring chooses from, by name.</summary>
internal static class QueueKinds
{
    public const string Pair = "pair";
    public const string Ring = "ring";
    public const string Rejects = "locked, rejects";
    public const string DropsOldest = "locked, drops oldest";
    public const string DropsNewest = "locked, drops newest";
    public const string Waits = "locked, waits";

    public static QueueFullMode RuleOf(string kind) => kind switch
    {
        DropsOldest => QueueFullMode.DropOldest,
        DropsNewest => QueueFullMode.DropNewest,
        Waits => QueueFullMode.Wait,
        _ => QueueFullMode.Reject,
    };

    /// <param name="kind">One of the names.</param>
    /// <param name="capacity">How many values fit in.</param>
    /// <param name="receiver">Whom a push wakes.</param>
    /// <param name="start">The first position, where the queue has positions.</param>
    public static MessageQueue<T, SyncPoints> Create<T>(
        string kind, int capacity, WakeUpEvent? receiver = null, int start = 0)
    {
        var clock = new RunClock(TimeProvider.System);
        return kind switch
        {
            Pair => new SingleProducerRing<T, SyncPoints>("q", capacity, receiver, start),
            Ring => new MultiProducerRing<T, SyncPoints>("q", capacity, receiver, start),
            _ => new LockedQueue<T>(
                "q", capacity, RuleOf(kind), receiver, maxWait: null, clock, new RabitLog(null, logRuns: false, clock)),
        };
    }
}
