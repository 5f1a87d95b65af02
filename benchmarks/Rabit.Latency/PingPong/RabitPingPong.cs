using System;
using System.Threading;
using Rabit.Core;
using Rabit.Latency.Native;

namespace Rabit.Latency.PingPong;

/// <summary>Two managers and two queues: each is woken by the other's push.</summary>
internal sealed class RabitPingPong : PingPongTarget
{
    private readonly RabitReactor _reactor;
    private readonly Server _server;

    public RabitPingPong(WaitEngine engine, int cpu, int answererCpu, TimeSpan spin = default)
    {
        _reactor = RabitRun.Create(engine);
        _server = new Server(cpu, spin);
        _reactor.Add(_server);
        _reactor.Add(new Answerer(answererCpu, spin));
        _reactor.Start();
    }

    public override long Play(int roundTrips) => _server.Play(roundTrips);

    public override void Dispose()
    {
        RabitRun.End(_reactor);
        _server.Dispose();
    }

    private sealed class Server : RabitManager, IDisposable
    {
        private readonly QueueSender<int> _ping;
        private readonly QueueReceiver<int> _pong;
        private readonly AutoResetEvent _ended = new(initialState: false);
        private readonly int _cpu;
        private int _serves;   // set from outside before the wake; taken by the manager
        private int _left;
        private long _start;
        private long _took;    // written before the event is set

        public Server(int cpu, TimeSpan spin)
            : base("server")
        {
            _cpu = cpu;
            _ping = Send<int>("ping");
            _pong = Receive<int>("pong", capacity: 16);
            WakeUpDelay = TimeSpan.FromHours(1);
            SpinBeforeSleep = spin;
        }

        public long Play(int roundTrips)
        {
            Interlocked.Exchange(ref _serves, roundTrips);
            WakeUp();
            if (!_ended.WaitOne(TimeSpan.FromSeconds(60)))
                throw new InvalidOperationException("The ball was lost: a wake-up did not come.");
            return Interlocked.Read(ref _took);
        }

        public void Dispose() => _ended.Dispose();

        protected override void Startup() => Cpus.Pin(_cpu);

        protected override void ExecuteUnitOfWork()
        {
            while (_pong.TryPop(out int ball))
            {
                if (--_left > 0)
                {
                    _ = _ping.Push(ball);   // there is one ball
                    continue;
                }

                Interlocked.Exchange(ref _took, MonotonicClock.Now - _start);
                _ended.Set();
            }

            int serves = Interlocked.Exchange(ref _serves, 0);
            if (serves > 0)
            {
                _left = serves;
                _start = MonotonicClock.Now;
                _ = _ping.Push(1);
            }
        }
    }

    private sealed class Answerer : RabitManager
    {
        private readonly QueueReceiver<int> _ping;
        private readonly QueueSender<int> _pong;
        private readonly int _cpu;

        public Answerer(int cpu, TimeSpan spin)
            : base("answerer")
        {
            _cpu = cpu;
            _ping = Receive<int>("ping", capacity: 16);
            _pong = Send<int>("pong");
            WakeUpDelay = TimeSpan.FromHours(1);
            SpinBeforeSleep = spin;
        }

        protected override void Startup() => Cpus.Pin(_cpu);

        protected override void ExecuteUnitOfWork()
        {
            while (_ping.TryPop(out int ball))
                _ = _pong.Push(ball);
        }
    }
}
