using System;
using System.Collections.Generic;
using System.Threading;
using Rabit.Core;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;
using Rabit.Latency.Reporting;

namespace Rabit.Latency.Runs;

/// <summary>
/// What a unit of work costs that does nothing but ask for the next one, and how much of it are statistics.
/// </summary>
internal static class RunsMode
{
    public static Table Run(RunOptions options)
    {
        int runs = options.Pick(20_000, 2_000_000);
        Subject baseline = new("loop", () => [Baseline(runs)]);
        Subject without = Row("Rabit, statistics off", keepsStatistics: false, runs);
        Subject with = Row("Rabit, statistics on", keepsStatistics: true, runs);
        List<Subject> subjects = [baseline, without, with];
        Rounds.Run(subjects, options.Pick(1, options.Rounds), warmUps: options.Pick(1, 2));
        without.Dispose();
        with.Dispose();
        var table = new Table(
            "runs",
            $"a unit of work that only asks for the next one, {runs} a round",
            [new Column("CPU ns")],
            subjects,
            baseline,
            "base");
        table.RequireDifference(with, without, 0, 100);
        return table;
    }

    private static Subject Row(string name, bool keepsStatistics, int runs)
    {
        var manager = new SelfWaking();
        RabitReactor reactor = RabitRun.Create(WaitEngine.Best, keepsStatistics);
        reactor.Add(manager);
        reactor.Start();
        return new Subject(name, () => [manager.Run(runs)])
            .Owning(new Ending(() => RabitRun.End(reactor))).Owning(manager);
    }

    private static double Baseline(int runs)
    {
        var loop = new BaselineLoop();
        double perRun = 0;
        Pinned.Run(Cpus.One, () =>
        {
            long start = MonotonicClock.ThreadTime;
            loop.Run(runs);
            perRun = (MonotonicClock.ThreadTime - start) / (double)runs;
        });
        return perRun;
    }

    private sealed class SelfWaking : RabitManager, IDisposable
    {
        private readonly AutoResetEvent _ended = new(initialState: false);
        private int _asked;      // set from outside before the wake; taken by the manager
        private long _left;
        private long _start;
        private long _took;      // written before the event is set

        public SelfWaking()
            : base("self-waking") => WakeUpDelay = TimeSpan.FromHours(1);

        public double Run(int runs)
        {
            Interlocked.Exchange(ref _asked, runs);
            WakeUp();
            _ended.WaitOne();
            return Interlocked.Read(ref _took) / (double)runs;
        }

        public void Dispose() => _ended.Dispose();

        protected override void Startup() => Cpus.Pin(Cpus.One);

        protected override void ExecuteUnitOfWork()
        {
            if (_left == 0)
            {
                _left = Interlocked.Exchange(ref _asked, 0);
                _start = MonotonicClock.ThreadTime;
                if (_left == 0)
                    return;
            }

            if (--_left > 0)
            {
                WakeUp();
                return;
            }

            Interlocked.Exchange(ref _took, MonotonicClock.ThreadTime - _start);
            _ended.Set();
        }
    }
}
