using System;
using System.Collections.Generic;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// One sleeper that lends itself, readers that borrow it, wakers that do not, the reactor that stops, and time.
/// </summary>
/// <remarks>
/// Work is done in turns, of the sleeper and of borrowers. What must hold, beside all that holds of wakes
/// (<see cref="WakeUpHistory"/>): no turn begins while another is under way, each sees what the one before wrote
/// plainly, and no sleep lasts longer than its timer.
/// </remarks>
internal sealed class LoanModel : ExploredModel
{
    private static readonly TimeSpan Delay = TimeSpan.FromMilliseconds(10);

    private readonly LoanScenario _scenario;
    private readonly WakeUpHistory _history;
    private readonly LoanUnderTest _loan;
    private readonly RunClock _clock = new(new ExploredClock());
    private readonly int[] _written;   // by each reader and waker, read by the turns
    private readonly List<ExploredThread> _threads = [];
    private int _turns;   // written by the thread that has the turn

    public LoanModel(LoanScenario scenario, Func<RunClock, LoanUnderTest> create)
    {
        _scenario = scenario;
        _history = new WakeUpHistory(scenario.ForWakeUps);
        _loan = create(_clock);
        _written = new int[scenario.Readers + scenario.Wakers];
        _threads.Add(new Sleeper(this));
        if (scenario.Stops)
            _threads.Add(new Reactor(this));
        for (int number = 0; number < _written.Length; number++)
            _threads.Add(new Source(this, number, borrows: number < scenario.Readers));
    }

    public override IReadOnlyList<ExploredThread> Threads => _threads;

    public override int Notes => _history.Size + 2;

    public override (int Times, TimeSpan Step) Ticks => (_scenario.Ticks, Delay);

    public override int EarlyReturns => _scenario.EarlyReturns;

    // The state, the time of the wake, the word of a futex, the count of turns, a number for each source.
    public override (int Locations, int Signals, int Writes) Size => (4 + _written.Length, 1, 24);

    private int IsAtWork => _history.Size;

    private int TurnsDone => _history.Size + 1;

    public override void CheckQuiet(ExploredState state, Func<int, bool> mayRest)
    {
        for (int thread = 1; thread < _threads.Count; thread++)
            state.Require(mayRest(thread), $"{_threads[thread].Name} hangs");
        state.Require(
            state.TicksLeft == 0 || state.Note(TurnsDone) == 0 || state.Deadline(0) <= (state.Now + Delay).Ticks,
            "a timer was lost: the sleeper sleeps longer");
        _history.CheckQuiet(state);
    }

    private void Stop()
    {
        ExploredSyncPoints.NoteNext("start", WakeUpHistory.CallStart);
        _loan.Wake(WakeUpCauses.Start);
        ExploredSyncPoints.Note("started", WakeUpHistory.ReturnStart);
        ExploredSyncPoints.NoteNext("stop", WakeUpHistory.CallStop, mayNeverCome: true);
        _loan.RequestStop();
        ExploredSyncPoints.Note("stopped", WakeUpHistory.ReturnStop);
    }

    private void Bring(int source, int number, bool borrows)
    {
        bool isBorrowed = borrows && _loan.TryBorrow();
        default(ExploredSyncPoints).Write(ref _written[source], number);
        ExploredSyncPoints.NoteNext("wake", s => WakeUpHistory.Call(s, source, number));
        _loan.Wake(WakeUpHistory.CauseOf(source));
        ExploredSyncPoints.Note("woken", s => WakeUpHistory.Return(s, source, number));
        if (!isBorrowed)
            return;
        ConsumedWakeUps wakes = _loan.ConsumeLent();
        if (!wakes.Stop)
            TakeTurn(NextStep.At(TimeSpan.MaxValue), wakes, null);
        _loan.EndLoan(_scenario.WakesAfterLoans && !wakes.Stop);
    }

    private void TakeTurn(NextStep planned, ConsumedWakeUps wakes, TimeSpan? wokenAt)
    {
        ExploredSyncPoints.Note(
            (planned, wakes, wokenAt), s =>
            {
                s.Require(s.Note(IsAtWork) == 0, "two turns at a time");
                s.Note(IsAtWork) = 1;
                _history.BeginStep(s, planned, wakes, wokenAt);
            });
        for (int i = 0; i < _written.Length; i++)
        {
            int source = i;
            int seen = ExploredSyncPoints.OldestSeen(ref _written[source]);
            ExploredSyncPoints.Note((source, seen), s => WakeUpHistory.See(s, source, seen));
        }

        int turns = default(ExploredSyncPoints).Read(ref _turns);
        default(ExploredSyncPoints).Write(ref _turns, turns + 1);
        ExploredSyncPoints.Note(
            turns, s =>
            {
                s.Require(s.Note(TurnsDone) == turns, "a turn does not see what the one before has written");
                s.Note(TurnsDone)++;
                s.Note(IsAtWork) = 0;
            });
    }

    private NextStep RunStep(NextStep planned, ConsumedWakeUps wakes, TimeSpan? wokenAt)
    {
        // As a manager does it that is woken after a loan and has nothing to do: no turn. There is no timer then.
        if (_scenario.WakesAfterLoans && wakes.Causes == WakeUpCauses.Timer)
            return planned;
        if (_scenario.WakesAfterLoans)
            wakes = new ConsumedWakeUps(wakes.Causes & ~WakeUpCauses.Timer, wakes.Count, wakes.Stop);
        TakeTurn(planned, wakes, wokenAt);
        return NextStep.At(_scenario.Ticks == 0 ? TimeSpan.MaxValue : _clock.Now + Delay, lends: true);
    }

    private sealed class Reactor(LoanModel model) : ExploredThread("reactor")
    {
        public override object Begin => 0;

        public override object? Run(object from)
        {
            model.Stop();
            return null;
        }
    }

    private sealed class Source(LoanModel model, int number, bool borrows)
        : ExploredThread($"{(borrows ? "reader" : "waker")} {number}")
    {
        public override object Begin => 1;

        public override object? Run(object from)
        {
            int value = (int)from;
            model.Bring(number, value, borrows);
            return borrows && value < model._scenario.ValuesEach ? value + 1 : null;
        }
    }

    private sealed class Sleeper(LoanModel model) : ExploredThread("sleeper")
    {
        public override object Begin
            => model._scenario.Stops ? NextStep.AtStart() : NextStep.At(TimeSpan.MaxValue, lends: true);

        public override object? Run(object from)
        {
            var planned = (NextStep)from;
            model._loan.Run(planned, (wakes, wokenAt) => throw Recorder.End(model.RunStep(planned, wakes, wokenAt)));
            ExploredSyncPoints.Note("ended", model._history.End);
            return null;
        }
    }
}
