using System;
using System.IO;
using BenchmarkDotNet.Attributes;
using BenchmarkDotNet.Engines;
using Rabit.Core;

namespace Rabit.Benchmarks.Core;

/// <summary>An hour of six managers at 50 Hz in virtual time: 1 080 006 units of work. Read the seconds.</summary>
[SimpleJob(RunStrategy.Monitoring, launchCount: 1, warmupCount: 1, iterationCount: 5)]
public class VirtualHourBenchmarks
{
    [Benchmark(Baseline = true)]
    public int Hour() => Run(new VirtualTime(seed: 1));

    /// <summary>The same with modelled durations: 1 to 15 ms for each unit of work.</summary>
    [Benchmark]
    public int HourOfModelledWork()
    {
        var time = new VirtualTime(seed: 1);
        for (int number = 0; number < CrewMember.Crew; number++)
            time.SetUnitOfWorkDuration("member " + number, TimeSpan.FromMilliseconds(1), TimeSpan.FromMilliseconds(15));
        return Run(time);
    }

    /// <summary>The same with an event log that goes nowhere: what it costs to write it, apart from the disk.</summary>
    [Benchmark]
    public int HourWithEventLog() => Run(new VirtualTime(seed: 1) { EventLog = TextWriter.Null });

    private static int Run(VirtualTime time)
    {
        var reactor = new RabitReactor(time);
        var crew = new CrewMember[CrewMember.Crew];
        for (int number = 0; number < crew.Length; number++)
            reactor.Add(crew[number] = new CrewMember(number));
        reactor.Start();
        reactor.RunFor(TimeSpan.FromHours(1));
        reactor.Stop();
        reactor.Finish();

        int runs = 0;
        foreach (CrewMember member in crew)
            runs += member.Runs;
        return runs == crew.Length * 180_001
            ? runs
            : throw new InvalidOperationException($"{runs} units of work ran in an hour.");
    }
}
