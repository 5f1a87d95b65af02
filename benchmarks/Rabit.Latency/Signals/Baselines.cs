using System;
using System.Collections.Generic;

namespace Rabit.Latency.Signals;

/// <summary>The ways to wake a thread that Rabit is set beside, the limit first.</summary>
internal static class Baselines
{
    public const string Limit = "futex pair";
    public const string Event = "AutoResetEvent";

    public static IReadOnlyList<(string Name, Func<Signal> Create)> All { get; } =
    [
        (Limit, () => new FutexSignal(hasTimer: false)),
        (Event, () => new EventSignal(milliseconds: -1)),
        ("futex pair, each wait with a timer", () => new FutexSignal(hasTimer: true)),
        ("AutoResetEvent, WaitOne(an hour)", () => new EventSignal(milliseconds: 3_600_000)),
        ("SemaphoreSlim", () => new SemaphoreSignal()),
        ("Channel, bounded", () => new ChannelSignal()),
        ("BlockingCollection", () => new BlockingCollectionSignal()),
    ];
}
