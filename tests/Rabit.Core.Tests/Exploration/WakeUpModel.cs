using System;
using System.Collections.Generic;
using Rabit.Core.Managers;
using Rabit.Core.Synchronization;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// One sleeper, some wakers, the reactor that opens the start-up barrier and stops, and time: contract 1.2, 1.4 and 1.6.
/// </summary>
/// <remarks>
/// Each waker writes a number plainly, as a post would, and wakes. What must hold:
/// <list type="bullet">
/// <item>at each turn: all wakes that have returned are in it or were in an earlier one, no wake is in two, none is in before it was called;
/// its causes are theirs; a turn without a wake has a timer that was due; a turn sees what was written before its wakes;</item>
/// <item>when nothing happens any more without the timer: every wake was in a turn that saw its number, and a stop has ended the sleeper;</item>
/// <item>after a stop has returned no turn begins.</item>
/// </list>
/// </remarks>
internal sealed class WakeUpModel : ExploredModel
{
    private static readonly TimeSpan Delay = TimeSpan.FromMilliseconds(10);
    private static readonly WakeUpCauses[] Causes = [WakeUpCauses.Post, WakeUpCauses.Push, WakeUpCauses.Request, WakeUpCauses.Pop];

    private readonly WakeUpScenario _scenario;
    private readonly WakeUpUnderTest _wakeUp;
    private readonly RunClock _clock = new(new ExploredClock());
    private readonly int[] _written;   // by each waker, read by the sleeper
    private readonly List<ExploredThread> _threads = [];

    public WakeUpModel(WakeUpScenario scenario, Func<RunClock, WakeUpUnderTest> create)
    {
        _scenario = scenario;
        _wakeUp = create(_clock);
        _written = new int[scenario.Wakers];
        _threads.Add(new Sleeper(this));
        if (scenario.Starts || scenario.Stops)
            _threads.Add(new OnePieceThread("reactor", StartAndStop));
        for (int waker = 0; waker < scenario.Wakers; waker++)
            _threads.Add(new Waker(this, waker));
    }

    public override IReadOnlyList<ExploredThread> Threads => _threads;

    public override int Notes => Note.PerWaker + (_scenario.Wakers * Note.Size);

    public override (int Times, TimeSpan Step) Ticks => (_scenario.Ticks, Delay);

    public override int EarlyReturns => _scenario.EarlyReturns;

    // The state, the time of the wake, the word of a futex, a number for each waker.
    public override (int Locations, int Signals, int Writes) Size => (3 + _scenario.Wakers, 1, 16);

    public override void CheckQuiet(ExploredState state, Func<int, bool> hasEnded)
    {
        for (int thread = 1; thread < _threads.Count; thread++)
            state.Require(hasEnded(thread), $"{_threads[thread].Name} hangs");
        state.Require(state.Note(Note.StopReturned) == 0 || hasEnded(0), "a stop was lost: the sleeper goes on sleeping");
        if (hasEnded(0) || (_scenario.Starts && state.Note(Note.Started) == 0))
            return;

        state.Require(state.Note(Note.Taken) == Returned(state), "a wake was lost: the sleeper goes on sleeping");
        for (int waker = 0; waker < _scenario.Wakers; waker++)
            state.Require(state.Note(Note.Seen + Note.Of(waker)) == state.Note(Note.Returned + Note.Of(waker)), "a post was lost: the last turn saw an older one");
    }

    private void StartAndStop()
    {
        if (_scenario.Starts)
        {
            ExploredSyncPoints.Note("start", s => s.Note(Note.StartCalled) = 1);
            _wakeUp.Wake(WakeUpCauses.Start);
            ExploredSyncPoints.Note("started", s => s.Note(Note.Started) = 1);
        }

        if (_scenario.Stops)
        {
            ExploredSyncPoints.Note("stop", s => s.Note(Note.StopCalled) = 1);
            _wakeUp.RequestStop();
            ExploredSyncPoints.Note("stopped", s => s.Note(Note.StopReturned) = 1);
        }
    }

    private void WriteAndWake(int waker, int number)
    {
        default(ExploredSyncPoints).Write(ref _written[waker], number);
        ExploredSyncPoints.Note("wake", s => s.Note(Note.Called + Note.Of(waker)) = number);
        _wakeUp.Wake(Causes[waker]);
        ExploredSyncPoints.Note("woken", s => s.Note(Note.Returned + Note.Of(waker)) = number);
    }

