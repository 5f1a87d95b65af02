using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// The machine that the explored threads run on: processors, memory, kernel and clock. It takes one step at a time, as
/// it is asked to.
/// </summary>
internal sealed class ExploredMachine
{
    private const int Asleep = 1;
    private const int Woken = 2;

    private readonly ExploredModel _model;
    private readonly IReadOnlyList<ExploredThread> _threads;
    private readonly StateShape _shape;
    private readonly ExploredMemory _memory;
    private readonly Recorder _recorder = new();
    private readonly CodeTree[] _code;
    private readonly CodeFold _places;
    private readonly RetriedUpdates _updates;
    private readonly LoneWriters _writers = new();
    private readonly ExplorerOptions _options;
    private readonly bool[] _hasEnded;
    private readonly TimeSpan _lastMoment;

    public ExploredMachine(ExploredModel model, ExplorerOptions options)
    {
        _model = model;
        _threads = model.Threads;
        _code = _threads.Select(thread => new CodeTree(thread, _recorder)).ToArray();
        _places = new CodeFold(options.WatchedSteps, options.WatchedAnswers);
        _updates = new RetriedUpdates();
        _options = options;
        _shape = new StateShape(
            _threads.Count, model.Size.Locations, model.Size.Writes, model.Size.Signals, model.Notes);
        _memory = new ExploredMemory(_shape, options.Memory);
        _hasEnded = new bool[_threads.Count];
        _lastMoment = new TimeSpan(model.Ticks.Step.Ticks * model.Ticks.Times);
    }

    public int Threads => _threads.Count;

    public ExploredState NewState() => new(_shape);

    public string NameOf(int thread) => _threads[thread].Name;

    /// <summary>Whether the thread may do nothing more.</summary>
    public bool MayRest(ExploredState state, int thread)
        => OperationOf(state, thread) is { Kind: SyncKind.End } or { MayNeverCome: true };

    public SyncOperation OperationOf(ExploredState state, int thread) => _places[state.Place(thread)].Place.Operation;

    /// <summary>The operation that the thread does next, notes apart.</summary>
    public SyncOperation StepOf(ExploredState state, int thread)
    {
        FoldedPlace place = _places[state.Place(thread)];
        return (place.Place.Operation.Kind == SyncKind.NoteOfNext ? _places.After(place, 0) : place).Place.Operation;
    }

    /// <summary>
    /// Whether the next step of the thread may be taken at once and alone: no run is lost by putting off the others.
    /// </summary>
    public bool IsFree(ExploredState state, int thread)
    {
        if (!_options.TakesFreeSteps)
            return false;
        FoldedPlace place = _places[state.Place(thread)];
        SyncOperation operation = place.Place.Operation;
        return operation.Kind switch
        {
            SyncKind.Write =>
                _options.Memory != MemoryModel.SequentiallyConsistent && !_model.FencesAllThreads && !IsNoted(place, 0)
                    && _writers.IsLone(operation.Location, thread),

            // A clock that stands still for good: no thread sees when it is read.
            SyncKind.ReadClock => state.TicksLeft == 0 && !IsNoted(place, (int)state.Now.Ticks),
            _ => false,
        };
    }

    /// <summary>The state before the first step.</summary>
    public void Begin(ExploredState state)
    {
        _places.Restart();
        _updates.Restart();
        Array.Clear(state.Numbers, 0, state.Numbers.Length);
        for (int location = 0; location < _shape.Locations; location++)
            state.Numbers[_shape.Counts + location] = 1;
        state.TicksLeft = _model.Ticks.Times;
        state.EarlyReturnsLeft = _model.EarlyReturns;
        for (int thread = 0; thread < Threads; thread++)
            Arrive(state, thread, _places.PlaceOf(_code[thread].Root));
    }

    public bool TryLetTimePass(ExploredState state)
    {
        if (state.TicksLeft == 0)
            return false;
        state.TicksLeft--;
        state.Now += _model.Ticks.Step;
        return true;
    }

    /// <summary>Takes the next step of a thread.</summary>
    /// <param name="state">Changed where the step is taken; else it may be spoilt.</param>
    /// <param name="thread">The thread.</param>
    /// <param name="choice">Which of the ways in which the step may go, from 0.</param>
    /// <param name="result">What the thread is received.</param>
    public StepKind Take(ExploredState state, int thread, int choice, out int result)
    {
        FoldedPlace place = _places[state.Place(thread)];
        SyncOperation operation = place.Place.Operation;
        bool mayNeverCome = operation.MayNeverCome;
        if (operation.Kind == SyncKind.NoteOfNext)
        {
            operation.Note!(state);
            place = _places.After(place, 0);
            operation = place.Place.Operation;
        }

        StepKind kind = Take(state, thread, place, choice, out result);
        return mayNeverCome && kind == StepKind.Taken ? StepKind.WithoutReason : kind;
    }

