using System;
using System.Collections.Generic;
using Rabit.Latency.Measuring;
using Rabit.Latency.Reporting;

namespace Rabit.Latency.StartUp;

/// <summary>
/// What it costs a program to start: two managers to their first unit of work and the end of the run, beside a program
/// of the same file that does nothing. Both are child processes.
/// </summary>
internal static class StartUpMode
{
    private const int Processor = 0;
    private const double MaxMoreMilliseconds = 60;

    public static Table Run(RunOptions options)
    {
        Subject empty = Row("empty program", StartUpProgram.Empty);
        Subject managers = Row("two managers", StartUpProgram.TwoManagers);
        Rounds.Run([empty, managers], options.Pick(1, Math.Max(7, options.Rounds)));
        List<Subject> subjects = [empty, managers];
        var table = new Table(
            "start-up", "a process to the first value that one manager receives of another, and to its end",
            [new Column("CPU ms"), new Column("elapsed ms")],
            subjects,
            empty,
            "base");
        table.RequireDifference(managers, empty, Processor, MaxMoreMilliseconds);
        return table;
    }

    private static Subject Row(string name, string program) => new(name, () => MeasuredChild.Run(program));
}
