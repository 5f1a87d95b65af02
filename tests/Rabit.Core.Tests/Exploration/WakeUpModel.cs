using System;
using System.Collections.Generic;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// One sleeper, some wakers, the reactor that opens the start-up barrier and stops, and time: contract 1.2, 1.4 and
/// 1.6.
/// </summary>
/// <remarks>
/// Each waker writes a number plainly, as a post would, and wakes. What must hold (<see cref="WakeUpHistory"/>):
/// <list type="bullet">
/// <item>at each turn: all wakes that have returned are in it or were in an earlier one, no wake is in two, none is in
/// before it was called; its causes are theirs; a turn without a wake has a timer that was due; a turn sees what was
/// written before its wakes;</item>
/// <item>when nothing happens any more without the timer, be it that no stop ever comes: every wake was in a turn that
/// saw its number;</item>
/// <item>a stop ends the sleeper, and after it has returned no turn begins.</item>
/// </list>
/// </remarks>
internal sealed class WakeUpModel : ExploredModel
{
    private static readonly TimeSpan Delay = TimeSpan.FromMilliseconds(10);

    private readonly WakeUpScenario _scenario;
    private readonly WakeUpHistory _history;
    private readonly WakeUpUnderTest _wakeUp;
    private readonly RunClock _clock = new(new ExploredClock());
    private readonly int[] _written;   // by each waker, read by the sleeper
    private readonly List<ExploredThread> _threads = [];

    public WakeUpModel(
        WakeUpScenario scenario, Func<RunClock, WakeUpUnderTest> create,
        SeededRestartFault restartFault = SeededRestartFault.None)
    {
        _scenario = scenario;
        _history = new WakeUpHistory(scenario);
        _wakeUp = create(_clock);
        _written = new int[scenario.Wakers];
        if (scenario.Restarts)
            _threads.Add(new RestartingSleeper(restartFault, Delay, _clock, _wakeUp, BeginUnit, _history.End));
        else
            _threads.Add(new Sleeper(this));
        if (scenario.Starts || scenario.Stops)
            _threads.Add(new Reactor(this));
        for (int waker = 0; waker < scenario.Wakers; waker++)
            _threads.Add(new Waker(this, waker));
    }

    public override IReadOnlyList<ExploredThread> Threads => _threads;

    public override int Notes => _history.Size;

    public override (int Times, TimeSpan Step) Ticks => (_scenario.Ticks, Delay);

    public override int EarlyReturns => _scenario.EarlyReturns;

    // The state, the time of the wake, the word of a futex, a number for each waker.
    public override (int Locations, int Signals, int Writes) Size => (3 + _scenario.Wakers, 1, 16);

    public override void CheckQuiet(ExploredState state, Func<int, bool> mayRest)
    {
        for (int thread = 1; thread < _threads.Count; thread++)
            state.Require(mayRest(thread), $"{_threads[thread].Name} hangs");
        _history.CheckQuiet(state);
    }

    private void Start()
    {
        ExploredSyncPoints.NoteNext("start", WakeUpHistory.CallStart);
        _wakeUp.Wake(WakeUpCauses.Start);
        ExploredSyncPoints.Note("started", WakeUpHistory.ReturnStart);
    }

    private void Stop()
    {
        ExploredSyncPoints.NoteNext("stop", WakeUpHistory.CallStop, mayNeverCome: true);
        _wakeUp.RequestStop();
        ExploredSyncPoints.Note("stopped", WakeUpHistory.ReturnStop);
    }

    private void WriteAndWake(int waker, int number)
    {
        default(ExploredSyncPoints).Write(ref _written[waker], number);
        ExploredSyncPoints.NoteNext("wake", s => WakeUpHistory.Call(s, waker, number));
        _wakeUp.Wake(WakeUpHistory.CauseOf(waker));
        ExploredSyncPoints.Note("woken", s => WakeUpHistory.Return(s, waker, number));
    }

    private NextStep RunStep(NextStep planned, ConsumedWakeUps wakes, TimeSpan? wokenAt)
    {
        BeginUnit(planned, wakes, wokenAt);
        if (_scenario.Ticks == 0)
            return NextStep.At(TimeSpan.MaxValue);
        TimeSpan due = _clock.Now + Delay;
        return _scenario.BacksOff ? NextStep.OnlyAt(due) : NextStep.At(due);
    }

    private void BeginUnit(NextStep planned, ConsumedWakeUps wakes, TimeSpan? wokenAt)
    {
        ExploredSyncPoints.Note((planned, wakes, wokenAt), s => _history.BeginStep(s, planned, wakes, wokenAt));
        for (int i = 0; i < _scenario.Wakers; i++)
        {
            int waker = i;
            int seen = _scenario.ReadsInSteps
                ? default(ExploredSyncPoints).Read(ref _written[waker])
                : ExploredSyncPoints.OldestSeen(ref _written[waker]);
            ExploredSyncPoints.Note((waker, seen), s => WakeUpHistory.See(s, waker, seen));
        }
    }

    private sealed class Reactor(WakeUpModel model) : ExploredThread("reactor")
    {
        public override object Begin => model._scenario.Starts ? "start" : "stop";

        public override object? Run(object from)
        {
            if (from.Equals("stop"))
            {
                model.Stop();
                return null;
            }

            model.Start();
            return model._scenario.Stops ? "stop" : null;
        }
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
        public override object Begin
            => model._scenario.Starts || model._scenario.Stops ? NextStep.AtStart() : NextStep.At(TimeSpan.MaxValue);

        public override object? Run(object from)
        {
            var planned = (NextStep)from;
            model._wakeUp.Run(planned, (wakes, wokenAt) => throw Recorder.End(model.RunStep(planned, wakes, wokenAt)));
            ExploredSyncPoints.Note("ended", model._history.End);
            return null;
        }
    }
}
