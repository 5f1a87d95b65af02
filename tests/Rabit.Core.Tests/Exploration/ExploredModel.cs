using System;
using System.Collections.Generic;
using Rabit.Core.Time;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// What is explored: threads, what their notes count, and what must hold when nothing more happens by itself.
/// </summary>
internal abstract class ExploredModel
{
    /// <summary>The threads; they share objects that were made for this model and nothing else.</summary>
    public abstract IReadOnlyList<ExploredThread> Threads { get; }

    /// <summary>How many numbers the notes of the model need.</summary>
    public virtual int Notes => 0;

    /// <summary>How often time may pass, and how far it goes each time.</summary>
    public virtual (int Times, TimeSpan Step) Ticks => (0, default);

    /// <summary>
    /// How often a wait may return without a reason, as the kernel and a signal to the process make it do.
    /// </summary>
    public virtual int EarlyReturns => 0;

    /// <summary>
    /// Whether the code fences all threads: then what a thread has written is known even after it has ended, and a
    /// write may not be taken early, since it makes a difference whether such a fence comes before it.
    /// </summary>
    public virtual bool FencesAllThreads => false;

    /// <summary>How many locations and signals the code has, and how many writes of one may be in sight.</summary>
    public virtual (int Locations, int Signals, int Writes) Size => (8, 1, 12);

    /// <summary>
    /// What must hold whenever no thread can go on unless time passes. For each thread whether it has ended, or may
    /// never do what it does next; any other waits.
    /// </summary>
    public abstract void CheckQuiet(ExploredState state, Func<int, bool> mayRest);
}
