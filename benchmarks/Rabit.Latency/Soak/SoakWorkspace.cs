using System;
using System.Linq;
using Rabit.Core;

namespace Rabit.Latency.Soak;

/// <summary>One workspace of the soak: rings of managers that post to and push at the next one as fast as they are woken, and periodic ones.</summary>
internal sealed class SoakWorkspace
{
    private const int Managers = 8;

    private readonly RabitReactor _reactor;

    public SoakWorkspace(WaitEngine engine)
    {
        _reactor = RabitRun.Create(engine);
        for (int i = 0; i < Managers; i++)
            _reactor.Add(new Hammer(i, (i + 1) % Managers));
    }

    /// <returns>How many units of work were run.</returns>
    public long Run(TimeSpan duration)
    {
        _reactor.Start();
        if (!_reactor.RunFor(duration))
            throw new InvalidOperationException("A workspace of the soak stopped by itself.");
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

        public Hammer(int number, int next)
            : base($"hammer {number}")
        {
            _own = Publish<long>($"value {number}");
            _neighbour = Subscribe<long>($"value {next}", wakeOnPost: number % 2 == 0);
            _receiver = Receive<long>($"queue {number}", capacity: 64, QueueFullMode.DropOldest);
            _sender = Send<long>($"queue {next}");
            Period = TimeSpan.FromMilliseconds(1 + number);
        }

        protected override void ExecuteUnitOfWork()
        {
            long sum = _neighbour.Fetch() ? _neighbour.Value : 0;
            while (_receiver.TryPop(out long value))
                sum += value;
            for (int i = 0; i < Burst; i++)
                _sender.Push(i);
            _own.Value = sum & 0xFFFF;
            _own.Post();
        }
    }
}