    private StepKind Take(ExploredState state, int thread, FoldedPlace place, int choice, out int result)
    {
        SyncOperation operation = place.Place.Operation;
        if (_options.MergesRetries && TryUpdate(state, thread, ref place, choice, out result))
        {
            if (choice > 0)
                return StepKind.NoSuchChoice;
            Arrive(state, thread, place);
            Forget(state);
            return StepKind.Taken;
        }

        StepKind kind = operation.Kind is SyncKind.Wait or SyncKind.FutexWait
            ? Wait(state, thread, operation, choice, out result)
            : Access(state, thread, operation, choice, out result) ? StepKind.Taken : StepKind.NoSuchChoice;
        if (kind is StepKind.NoSuchChoice or StepKind.NotNow)
            return kind;

        if (state.WaitStage(thread) != Asleep)
            Arrive(state, thread, _places.After(place, result));
        Forget(state);
        return kind;
    }

    // What the model notes happens then and not earlier.
    private bool IsNoted(FoldedPlace place, int received)
        => _places.After(place, received).Place.Operation.Kind is SyncKind.Note or SyncKind.ReadOldest;

    private void Forget(ExploredState state)
    {
        for (int thread = 0; thread < Threads; thread++)
            _hasEnded[thread] = _places[state.Place(thread)].IsEnd;
        _memory.Forget(state.Numbers, _hasEnded);
    }

    private bool TryUpdate(ExploredState state, int thread, ref FoldedPlace place, int choice, out int result)
    {
        result = 0;
        SyncOperation read = place.Place.Operation;
        if (read.Kind is not (SyncKind.Read or SyncKind.VolatileRead))
            return false;
        int first = _recorder.InitialValue(read.Location);
        result = first ^ _memory.Newest(state.Numbers, read.Location);
        if (!_updates.IsOne(place, result))
            return false;
        if (choice > 0)
            return true;
        FoldedPlace swap = _places.After(place, result);
        _writers.Meet(read.Location, thread);
        _memory.Interlocked(
            state.Numbers, thread, read.Location, swap.Place.Operation.Value ^ first, null, isRead: false);
        _updates.Meet(read.Location, swap.Place.Operation.Value);
        place = _places.After(swap, result);
        return true;
    }

    private bool Access(ExploredState state, int thread, in SyncOperation operation, int choice, out int result)
    {
        int[] s = state.Numbers;
        int location = operation.Location;
        bool isVolatile = operation.Kind is SyncKind.VolatileRead or SyncKind.VolatileWrite;

        // A memory begins with zeros: values are kept as what differs from the first.
        if (UsesMemory(operation.Kind) && location >= _shape.Locations)
            throw new InvalidOperationException($"The code has more than the model's {_shape.Locations} locations.");
        int first = UsesMemory(operation.Kind) ? _recorder.InitialValue(location) : 0;
        result = 0;
        if (UsesMemory(operation.Kind) && operation.Kind is not (SyncKind.Read or SyncKind.VolatileRead))
            _writers.Meet(location, thread);
        switch (operation.Kind)
        {
            case SyncKind.Read or SyncKind.VolatileRead:
                if (!_memory.TryRead(s, thread, location, choice, isVolatile, out result))
                    return false;
                result ^= first;
                return true;
            case SyncKind.Write or SyncKind.VolatileWrite:
                return _memory.TryWrite(s, thread, location, choice, isVolatile, operation.Value ^ first);
            case SyncKind.End:
                return false;
        }

        if (choice > 0)
            return false;
        switch (operation.Kind)
        {
            case SyncKind.Exchange or SyncKind.InterlockedRead:
                result = first
                    ^ _memory.Interlocked(
                        s, thread, location, operation.Value ^ first, null, operation.Kind == SyncKind.InterlockedRead);
                break;
            case SyncKind.InterlockedWrite:
                _memory.Interlocked(s, thread, location, operation.Value ^ first, null, isRead: false);
                break;
            case SyncKind.CompareExchange:
                result = first
                    ^ _memory.Interlocked(
                        s, thread, location, operation.Value ^ first, operation.Comparand ^ first, isRead: false);
                break;
            case SyncKind.Fence:
                _memory.Fence(s, thread);
                break;
            case SyncKind.FenceAllThreads:
                for (int each = 0; each < Threads; each++)
                    _memory.Fence(s, each);
                _memory.Fence(s, thread);
                break;
            case SyncKind.StoreBarrier:
                _memory.StoreBarrier(s, thread);
                break;
            case SyncKind.LoadBarrier:
                _memory.LoadBarrier(s, thread);
                break;
            case SyncKind.ReadClock:
                result = (int)state.Now.Ticks;
                break;
            case SyncKind.Set:
                state.SignalIsSet(location) = 1;
                _memory.HandOn(s, thread, state.SignalView(location));
                break;
            case SyncKind.FutexWake:
                WakeSleeperOn(state, location);
                break;
        }

        return true;
    }

