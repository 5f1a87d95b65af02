using System;
using System.Collections.Generic;
using System.Threading;
using Rabit.Core;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;
using Rabit.Latency.Reporting;

namespace Rabit.Latency.Supervision;

/// <summary>What a manager costs whose unit of work always throws.</summary>
internal static class FaultMode
{
    public static Table Run(RunOptions options)
    {
        // A shorter time is harder to meet: most is thrown before the back-off has grown.
        double seconds = options.Pick(0.3, 2.0);
        Subject[] policies =
        [
            Row("Rabit, carry on", FaultPolicy.CarryOn, seconds),
            Row("Rabit, restart", FaultPolicy.Restart, seconds),
            Row("Rabit, stop the manager", FaultPolicy.StopManager, seconds),
            Row("Rabit, stop the system", FaultPolicy.StopSystem, seconds),
        ];
        List<Subject> subjects = [new("caught in a loop", () => Baseline(Math.Min(seconds, 0.5))), .. policies];
        Rounds.Run(subjects, options.Pick(1, options.Rounds), warmUps: 1);
        var table = new Table(
            "fault",
            "a unit of work that always throws, from its first fault",
            [new Column("% of a core", "0.00"), new Column("throws/s", "0.0")],
            subjects);
        foreach (Subject policy in policies)
            table.RequireMax(policy, 0, 1);
        return table;
    }

    private static Subject Row(string name, FaultPolicy policy, double seconds)
        => new(name, () => Measure(policy, seconds), warmUp: () => Measure(policy, seconds / 10));

    private static double[] Measure(FaultPolicy policy, double seconds)
    {
        var thrower = new Thrower { FaultPolicy = policy };
        var reactor = new RabitReactor(new ReactorOptions { StopsOnSignals = false }) { thrower };
        reactor.Start();
        double load = CpuLoad.During(seconds);
        long thrown = thrower.Thrown;
        reactor.Stop();
        reactor.Finish();
        if (thrown == 0)
            throw new InvalidOperationException("Nothing was thrown.");
        return [load, thrown / seconds];
    }

    private static double[] Baseline(double seconds)
    {
        using var signal = new AutoResetEvent(initialState: false);
        bool stopped = false;
        long thrown = 0;
        var thread = new Thread(() =>
        {
            while (!Volatile.Read(ref stopped))
            {
                try
                {
                    thrown++;
                    throw new InvalidOperationException("always");
                }
                catch (InvalidOperationException)
                {
                    // What a supervisor without back-off does.
                }
            }
        })
        {
            IsBackground = true,
        };
        thread.Start();
        double load = CpuLoad.During(seconds);
        Volatile.Write(ref stopped, true);
        thread.Join();
        return [load, thrown / seconds];
    }

    private sealed class Thrower : RabitManager
    {
        private long _thrown;   // written by the manager, read from outside

        public Thrower()
            : base("thrower") => WakeUpDelay = TimeSpan.FromTicks(1);

        public long Thrown => Interlocked.Read(ref _thrown);

        protected override void ExecuteUnitOfWork()
        {
            Interlocked.Increment(ref _thrown);
            throw new InvalidOperationException("always");
        }
    }
}
