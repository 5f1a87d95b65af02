using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Threading;
using Rabit.Core.Diagnostics;
using Rabit.Core.Managers;
using Rabit.Core.RealTimeKit;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Reactors;

/// <summary>
/// Virtual time (discrete-event simulation): the steps of all activities are dispatched on the thread that runs the
/// engine. Next comes one, chosen by the seed, of those that are due or woken at this instant; when there is none the
/// clock moves to the next due time.
/// </summary>
internal sealed partial class VirtualEngine : ReactorEngine
{
    private readonly EngineContext _context;
    private readonly VirtualTime _time;
    private readonly Pacer _pacer;
    private readonly RealTimeSetup _realTime;
    private readonly EventLog? _events;
    private readonly List<VirtualSlot> _slots = [];
    private readonly List<VirtualSlot> _candidates = [];

    // Guards the woken marks, the real step times, and the list of slots for those who read it on other threads; pulsed
    // by a wake or a stop from another thread while the pacer waits.
    private readonly object _gate = new();
    private SplitMix64 _random;
    private int _runsAtInstant;
    private bool _waiting;         // under _gate
    private bool _stopRequested;   // under _gate
    private TimeSpan _runLimit = TimeSpan.MaxValue;   // under _gate
    private bool _runLimitIsNew;   // under _gate: set, and not yet seen by the run

    public VirtualEngine(VirtualTime time, EngineContext context)
    {
        _time = time;
        _context = context;
        _events = context.Log.Events;
        _random = new SplitMix64(unchecked((ulong)time.Seed));
        _pacer = new Pacer(time);
        _realTime = new RealTimeSetup(context.Log, control: null, "virtual time has no threads");
    }

    public override void Begin(Activity activity)
    {
        var slot = new VirtualSlot(activity, this)
        {
            Durations = activity is ManagerActivity ? _time.DurationsFor(activity.Name) : null,
        };
        if (_slots.Count == 0)
            _events?.Write("time", FormattableString.Invariant($"is virtual, seed {_time.Seed}"));
        activity.WakeUp.Connect(slot, _context.Clock);
        lock (_gate)
            _slots.Add(slot);
        _events?.Enter(activity, "begins");
        Guard(slot, () =>
        {
            _realTime.Apply(activity);
            activity.Begin();
        });
        _events?.Leave();
        Sleep(slot, NextStep.AtStart());
    }

    public override void RunUntil(TimeSpan end)
    {
        _time.CloseManagers();
        _events?.WriteOutsideChanges();
        TimeSpan limit = LimitOf(end);
        while (!IsStopRequested())
        {
            TimeSpan now = _context.Clock.Now;
            TimeSpan until = EarliestEnd(end, now);
            TimeSpan next = FindCandidates(now);
            if (_candidates.Count > 0)
            {
                if (!TryCountRun())
                    return;
                Dispatch(_candidates[_random.Next(_candidates.Count)], now);
            }
            else if (next == TimeSpan.MaxValue && until == TimeSpan.MaxValue)
            {
                WaitForOutside(TimeSpan.MaxValue);
            }
            else if (next <= until && next > limit)
            {
                FailWithoutStop();
            }
            else if (next <= until)
            {
                MoveTowards(next, now);
            }
            else
            {
                MoveTowards(until, now);
                if (_context.Clock.Now >= until)
                    return;
            }
        }
    }

    public override void AskToEnd(Activity activity)
    {
    }

    public override bool TryEnd(Activity activity, TimeSpan timeout, TimeSpan deadline)
    {
        VirtualSlot? slot = _slots.Find(s => s.Activity == activity);
        if (slot is not null && !slot.HasEnded)
            End(slot);
        return true;
    }

    public override void RequestStop()
    {
        lock (_gate)
        {
            _stopRequested = true;
            Monitor.PulseAll(_gate);
        }
    }

    public override void LimitRun(TimeSpan until)
    {
        lock (_gate)
        {
            _runLimit = until;
            _runLimitIsNew = true;
            Monitor.PulseAll(_gate);
        }
    }

    public override DurationStatistics RealStepTime(Activity activity)
    {
        lock (_gate)
            return _slots.Find(s => s.Activity == activity)?.RealStepTime ?? default;
    }

    public override void Dispose()
    {
    }

    /// <summary>A wake that found the activity asleep. Any thread.</summary>
    internal void OnWake(VirtualSlot slot)
    {
        _events?.Wakes(slot.Activity);
        MarkWoken(slot, slot.Activity.WakeUp.WokenAt);
    }

    private void MarkWoken(VirtualSlot slot, TimeSpan? at)
    {
        lock (_gate)
        {
            slot.IsWoken = true;
            slot.WokenAt = at;
            if (_waiting)
                Monitor.PulseAll(_gate);
        }
    }

