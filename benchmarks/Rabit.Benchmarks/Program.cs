using System;
using System.Collections.Generic;
using System.Linq;
using BenchmarkDotNet.Configs;
using BenchmarkDotNet.Diagnosers;
using BenchmarkDotNet.Engines;
using BenchmarkDotNet.Filters;
using BenchmarkDotNet.Jobs;
using BenchmarkDotNet.Reports;
using BenchmarkDotNet.Running;
using Rabit.Benchmarks.Vision;

// Without arguments all of them; `-- --filter *Queue*` chooses, `-- --list flat` lists, `-- --job Dry` only tries
// whether they run, each once (with `-i` in this process, which needs no second build).

bool tries = args.Contains("Dry", StringComparer.OrdinalIgnoreCase);
bool chooses = args.Any(a => a is "--filter" or "-f" or "--list" or "--help" or "--info" or "--version");
string[] arguments = chooses ? args : [.. args, "--filter", "*"];

// BenchmarkDotNet builds everything once more, for a process of its own: without the analyzers, and with time for a
// small machine.
Job build = Job.Default.WithArguments([new MsBuildArgument("/p:RunAnalyzers=false")]).AsMutator();
IConfig config = ManualConfig.Create(DefaultConfig.Instance)
    .WithBuildTimeout(TimeSpan.FromMinutes(10))
    .AddDiagnoser(MemoryDiagnoser.Default)
    .AddFilter(new SimpleFilter(IsInstalled))
    .AddFilter(new SimpleFilter(IsOfTheTrial))
    .AddJob(build);
if (!TurboJpeg.IsInstalled)
    Console.WriteLine("// Skipped: JpegBenchmarks.LibTurboJpeg, libturbojpeg.so.0 is missing (Debian: libturbojpeg0).");
List<Summary> summaries = [.. BenchmarkSwitcher.FromAssembly(typeof(Program).Assembly).Run(arguments, config)];

// It goes on after a benchmark that failed; the caller must know all the same.
string[] failed =
    [.. summaries.SelectMany(s => s.Reports).Where(r => !r.Success).Select(r => r.BenchmarkCase.DisplayInfo)];
foreach (string name in failed)
    Console.Error.WriteLine("failed: " + name);
return failed.Length > 0 || summaries.Exists(s => s.HasCriticalValidationErrors) || (!chooses && summaries.Count == 0)
    ? 1
    : 0;

// What compares with a library of the system is left out where that is missing; the rest of its class still runs.
static bool IsInstalled(BenchmarkCase benchmark) =>
    TurboJpeg.IsInstalled || benchmark.Descriptor.WorkloadMethod.Name != nameof(JpegBenchmarks.LibTurboJpeg);

// A class that names a job of its own is run by that one as well; to see whether it runs, once will do.
bool IsOfTheTrial(BenchmarkCase benchmark) =>
    !tries || benchmark.Job.Run.RunStrategy == RunStrategy.ColdStart;
