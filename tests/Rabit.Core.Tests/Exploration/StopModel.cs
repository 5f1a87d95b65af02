using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Reactors;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// Managers that begin and end to delay the stop, requests, the barrier and the limit: contract 1.9.
/// </summary>
/// <remarks>
/// What must hold:
/// <list type="bullet">
/// <item>a manager that counts and then finds no request is waited for: no request that may wait stops the run before
/// it ends to delay;</item>
/// <item>one call stops the run, never two;</item>
/// <item>a request is delayed only where a manager counts, and at the end no delay is left without one.</item>
/// </list>
/// </remarks>
internal sealed class StopModel : ExploredModel
{
    private const int Stops = 0;      // how many calls were answered so
    private const int Requests = 1;   // how many have returned
    private const int Delays = 2;     // how many were answered so
    private const int IsOpen = 3;     // whether the barrier is open
    private const int Managers = 4;

    // What the note of a manager says.
    private const int Counts = 1;
    private const int IsWaitedFor = 2;   // it counts, and has found no request after that
    private const int Finishes = 3;      // it counts, and is about to end its delay

    private readonly StopState<ExploredSyncPoints> _state = new();
    private readonly int _managers;
    private readonly List<ExploredThread> _threads = [];

    /// <summary>A model.</summary>
    /// <param name="managers">How many there are; each begins and ends to delay.</param>
    /// <param name="requests">The requests, each on a thread of its own.</param>
    /// <param name="hasLimit">Whether the limit may be over at any time.</param>
    public StopModel(int managers, StopUrgency[] requests, bool hasLimit)
    {
        _managers = managers;
        for (int i = 0; i < managers; i++)
        {
            int number = i;
            Add($"manager {i}", () => Delay(Managers + number));
        }

        foreach (StopUrgency urgency in requests)
            Add($"request that {urgency}", () => Request(urgency));
        Add("barrier", Open);
        if (hasLimit)
            Add("limit", EndDelay);
    }

    public override IReadOnlyList<ExploredThread> Threads => _threads;

    public override int Notes => Managers + _managers;

    public override (int Locations, int Signals, int Writes) Size => (1, 1, 24);

    public override void CheckQuiet(ExploredState state, Func<int, bool> mayRest)
    {
        for (int thread = 0; thread < _threads.Count; thread++)
            state.Require(mayRest(thread), $"{_threads[thread].Name} hangs");
        state.Require(state.Note(Stops) == (state.Note(Requests) > 0 ? 1 : 0), "a requested stop was lost");
        state.Require(state.Note(Delays) <= 1, "two requests began a delay");
    }

    private void Delay(int note)
    {
        bool counts = _state.TryAdd();
        ExploredSyncPoints.Note((note, counts), s => s.Note(note) = counts ? Counts : 0);
        if (!counts)
            return;
        if (!_state.IsRequested)
            ExploredSyncPoints.Note((note, "in time"), s => s.Note(note) = IsWaitedFor);
        ExploredSyncPoints.NoteNext((note, "finishes"), s => s.Note(note) = Finishes);
        _state.TryRemove(out StopStep step);
        ExploredSyncPoints.Note((note, step), s =>
        {
            s.Note(note) = 0;
            if (step == StopStep.Stops)
                Stop(s, mayCutShort: false);
        });
    }

    private void Request(StopUrgency urgency)
    {
        StopStep step = _state.Request(urgency);
        ExploredSyncPoints.Note((step, urgency), s =>
        {
            bool isFurther = s.Note(Delays) > 0;
            s.Note(Requests)++;
            if (step == StopStep.Delayed)
            {
                s.Note(Delays)++;
                s.Require(urgency != StopUrgency.AtOnce, "a request that never waits is delayed");
                s.Require(s.Note(IsOpen) != 0, "a request before the barrier is delayed");
                s.Require(Count(s) > 0, "a request is delayed by no manager");
            }
            else if (step == StopStep.Stops)
            {
                s.Require(urgency != StopUrgency.Waits || !isFurther, "a request that waits ended a delay");
                Stop(s, mayCutShort: isFurther || urgency == StopUrgency.AtOnce || s.Note(IsOpen) == 0);
            }
        });
    }

    private void Open()
    {
        bool isOpen = _state.TryOpen();
        ExploredSyncPoints.Note(isOpen, s => s.Note(IsOpen) = isOpen ? 1 : 0);
    }

    private void EndDelay()
    {
        StopStep step = _state.EndDelay();
        ExploredSyncPoints.Note(step, s =>
        {
            s.Require(step == StopStep.None || s.Note(Delays) > 0, "the limit of no delay stops the run");
            if (step == StopStep.Stops)
                Stop(s, mayCutShort: true);
        });
    }

    private void Stop(ExploredState s, bool mayCutShort)
    {
        s.Require(++s.Note(Stops) == 1, "two calls stop the run");
        s.Require(mayCutShort || !IsAnyWaitedFor(s), "the run stops before a manager that is waited for has finished");
    }

    private int Count(ExploredState s) => Enumerable.Range(Managers, _managers).Count(note => s.Note(note) != 0);

    private bool IsAnyWaitedFor(ExploredState s)
        => Enumerable.Range(Managers, _managers).Any(note => s.Note(note) == IsWaitedFor);

    private void Add(string name, Action code) => _threads.Add(new OnePieceThread(name, code));
}