    private bool IsStopRequested()
    {
        lock (_gate)
            return _stopRequested;
    }

    // A limit that another thread sets may have passed already; time does not go back.
    private TimeSpan EarliestEnd(TimeSpan end, TimeSpan now)
    {
        lock (_gate)
        {
            _runLimitIsNew = false;
            return _runLimit < end ? Max(_runLimit, now) : end;
        }
    }

    /// <summary>Collects the activities that can run a step now, in the order in which they began.</summary>
    /// <returns>When the next one can.</returns>
    private TimeSpan FindCandidates(TimeSpan now)
    {
        _candidates.Clear();
        TimeSpan next = TimeSpan.MaxValue;
        lock (_gate)
        {
            foreach (VirtualSlot slot in _slots)
            {
                if (slot.HasEnded)
                    continue;
                TimeSpan at = slot.NextStepAt(now);
                if (at <= now)
                    _candidates.Add(slot);
                else if (at < next)
                    next = at;
            }
        }

        return next;
    }

    private void Dispatch(VirtualSlot slot, TimeSpan now)
    {
        bool timer = slot.Due <= now;
        TimeSpan? wokenAt;
        ConsumedWakeUps wakes = slot.Activity.WakeUp.Consume();
        lock (_gate)
        {
            // No activity sleeps on while it has a step to run, so the wake is now, even if it came from outside while
            // the clock was held back. One that came during a modelled unit of work ended no sleep.
            wokenAt = timer ? slot.Due : slot.WokenAt >= slot.NotBefore ? now : null;
            slot.IsWoken = false;
        }

        if (wakes.Stop)
        {
            // A device whose manager was stopped alone.
            End(slot);
            return;
        }

        if (timer)
        {
            wakes = wakes.With(WakeUpCauses.Timer);
        }
        else if (wakes.Causes == WakeUpCauses.None)
        {
            // A wake from another thread whose cause an earlier step consumed already.
            SleepOn(slot);
            return;
        }

        if (slot.Durations is { } durations)
            slot.Activity.ModelledDuration = durations.TakeNext(now);
        _events?.EnterStep(slot.Activity, wakes);
        long mark = _pacer.Mark();
        slot.RunsAtInstant++;
        NextStep next = RunStep(slot, wakes, wokenAt);
        TimeSpan took = _pacer.Since(mark);
        lock (_gate)
            slot.RealStepTime = slot.RealStepTime.With(took);
        _events?.Leave();
        Sleep(slot, next);
    }

    private void End(VirtualSlot slot)
    {
        slot.Activity.WakeUp.Consume();
        _events?.Enter(slot.Activity, "ends");
        Guard(slot, slot.Activity.End);
        _events?.Leave();
        slot.HasEnded = true;
    }

    private void Sleep(VirtualSlot slot, NextStep next)
    {
        if (next.IsNever)
            next = NextStep.OnlyAt(TimeSpan.MaxValue);
        slot.Due = next.Due;
        slot.NotBefore = Max(next.NotBefore, next.Wanted == WakeUpEvent.Stop ? next.Due : default);
        slot.Wanted = next.Wanted;
        SleepOn(slot);
    }

    private void SleepOn(VirtualSlot slot)
    {
        slot.WokenAt = null;
        if (!slot.Activity.WakeUp.TryPrepareToWait(slot.Wanted))
            MarkWoken(slot, at: null);
    }

    /// <summary>
    /// Moves the clock to a time, held back by the pacer; returns early at a wake or a stop from outside.
    /// </summary>
    private void MoveTowards(TimeSpan next, TimeSpan now)
    {
        TimeSpan reached = next;
        if (!_pacer.IsUnlimited)
        {
            TimeSpan paced = _pacer.Now(now);
            if (paced < next)
            {
                WaitForOutside(_pacer.Until(next, paced));
                paced = _pacer.Now(now);
                reached = Max(now, paced < next ? paced : next);
            }
        }

        if (reached == now)
            return;
        _time.VirtualClock.MoveTo(reached);
        _runsAtInstant = 0;
        foreach (VirtualSlot slot in _slots)
            slot.RunsAtInstant = 0;
    }

    private void WaitForOutside(TimeSpan timeout)
    {
        lock (_gate)
        {
            if (_stopRequested || _runLimitIsNew
                || _slots.Exists(s => s.IsWoken && !s.HasEnded && s.NotBefore <= _context.Clock.Now))
                return;
            _waiting = true;
            try
            {
                Monitor.Wait(_gate, (int)Math.Min(Math.Ceiling(timeout.TotalMilliseconds), 3_600_000));
            }
            catch (ThreadInterruptedException)
            {
                // An early return; the caller looks again.
            }

            _waiting = false;
        }
    }

    private static TimeSpan Max(TimeSpan a, TimeSpan b) => a > b ? a : b;
}
