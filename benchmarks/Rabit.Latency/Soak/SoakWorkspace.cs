using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Rabit.Core;

namespace Rabit.Latency.Soak;

/// <summary>
/// One workspace of the soak: rings of managers that post to and push at the next one as fast as they are woken, and
/// periodic ones.
/// </summary>
internal sealed class SoakWorkspace
{
    private const int Managers = 8;

    // A thread that is not given the CPU on a busy machine is no fault; a start that was lost is.
    private static readonly TimeSpan MaxStart = TimeSpan.FromSeconds(20);

    private readonly RabitReactor _reactor;
    private readonly List<Hammer> _hammers = [];

    public SoakWorkspace(WaitEngine engine)
    {
        _reactor = RabitRun.Create(engine);
        for (int i = 0; i < Managers; i++)
            _hammers.Add(new Hammer(i, (i + 1) % Managers));
        _hammers.ForEach(_reactor.Add);
    }

    /// <returns>How many units of work were run.</returns>
    public long Run(TimeSpan duration)
    {
        _reactor.Start();
        while (_reactor.RunFor(duration) && !_hammers.TrueForAll(h => h.HasRun) && _reactor.Now < MaxStart)
        {
            // Once more: a manager has not run yet.
        }

        _reactor.Stop();
        ReactorResult result = _reactor.Finish();
        if (result.ExitCode != 0 || result.Managers.Any(m => m.Outcome != ManagerOutcome.Ended || m.Runs == 0))
            throw new InvalidOperationException("A workspace of the soak did not end well: " + result);
        return result.Managers.Sum(m => m.Runs);
    }

    private sealed class Hammer : RabitManager
    {
        private const int Burst = 50;

        private readonly MessagePublisher<long> _own;
        private readonly MessageSubscriber<long> _neighbour;
        private readonly QueueReceiver<long> _receiver;
        private readonly QueueSender<long> _sender;
        private bool _hasRun;   // written by the manager, read from outside

        public Hammer(int number, int next)
            : base($"hammer {number}")
        {
            _own = Publish<long>($"value {number}");
            _neighbour = Subscribe<long>($"value {next}", wakeOnPost: number % 2 == 0);
            _receiver = Receive<long>($"queue {number}", capacity: 64, QueueFullMode.DropOldest);
            _sender = Send<long>($"queue {next}");
            Period = TimeSpan.FromMilliseconds(1 + number);
        }

        public bool HasRun => Volatile.Read(ref _hasRun);

        protected override void ExecuteUnitOfWork()
        {
            Volatile.Write(ref _hasRun, true);
            long sum = _neighbour.Fetch() ? _neighbour.Value : 0;
            while (_receiver.TryPop(out long value))
                sum += value;
            for (int i = 0; i < Burst; i++)
                _ = _sender.Push(i);   // what is rejected need not be there
            _own.Value = sum & 0xFFFF;
            _own.Post();
        }
    }
}
