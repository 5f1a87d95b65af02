using System;
using System.Threading;
using Rabit.Core;
using Rabit.Latency.Native;

namespace Rabit.Latency.Periods;

/// <summary>A manager with a fixed period. It is there, and warm, before the period begins.</summary>
internal sealed class RabitPeriod : PeriodTarget
{
    private readonly RabitReactor _reactor;
    private readonly Ticker _ticker;
    private readonly MessageSubscriber<ManagerStatus> _status;

    public RabitPeriod(WaitEngine engine, int cpu, RealTimeRequest? request = null)
    {
        _reactor = RabitRun.Create(engine);
        _ticker = new Ticker(cpu, request);
        _reactor.Add(_ticker);
        _status = _reactor.Workspace.SubscribeToStatus(_ticker.Name);
        _reactor.Start();
    }

    /// <summary>What became of the request.</summary>
    public RealTimeReport RealTime => _ticker.RealTimeReport;

    public override void Run(TimeSpan period, DeadlineRecord record)
    {
        long before = MissedDeadlines();
        _ticker.Run(period, record);
        record.Missed = MissedDeadlines() - before;
    }

    public override void Dispose()
    {
        RabitRun.End(_reactor);
        _ticker.Dispose();
    }

    private long MissedDeadlines()
    {
        _status.Fetch();
        return _status.Value.MissedDeadlines;
    }

    private sealed class Ticker : RabitManager, IDisposable
    {
        private readonly AutoResetEvent _full = new(initialState: false);
        private readonly int _cpu;
        private TimeSpan _asked;           // written before the record
        private DeadlineRecord? _record;   // set from outside before the wake; unset by the manager

        public Ticker(int cpu, RealTimeRequest? request)
            : base("ticker")
        {
            if (request is not null)
                RequestRealTime(request);
            _cpu = cpu;
            WakeUpDelay = TimeSpan.FromHours(1);
        }

        public void Run(TimeSpan period, DeadlineRecord record)
        {
            _asked = period;
            Volatile.Write(ref _record, record);
            WakeUp();
            _full.WaitOne();
        }

        public void Dispose() => _full.Dispose();

        protected override void Startup() => Cpus.Pin(_cpu);

        protected override void ExecuteUnitOfWork()
        {
            long now = MonotonicClock.Now;
            if (Volatile.Read(ref _record) is not { } record)
                return;
            record.Add(now);
            Period = _asked;
            if (!record.IsFull)
                return;
            Period = null;
            Volatile.Write(ref _record, null);
            _full.Set();
        }
    }
}
