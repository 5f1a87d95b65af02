using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Latency.Calls;
using Rabit.Latency.Contention;
using Rabit.Latency.Cost;
using Rabit.Latency.Forwarding;
using Rabit.Latency.Idle;
using Rabit.Latency.Inversion;
using Rabit.Latency.Periods;
using Rabit.Latency.PingPong;
using Rabit.Latency.Reporting;
using Rabit.Latency.Runs;
using Rabit.Latency.Soak;
using Rabit.Latency.StartUp;
using Rabit.Latency.Supervision;
using Rabit.Latency.Throughput;
using Rabit.Latency.Wake;

namespace Rabit.Latency;

/// <summary>Runs the modes that the command line names, and reports.</summary>
internal static class Runner
{
    private const int Failed = 1;
    private const int WrongUse = 2;

    private const string Soak = "soak";

    // BenchmarkDotNet measures single calls on .NET, in Rabit.Benchmarks; it does not run under Mono.
    private static readonly (string Name, Func<RunOptions, IReadOnlyList<Table>> Run)[] SingleCalls =
        Machine.IsMono ? [("calls", CallsMode.Run)] : [];

    private static readonly (string Name, Func<RunOptions, IReadOnlyList<Table>> Run)[] Modes =
    [
        ("wake", options => [WakeMode.Run(options)]),
        ("pingpong", options => [PingPongMode.OnOneCpu(options), PingPongMode.OnTwoCpus(options)]),
        ("period", PeriodMode.Run),
        ("realtime", options => [RealTimeMode.Run(options)]),
        ("inversion", options => [InversionMode.Run(options)]),
        ("idle", IdleMode.Run),
        ("start-up", options => [StartUpMode.Run(options)]),
        ("cost", CostMode.Run),
        ("throughput", ThroughputMode.Run),
        ("contention", ContentionMode.Run),
        .. SingleCalls,
        ("runs", options => [RunsMode.Run(options)]),
        ("stop", options => [StopMode.Run(options)]),
        ("fault", options => [FaultMode.Run(options)]),
        ("forward", ForwardMode.Run),
    ];

    public static int Run(string[] arguments, TextWriter output, TextWriter errors)
    {
        CommandLine line;
        try
        {
            line = CommandLine.Parse(arguments, [.. Modes.Select(m => m.Name), Soak]);
        }
        catch (FormatException e)
        {
            errors.WriteLine(e.Message);
            return WrongUse;
        }

        string machine = Machine.Describe();
        output.WriteLine(machine);
        var tables = new List<Table>();
        foreach ((string name, Func<RunOptions, IReadOnlyList<Table>> run)
            in Modes.Where(m => line.Modes.Contains(m.Name)))
        {
            foreach (Table table in run(line.Options))
            {
                TextReport.Write(output, table);
                tables.Add(table);
            }
        }

        if (line.JsonFile is not null)
            JsonReport.Write(line.JsonFile, Machine.Runtime, machine, tables);
        if (line.Document is not null)
            MarkdownReport.WriteInto(line.Document, Machine.Runtime, machine, tables);
        bool isFlat = !(line.Options.IsQuick || line.Modes.Contains(Soak)) || SoakMode.Run(line.Options, output);
        return Check(tables, line.Options, output) && isFlat ? 0 : Failed;
    }

    // A quick run measures too little to decide by; it shows that everything works.
    private static bool Check(List<Table> tables, RunOptions options, TextWriter output)
    {
        Requirement[] all = [.. tables.SelectMany(t => t.Requirements)];
        output.WriteLine();
        if (options.IsQuick)
        {
            output.WriteLine($"{tables.Count} tables; a quick run is not checked by its figures.");
            return true;
        }

        int met = all.Count(r => r.IsMet);
        output.WriteLine($"{met} of {all.Length} required figures are met.");
        return met == all.Length;
    }
}