    private NextTurn TakeTurn(NextTurn planned, WakeUps wakes, TimeSpan? wokenAt)
    {
        ExploredSyncPoints.Note((planned, wakes, wokenAt), s => CheckTurn(s, planned, wakes, wokenAt));
        for (int i = 0; i < _scenario.Wakers; i++)
        {
            int waker = i;
            int seen = default(ExploredSyncPoints).Read(ref _written[waker]);
            ExploredSyncPoints.Note((waker, seen), s =>
            {
                s.Require(seen >= s.Note(Note.ReturnedBefore + Note.Of(waker)), "a turn does not see what was written before its wake");
                s.Note(Note.Seen + Note.Of(waker)) = seen;
            });
        }

        if (_scenario.Ticks == 0)
            return NextTurn.At(TimeSpan.MaxValue);
        TimeSpan due = _clock.Now + Delay;
        return _scenario.BacksOff ? NextTurn.OnlyAt(due) : NextTurn.At(due);
    }

    private void CheckTurn(ExploredState s, NextTurn planned, WakeUps wakes, TimeSpan? wokenAt)
    {
        bool isTimer = (wakes.Causes & WakeUpCauses.Timer) != 0;
        int taken = s.Note(Note.Taken) + wakes.Count;
        s.Require(s.Note(Note.StopReturned) == 0, "a turn began after a stop had returned");
        s.Require(isTimer || wakes.Count > 0, "a turn without a cause");
        s.Require(!isTimer || s.Now >= planned.Due, "a timer came early");
        s.Require(wokenAt is null || wokenAt <= s.Now, "a wake is said to have come later than now");
        s.Require((planned.Wanted & (int)WakeUpCauses.Post) != 0 || isTimer || (wakes.Causes & WakeUpCauses.Start) != 0, "a wake ended a sleep that it should not");
        s.Require(taken >= Returned(s), "a wake that had returned is not in the turn");
        s.Require(taken <= Called(s), "a wake is in two turns");
        s.Note(Note.Taken) = taken;
        for (int waker = 0; waker < _scenario.Wakers; waker++)
        {
            int of = Note.Of(waker);
            bool isCause = (wakes.Causes & Causes[waker]) != 0;
            s.Require(isCause || s.Note(Note.Returned + of) <= s.Note(Note.CalledBefore + of), "a wake is in the turn, but not its cause");
            s.Require(!isCause || s.Note(Note.Called + of) > s.Note(Note.ReturnedBefore + of), "a cause is in the turn, but not its wake");
            s.Note(Note.CalledBefore + of) = s.Note(Note.Called + of);
            s.Note(Note.ReturnedBefore + of) = s.Note(Note.Returned + of);
        }
    }

    private int Returned(ExploredState s) => s.Note(Note.Started) + Sum(s, Note.Returned);

    private int Called(ExploredState s) => s.Note(Note.StartCalled) + Sum(s, Note.Called);

    private int Sum(ExploredState s, int note)
    {
        int sum = 0;
        for (int waker = 0; waker < _scenario.Wakers; waker++)
            sum += s.Note(note + Note.Of(waker));
        return sum;
    }

    // The numbers that the model keeps in the state.
    private static class Note
    {
        public const int Taken = 0;
        public const int StartCalled = 1;
        public const int Started = 2;
        public const int StopCalled = 3;
        public const int StopReturned = 4;
        public const int PerWaker = 5;

        // For each waker: wakes called and returned, the same when the last turn began, and the number that the last turn saw.
        public const int Called = PerWaker;
        public const int Returned = PerWaker + 1;
        public const int CalledBefore = PerWaker + 2;
        public const int ReturnedBefore = PerWaker + 3;
        public const int Seen = PerWaker + 4;
        public const int Size = 5;

        public static int Of(int waker) => waker * Size;
    }

    private sealed class Waker(WakeUpModel model, int number) : ExploredThread($"waker {number}")
    {
        public override object Begin => 1;

        public override object? Run(object from)
        {
            int wake = (int)from;
            model.WriteAndWake(number, wake);
            return wake < model._scenario.WakesEach ? wake + 1 : null;
        }
    }

    private sealed class Sleeper(WakeUpModel model) : ExploredThread("sleeper")
    {
        public override object Begin => model._scenario.Starts || model._scenario.Stops ? NextTurn.AtStart() : NextTurn.At(TimeSpan.MaxValue);

        public override object? Run(object from)
        {
            var planned = (NextTurn)from;
            model._wakeUp.Run(planned, (wakes, wokenAt) => throw Recorder.End(model.TakeTurn(planned, wakes, wokenAt)));
            return null;
        }
    }
}
