using System;
using System.Collections.Generic;
using Rabit.Latency.Measuring;
using Rabit.Latency.Reporting;

namespace Rabit.Latency.StartUp;

/// <summary>
/// What it costs a program to start: two managers to the first value that one receives of the other, and to the end of
/// the run, beside a program of the same file that does nothing. All are child processes.
/// </summary>
internal static class StartUpMode
{
    private const int Processor = 0;
    private const double MaxMoreMilliseconds = 60;

    public static Table Run(RunOptions options)
    {
        Subject empty = Row("empty program", StartUpProgram.Empty);
        Subject firstValue = Row("two managers, to the first value", StartUpProgram.ToFirstValue);
        Subject run = Row("two managers, to the end of the run", StartUpProgram.WholeRun);
        List<Subject> subjects = [empty, firstValue, run];
        Rounds.Run(subjects, options.Pick(1, Math.Max(7, options.Rounds)));
        var table = new Table(
            "start-up", "a process to the first value that one manager receives of another, or to the end of the run",
            [new Column("CPU ms"), new Column("elapsed ms")],
            subjects,
            empty,
            "base");
        table.RequireDifference(firstValue, empty, Processor, MaxMoreMilliseconds);
        table.RequireDifference(run, empty, Processor, MaxMoreMilliseconds);
        return table;
    }

    private static Subject Row(string name, string program) => new(name, () => MeasuredChild.Run(program));
}
