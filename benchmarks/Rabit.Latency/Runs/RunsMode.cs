using System;
using System.Collections.Generic;
using System.Threading;
using Rabit.Core;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;
using Rabit.Latency.Reporting;

namespace Rabit.Latency.Runs;

/// <summary>What a unit of work costs that does nothing but ask for the next one: with statistics and everything else that Rabit does around it.</summary>
internal static class RunsMode
{
    public static Table Run(RunOptions options)
    {
        int runs = options.Pick(20_000, 2_000_000);
        using var manager = new SelfWaking();
        RabitReactor reactor = RabitRun.Create(WaitEngine.Best);
        reactor.Add(manager);
        reactor.Start();
        Subject byHand = new("loop by hand, no statistics", () => [ByHand(runs)]);
        Subject rabit = new("Rabit, status and statistics", () => [manager.Run(runs)]);
        Rounds.Run([byHand, rabit], options.Pick(1, options.Rounds), warmUps: options.Pick(1, 2));
        RabitRun.End(reactor);

        // Rabit without statistics is not slower than the loop by hand, so what is between them is at least what statistics cost.
        var table = new Table(
            "runs",
            $"a unit of work that only asks for the next one, {runs} a round; the difference bounds what statistics cost",
            [new Column("CPU ns")],
            new List<Subject> { byHand, rabit },
            byHand, "base");
        table.RequireDifference(rabit, byHand, 0, 100);
        return table;
    }

    private static double ByHand(int runs)
    {
        var loop = new HandLoop();
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
