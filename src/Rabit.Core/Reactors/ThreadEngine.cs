using System;
using System.Collections.Generic;
using System.Threading;
using Rabit.Core.Managers;
using Rabit.Core.RealTimeKit;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Reactors;

/// <summary>Real time: one thread per activity.</summary>
internal sealed class ThreadEngine(EngineContext context, WaitEngine waitEngine) : ReactorEngine
{
    private static readonly TimeSpan FinalGrace = TimeSpan.FromMilliseconds(20);

    // Where a run takes longer than that to stop, the exits hold up next to nothing.
    private static readonly TimeSpan MaxWaitForExit = TimeSpan.FromSeconds(1);

    // Some 50 µs on .NET, less on Mono: about what it takes to sleep and to be woken.
    private const int LooksBeforeSleep = 300;
    private const int PauseBetweenLooks = 4;

    private readonly Dictionary<Activity, ActivityThread> _threads = [];
    private readonly RealTimeSetup _realTime = RealTimeSetup.ForThreads(context.Log);
    private readonly SharedCpus _cpus = SharedCpus.ForThreads();
    private readonly ThreadExits _exits = new(MaxWaitForExit);

    // Guards the two fields below; pulsed at everything that a waiting reactor waits for.
    private readonly object _changed = new();
    private bool _stopRequested;
    private TimeSpan _runLimit = TimeSpan.MaxValue;

    public override bool HasThreads => true;

    public override void Begin(Activity activity)
    {
        var thread = new ActivityThread(
            activity, context, WaitEngines.Create(waitEngine, context.Clock), _realTime, _cpus, _changed, _exits);
        _threads.Add(activity, thread);
        thread.Start();
        if (!BecomesTrueSoon(() => thread.HasBegun || thread.HasEnded))
            WaitFor(() => thread.HasBegun || thread.HasEnded || _stopRequested, TimeSpan.MaxValue);
    }

    public override void RunUntil(TimeSpan end)
        => WaitFor(() => _stopRequested, () => Times.Earlier(end, _runLimit));

    public override void AskToEnd(Activity activity)
    {
        if (_threads.TryGetValue(activity, out ActivityThread? thread) && !thread.HasEnded)
            activity.WakeUp.RequestStop();
    }

    public override bool TryEnd(Activity activity, TimeSpan timeout, TimeSpan deadline)
    {
        // One that has ended already has closed its device: there is nothing to unblock.
        if (!_threads.TryGetValue(activity, out ActivityThread? thread) || thread.HasEnded)
            return true;

        activity.WakeUp.RequestStop();
        if (activity.DrainsAtEnd && TryWaitForEnd(thread, timeout, deadline))
            return true;
        activity.Unblock();
        return TryWaitForEnd(thread, timeout, deadline);
    }

    public override void RequestStop()
    {
        lock (_changed)
        {
            _stopRequested = true;
            Monitor.PulseAll(_changed);
        }
    }

    public override void LimitRun(TimeSpan until)
    {
        lock (_changed)
        {
            _runLimit = until;
            Monitor.PulseAll(_changed);
        }
    }

    public override DurationStatistics RealStepTime(Activity activity) => default;

    public override void Dispose()
    {
        foreach (ActivityThread thread in _threads.Values)
            thread.Dispose();
        _exits.Open();
    }

    private bool TryWaitForEnd(ActivityThread thread, TimeSpan timeout, TimeSpan deadline)
    {
        if (BecomesTrueSoon(() => thread.HasEnded))
            return true;

        // Past the deadline it gets a last look: it was asked a while ago, and may be about to end.
        TimeSpan now = context.Clock.Now;
        TimeSpan until = Times.Earlier(Times.Later(now, timeout), deadline);
        WaitFor(() => thread.HasEnded, until > now + FinalGrace ? until : now + FinalGrace);
        return thread.HasEnded;
    }

    // Most threads begin and end within microseconds, one after the other: to sleep for each would take most of a start
    // and of a stop. Where there is one CPU the thread needs it.
    private static bool BecomesTrueSoon(Func<bool> mark)
    {
        for (int looks = Environment.ProcessorCount > 1 ? LooksBeforeSleep : 0; looks > 0; looks--)
        {
            if (mark())
                return true;
            Thread.SpinWait(PauseBetweenLooks);
        }

        return false;
    }

    private void WaitFor(Func<bool> condition, TimeSpan until) => WaitFor(condition, () => until);

    // Both are asked under the lock, at every change. An interrupt is an early return of a wait, no stop: a run that
    // its reactor left would never end.
    private void WaitFor(Func<bool> condition, Func<TimeSpan> limit)
        => LastResort.DespiteInterrupts(() =>
        {
            lock (_changed)
            {
                while (!condition())
                {
                    TimeSpan until = limit();
                    TimeSpan left = until == TimeSpan.MaxValue ? TimeSpan.FromHours(1) : until - context.Clock.Now;
                    if (left <= TimeSpan.Zero)
                        return;
                    Monitor.Wait(_changed, (int)Math.Min(Math.Ceiling(left.TotalMilliseconds), 3_600_000));
                }
            }
        });
}
