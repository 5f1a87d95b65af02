using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Queues;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// Senders and the receiver of one queue, and a reader of its counters: contract 3.1 and 3.2. The values are plain
/// words, so that one which is read too early, or written too late, shows (<see cref="RingHistory"/>).
/// </summary>
internal sealed class RingModel : ExploredModel
{
    private readonly RingScenario _scenario;
    private readonly RingHistory _history;
    private readonly MessageQueue<int, ExploredSyncPoints> _queue;
    private readonly List<ExploredThread> _threads = [];

    public RingModel(RingScenario scenario, MessageQueue<int, ExploredSyncPoints> queue)
    {
        _scenario = scenario;
        _history = new RingHistory(scenario);
        _queue = queue;
        for (int i = 0; i < scenario.Pushes.Count; i++)
            _threads.Add(new Sender(this, i));
        _threads.Add(new Receiver(this));
        if (scenario.Looks > 0)
            _threads.Add(new Reader(this));
    }

    public override IReadOnlyList<ExploredThread> Threads => _threads;

    public override int Notes => _history.Size;

    // Head, tail, head as it was last seen, half wraps, limit, last mark, and of each slot its value and sequence.
    public override (int Locations, int Signals, int Writes) Size
        => (6 + (2 * RingPositions.SizeFor(_scenario.Capacity)), 1, 24);

    public override void CheckQuiet(ExploredState state, Func<int, bool> mayRest)
    {
        for (int thread = 0; thread < _threads.Count; thread++)
            state.Require(mayRest(thread), $"{_threads[thread].Name} hangs");
    }

    private sealed class Sender(RingModel model, int number) : ExploredThread($"sender {number}")
    {
        public override object Begin => new At(1, 1);

        public override object? Run(object from)
        {
            (int call, int next) = (At)from;
            ExploredSyncPoints.NoteNext("push", s => model._history.CallPush(s, number));
            int accepted = Push(next);
            ExploredSyncPoints.Note(accepted, s => model._history.ReturnPush(s, number, accepted));
            return call < model._scenario.Pushes[number] ? new At(call + 1, next + accepted) : null;
        }

        private int Push(int first)
        {
            if (model._scenario.Batch == 1)
                return model._queue.Push(RingHistory.Value(number, first)) == PushResult.Queued ? 1 : 0;
            return model._queue.PushFrom(
                Enumerable.Range(first, model._scenario.Batch).Select(n => RingHistory.Value(number, n)).ToArray());
        }

        private sealed record At(int Call, int Next);
    }

    private sealed class Receiver(RingModel model) : ExploredThread("receiver")
    {
        public override object Begin => 1;

        public override object? Run(object from)
        {
            int call = (int)from;
            ExploredSyncPoints.NoteNext("pop", model._history.CallPop);
            int[] values = Pop();
            ExploredSyncPoints.Note(string.Join(",", values), s =>
            {
                foreach (int value in values)
                    model._history.Pop(s, value);
                model._history.ReturnPop(s, values.Length);
            });
            return call < model._scenario.Pops ? call + 1 : null;
        }

        private int[] Pop()
        {
            if (model._scenario.Batch == 1)
                return model._queue.TryPop(out int value) ? [value] : [];
            var values = new int[model._scenario.Batch];
            return values.Take(model._queue.PopInto(values)).ToArray();
        }
    }

    private sealed class Reader(RingModel model) : ExploredThread("reader of the counters")
    {
        public override object Begin => 1;

        public override object? Run(object from)
        {
            int call = (int)from;
            ExploredSyncPoints.NoteNext("look", model._history.CallLook);
            QueueCounters counters = model._queue.Counters;
            ExploredSyncPoints.Note(
                (counters.Pushed, counters.Popped, counters.Resident), s => model._history.ReturnLook(s, counters));
            return call < model._scenario.Looks ? call + 1 : null;
        }
    }
}
