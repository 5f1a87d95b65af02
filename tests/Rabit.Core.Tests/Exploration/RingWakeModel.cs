using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Queues;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// Senders, and a receiver that sleeps until a push wakes it and then pops all there is; the senders may sleep until a
/// pop wakes them. Contract 1.4: when nothing happens any more, no value that was put in is left, and no sender sleeps
/// on a value although there is room. Wakes are skipped where one is pending.
/// </summary>
internal sealed class RingWakeModel : ExploredModel
{
    private readonly RingWakeScenario _scenario;
    private readonly MessageQueue<int, ExploredSyncPoints> _queue;
    private readonly List<ExploredThread> _threads = [];

    /// <param name="scenario">Who there is.</param>
    /// <param name="engine">Of the sleepers.</param>
    /// <param name="create">
    /// Makes the queue: of the receiver's wake-up, and of the first sender's where it waits.
    /// </param>
    public RingWakeModel(
        RingWakeScenario scenario, Func<RunClock, IWaitSignal> engine,
        Func<WakeUpEvent<ExploredSyncPoints>, WakeUpEvent<ExploredSyncPoints>?,
            MessageQueue<int, ExploredSyncPoints>> create)
    {
        _scenario = scenario;
        var receiver = new Sleeper(engine);
        Sleeper[] senders = [.. scenario.Pushes.Select(_ => new Sleeper(engine))];
        _queue = create(receiver.WakeUp, scenario.SendersWait ? senders[0].WakeUp : null);
        _threads.Add(new Receiver(this, receiver));
        for (int i = 0; i < senders.Length; i++)
            _threads.Add(new Sender(this, i, senders[i]));
    }

    public override IReadOnlyList<ExploredThread> Threads => _threads;

    public override int Notes => 2 * _scenario.Pushes.Count;

    // Of the queue, and of each sleeper its state, the time of its wake and a word of its futex.
    public override (int Locations, int Signals, int Writes) Size
        => (9 + (2 * RingPositions.SizeFor(_scenario.Capacity)) + (3 * _threads.Count), _threads.Count, 24);

    public override void CheckQuiet(ExploredState state, Func<int, bool> mayRest)
    {
        for (int i = 0; i < _scenario.Pushes.Count; i++)
        {
            int accepted = state.Note(2 * i);
            state.Require(
                state.Note((2 * i) + 1) == accepted, "a push was lost: the receiver goes on sleeping on its value");
            state.Require(
                mayRest(1 + i) || _scenario.SendersWait, $"{_threads[1 + i].Name} hangs");
            state.Require(
                !_scenario.SendersWait || accepted == _scenario.Pushes[i],
                "a pop was lost: a sender goes on sleeping although there is room");
        }
    }

    private static void NoteAccepted(int sender, int values)
        => ExploredSyncPoints.Note(("accepted", sender, values), s => s.Note(2 * sender) += values);

    // What sleeps and is woken, with its loop.
    private sealed class Sleeper
    {
        private readonly StepLoop<ExploredSyncPoints> _loop;

        public Sleeper(Func<RunClock, IWaitSignal> engine)
        {
            var clock = new RunClock(new ExploredClock());
            IWaitSignal signal = engine(clock);
            WakeUp.Connect(signal, clock);
            _loop = new StepLoop<ExploredSyncPoints>(WakeUp, signal, clock);
        }

        public WakeUpEvent<ExploredSyncPoints> WakeUp { get; } = new();

        /// <summary>Sleeps until it is woken; the piece of code ends with what the step returns.</summary>
        public void Sleep(Func<object> runStep)
            => _loop.Run(NextStep.At(TimeSpan.MaxValue), (_, _) => throw Recorder.End(runStep()));
    }

    private sealed class Receiver(RingWakeModel model, Sleeper sleeper) : ExploredThread("receiver")
    {
        public override object Begin => "asleep";

        public override object? Run(object from)
        {
            sleeper.Sleep(PopAll);
            return null;
        }

        private object PopAll()
        {
            while (model._queue.TryPop(out int value))
            {
                int sender = (value >> 8) - 1;
                ExploredSyncPoints.Note(("popped", value), s =>
                {
                    int popped = ++s.Note((2 * sender) + 1);
                    s.Require(popped == (value & 0xFF), $"value {value & 0xFF} was popped as number {popped}");
                });
            }

            return Begin;
        }
    }

    private sealed class Sender(RingWakeModel model, int number, Sleeper sleeper) : ExploredThread($"sender {number}")
    {
        private const int Asleep = 1 << 16;

        // The next value; and whether it sleeps until there is room for it.
        public override object Begin => 1;

        public override object? Run(object from)
        {
            int next = (int)from;
            if (next < Asleep)
                return Push(next);
            sleeper.Sleep(() => next & ~Asleep);
            return null;
        }

        private object? Push(int next)
        {
            int most = Math.Min(model._scenario.Batch, model._scenario.Pushes[number] - next + 1);
            int accepted = most == 1 ? PushOne(next) : PushMany(next, most);
            if (accepted > 0)
                NoteAccepted(number, accepted);
            if (accepted < most)
                return model._scenario.SendersWait ? (next + accepted) | Asleep : null;
            return next + most <= model._scenario.Pushes[number] ? next + most : null;
        }

        private int PushOne(int next)
            => model._queue.Push(RingHistory.Value(number, next)) == PushResult.Queued ? 1 : 0;

        private int PushMany(int next, int count)
        {
            int[] values = [.. Enumerable.Range(next, count).Select(n => RingHistory.Value(number, n))];
            return model._queue.PushFrom(values);
        }
    }
}