    private static bool UsesMemory(SyncKind kind) => kind <= SyncKind.InterlockedWrite;

    // Choices: 0 what the wait is for, 1 its time is over, 2 no reason. A futex wait that has not begun: what the
    // kernel finds in the word.
    private StepKind Wait(ExploredState state, int thread, in SyncOperation operation, int choice, out int result)
    {
        result = 0;
        if (operation.Kind == SyncKind.FutexWait && state.WaitStage(thread) == 0)
        {
            _writers.Meet(operation.Location, thread);
            _memory.Fence(state.Numbers, thread);
            if (!_memory.TryRead(state.Numbers, thread, operation.Location, choice, isVolatile: false, out int word))
                return StepKind.NoSuchChoice;
            if ((word ^ _recorder.InitialValue(operation.Location)) == 0)
                FallAsleep(state, thread, operation.Until);
            return StepKind.Taken;
        }

        switch (choice)
        {
            case 0
                when operation.Kind == SyncKind.FutexWait
                    ? state.WaitStage(thread) == Woken
                    : state.SignalIsSet(operation.Location) != 0:
                if (operation.Kind == SyncKind.Wait)
                {
                    state.SignalIsSet(operation.Location) = 0;
                    _memory.TakeOver(state.Numbers, thread, state.SignalView(operation.Location));
                }

                WakeUp(state, thread);
                return StepKind.Taken;
            case 1 when state.Deadline(thread) <= state.Now.Ticks:
                WakeUp(state, thread);
                return StepKind.Taken;
            case 2 when state.EarlyReturnsLeft > 0:
                state.EarlyReturnsLeft--;
                WakeUp(state, thread);
                return StepKind.WithoutReason;
            default:
                return choice > 2 ? StepKind.NoSuchChoice : StepKind.NotNow;
        }
    }

    private void Arrive(ExploredState state, int thread, FoldedPlace place)
    {
        while (true)
        {
            SyncOperation operation = place.Place.Operation;
            int received = 0;
            if (operation.Kind == SyncKind.Note)
                operation.Note!(state);
            else if (operation.Kind == SyncKind.ReadOldest)
                received = _recorder.InitialValue(operation.Location)
                    ^ _memory.Oldest(state.Numbers, thread, operation.Location);

            // A clock that stands still for good may be read at once: no thread sees a difference.
            else if (operation.Kind == SyncKind.ReadClock && state.TicksLeft == 0)
                received = (int)state.Now.Ticks;
            else
                break;
            place = _places.After(place, received);
        }

        state.Place(thread) = place.Number;
        SyncOperation next = place.Place.Operation;
        if (next.Kind == SyncKind.Wait)
            FallAsleep(state, thread, state.Now + next.AtMost);
        else if (next.Kind == SyncKind.End && !_model.FencesAllThreads)
            _memory.ForgetThread(state.Numbers, thread);
    }

    private void FallAsleep(ExploredState state, int thread, TimeSpan end)
    {
        state.WaitStage(thread) = Asleep;
        state.Deadline(thread) = end > _lastMoment ? int.MaxValue : (int)end.Ticks;
    }

    private static void WakeUp(ExploredState state, int thread)
    {
        state.WaitStage(thread) = 0;
        state.Deadline(thread) = 0;
    }

    private void WakeSleeperOn(ExploredState state, int location)
    {
        for (int thread = 0; thread < Threads; thread++)
        {
            SyncOperation waiting = OperationOf(state, thread);
            if (waiting.Kind == SyncKind.FutexWait && waiting.Location == location && state.WaitStage(thread) == Asleep)
            {
                state.WaitStage(thread) = Woken;
                return;
            }
        }
    }
}
