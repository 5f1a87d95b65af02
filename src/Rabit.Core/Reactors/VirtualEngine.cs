using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Threading;
using Rabit.Core.Managers;

namespace Rabit.Core.Reactors;

/// <summary>
/// Virtual time: all activities take turns on the thread that runs the engine. A turn goes to one, drawn by the seed, of
/// those that are due or woken at this instant; when there is none the clock moves to the next due time.
/// </summary>
internal sealed class VirtualEngine : ReactorEngine
{
    private readonly EngineContext _context;
    private readonly VirtualTime _time;
    private readonly Pacer _pacer;
    private readonly List<VirtualSlot> _slots = [];
    private readonly List<VirtualSlot> _candidates = [];

    // Guards the woken marks, the real turn times, and the list of slots for those who read it on other threads; pulsed by a
    // wake or a stop from another thread while the pacer waits.
    private readonly object _gate = new();
    private SplitMix64 _random;
    private int _runsAtInstant;
    private bool _waiting;         // under _gate
    private bool _stopRequested;   // under _gate

    public VirtualEngine(VirtualTime time, EngineContext context)
    {
        _time = time;
        _context = context;
        _random = new SplitMix64(unchecked((ulong)time.Seed));
        _pacer = new Pacer(time);
    }

    public override void Begin(Activity activity)
    {
        var slot = new VirtualSlot(activity, this);
        slot.Durations = _time.DurationsOf(activity.Name);
        activity.WakeUp.Connect(slot, _context.Clock);
        lock (_gate)
            _slots.Add(slot);
        activity.Begin();
        Sleep(slot, NextTurn.AtStart());
    }

    public override void RunUntil(TimeSpan end)
    {
        while (!IsStopRequested())
        {
            TimeSpan now = _context.Clock.Now;
            TimeSpan next = FindCandidates(now);
            if (_candidates.Count > 0)
            {
                if (!TryCountRun())
                    return;
                GiveTurn(_candidates[_random.Next(_candidates.Count)], now);
            }
            else if (next == TimeSpan.MaxValue && end == TimeSpan.MaxValue)
            {
                WaitForOutside(TimeSpan.MaxValue);
            }
            else if (next <= end)
            {
                MoveTowards(next, now);
            }
            else
            {
                MoveTowards(end, now);
                if (_context.Clock.Now >= end)
                    return;
            }
        }
    }

    public override void AskToEnd(Activity activity)
    {
    }

    public override bool TryEnd(Activity activity, TimeSpan atMost, TimeSpan deadline)
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

    public override DurationStatistics RealTurnTime(Activity activity)
    {
        lock (_gate)
            return _slots.Find(s => s.Activity == activity)?.RealTurnTime ?? default;
    }

    public override void Dispose()
    {
    }

    internal void MarkWoken(VirtualSlot slot, TimeSpan? at)
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

    /// <summary>Collects who can take a turn now, in the order in which they began, and says when the next one can.</summary>
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
                TimeSpan at = slot.NextTurnAt(now);
                if (at <= now)
                    _candidates.Add(slot);
                else if (at < next)
                    next = at;
            }
        }

        return next;
    }

    private void GiveTurn(VirtualSlot slot, TimeSpan now)
    {
        bool timer = slot.Due <= now;
        TimeSpan? wokenAt;
        WakeUps wakes = slot.Activity.WakeUp.Take();
        lock (_gate)
        {
            // Nobody sleeps on while there is a turn for him, so the wake is now, even if it came from outside while the clock
            // was held back. One that came while a modelled unit of work kept him busy ended no sleep.
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
            // A wake from another thread whose cause an earlier turn took already.
            SleepOn(slot);
            return;
        }

        long mark = _pacer.Mark();
        slot.RunsAtInstant++;
        if (slot.Durations is { } durations)
            slot.Activity.ModelledDuration = durations.TakeNext(now);
        NextTurn next = slot.Activity.TakeTurn(wakes, wokenAt);
        TimeSpan took = _pacer.Since(mark);
        lock (_gate)
            slot.RealTurnTime = slot.RealTurnTime.With(took);

        Sleep(slot, next);
    }

    private static void End(VirtualSlot slot)
    {
        slot.Activity.WakeUp.Take();
        slot.Activity.End();
        slot.HasEnded = true;
    }

    private void Sleep(VirtualSlot slot, NextTurn next)
    {
        if (next.IsNever)
            next = NextTurn.OnlyAt(TimeSpan.MaxValue);
        slot.Due = next.Due;
        slot.NotBefore = Max(next.NotBefore, next.Wanted == WakeUpEvent.Stop ? next.Due : default);
        slot.Wanted = next.Wanted;
        SleepOn(slot);
    }

    private void SleepOn(VirtualSlot slot)
    {
        slot.WokenAt = null;
        if (!slot.Activity.WakeUp.TryFallAsleep(slot.Wanted))
            MarkWoken(slot, at: null);
    }

    /// <summary>Moves the clock to a time, held back by the pacer; comes back early when somebody outside wakes or stops.</summary>
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

    private void WaitForOutside(TimeSpan atMost)
    {
        lock (_gate)
        {
            if (_stopRequested || _slots.Exists(s => s.IsWoken && !s.HasEnded && s.NotBefore <= _context.Clock.Now))
                return;
            _waiting = true;
            Monitor.Wait(_gate, (int)Math.Min(Math.Ceiling(atMost.TotalMilliseconds), 3_600_000));
            _waiting = false;
        }
    }

    private bool TryCountRun()
    {
        if (++_runsAtInstant <= _time.MaximumRunsPerInstant)
            return true;

        FailStandingStill();
        return false;
    }

    // Apart from the count, which is hot: what this captures is made only when it is called.
    private void FailStandingStill()
    {
        // Who ran once is a bystander, unless all did.
        int fewest = _slots.Exists(s => s.RunsAtInstant > 1) ? 2 : 1;
        string names = string.Join(", ", _slots
            .Where(s => s.RunsAtInstant >= fewest)
            .OrderByDescending(s => s.RunsAtInstant)
            .Select(s => string.Format(CultureInfo.InvariantCulture, "{0} ({1})", s.Activity.Name, s.RunsAtInstant)));
        _context.Fail(new InvalidOperationException(string.Format(
            CultureInfo.InvariantCulture,
            "Virtual time stands still at {0}: more than {1} runs at one instant, by {2}. Do they wake each other for ever?",
            _context.Clock.Now,
            _time.MaximumRunsPerInstant,
            names)));
    }

    private static TimeSpan Max(TimeSpan a, TimeSpan b) => a > b ? a : b;
}
