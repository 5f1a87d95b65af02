#:property PublishAot=false
// a program of one file, run as "dotnet run eng/mutation-run.cs", is named after what it does and needs no namespace
#pragma warning disable MA0048, MA0047, CA1050
#pragma warning disable MA0004 // a program has no synchronisation context

// Runs the mutants of Rabit.Core that Stryker made (eng/mutation.sh), each against the tests that reach it. All mutants
// are in one assembly and one is switched on at a time, so a process that has started once tries hundreds of them;
// Stryker itself starts one for each few. Usage: dotnet run eng/mutation-run.cs -- REPORT.json TESTS.dll SEED COUNT [IDS]
// REPORT.json is Stryker's, TESTS.dll lies beside the mutated Rabit.Core.dll. COUNT mutants, drawn with SEED, are
// tried: against the fast tests, what survives those against all others, and what survives those too, in code that the
// explorer runs, against the exploration. IDS, with commas between them, are tried instead of the sample.
using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Runtime.Loader;
using System.Text.Json;
using System.Text.RegularExpressions;
using System.Threading;
using System.Threading.Tasks;

const int AtOnce = 3;

if (args[0] == "worker")
    return Worker.Run(args[1]);

List<Mutant> mutants = Mutant.Read(args[0]);
string tests = Path.GetFullPath(args[1]);
Mutant[] sample = [.. mutants];
new Random(int.Parse(args[2], CultureInfo.InvariantCulture)).Shuffle(sample);
sample = args.Length > 4
    ? [.. args[4].Split(',').Select(id => mutants.Single(m => m.Id == int.Parse(id, CultureInfo.InvariantCulture)))]
    : sample[..Math.Min(sample.Length, int.Parse(args[3], CultureInfo.InvariantCulture))];
var begun = Stopwatch.StartNew();
foreach (string set in new[] { "fast", "other", "exploration" })
    await TryAll(set, [.. sample.Where(m => m.IsAlive && (set != "exploration" || m.Explorations is not null))]);
foreach (Mutant mutant in sample.Where(m => m.IsAlive))
    Console.WriteLine($"{mutant.Outcome} {mutant.Id} {mutant.File}:{mutant.Line} {mutant.What}");
Mutant.WriteTables(sample, mutants.Count);
Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{begun.Elapsed.TotalMinutes:0} minutes"));
return 0;

async Task TryAll(string set, Mutant[] left)
{
    Covered covered;
    using (var first = new WorkerProcess(tests))
    {
        string answer = first.Ask("coverage " + set);
        covered = JsonSerializer.Deserialize<Covered>(
            answer.StartsWith('{') ? answer : throw new InvalidOperationException(answer))!;
    }

    Console.WriteLine(string.Create(
        CultureInfo.InvariantCulture,
        $"{set}: {left.Length} mutants, {covered.Classes} classes of tests; {begun.Elapsed.TotalMinutes:0} minutes"));
    foreach (string reason in covered.LeftOut)
        Console.WriteLine($"left out: {reason}");
    var queue = new ConcurrentQueue<Mutant>(left);
    await Task.WhenAll(Enumerable.Range(0, AtOnce).Select(_ => Task.Run(() => Try(set, covered, queue))));
}

void Try(string set, Covered covered, ConcurrentQueue<Mutant> queue)
{
    WorkerProcess? worker = null;
    while (queue.TryDequeue(out Mutant? mutant))
    {
        string[]? classes = set == "exploration"
            ? [.. covered.All!.Where(name => Regex.IsMatch(name, mutant.Explorations!))]
            : covered.Reached.GetValueOrDefault(mutant.Id);
        if (covered.Statics.Contains(mutant.Id))
        {
            // What is computed once per process is mutated only if the mutant is on from the beginning.
            using var own = new WorkerProcess(tests, mutant.Id);
            mutant.Outcome = Outcome(own.Ask($"all {set} {mutant.Id}"));
        }
        else if (classes is not null)
        {
            string question = $"test {set} {mutant.Id} {string.Join(',', classes)}";
            mutant.Outcome = Outcome((worker ??= new WorkerProcess(tests)).Ask(question));
            if (mutant.Outcome == "Dirty")
            {
                // It or one before it left something behind: the verdict of a new process counts.
                worker.Dispose();
                worker = new WorkerProcess(tests);
                mutant.Outcome = Outcome(worker.Ask(question));
                if (mutant.Outcome == "Dirty")
                    mutant.Outcome = "Killed";
                worker.Dispose();
                worker = null;
            }
            else if (worker.HasEnded)
            {
                worker.Dispose();
                worker = null;
            }
        }

        Console.WriteLine($"{set}: {mutant.Outcome} {mutant.Id} {mutant.File}:{mutant.Line} {mutant.What}");
    }

    worker?.Dispose();
}

// A process that breaks off was ended by the mutant, by an overflow of the stack for one.
static string Outcome(string answer) => answer.Length == 0 ? "Killed" : answer;

internal sealed record Mutant(int Id, string File, int Line, string What)
{
    private static readonly string[] Outcomes = ["Killed", "Timeout", "Survived", "NoCoverage"];

    public string Outcome { get; set; } = "NoCoverage";

    public bool IsAlive => Outcome is "NoCoverage" or "Survived";

    // Which explorations run the code that it is in; null for none.
    public string? Explorations => File switch
    {
        _ when File.Contains("Loan", StringComparison.Ordinal) => "Loan",
        _ when Regex.IsMatch(File, "^Queues/(MessageQueue|.*(Ring|Produc))") => "Ring|QueueClose|LoneSender|BatchClose",
        _ when Regex.IsMatch(File, "^Messages/(Slot|Spare|Latest|Subscription)") => "Slot|Subscription",
        _ when File.Contains("StageMark", StringComparison.Ordinal) => "Stage",
        _ when File.StartsWith("WakeUp/", StringComparison.Ordinal) => "WakeUp|Reduced|Loan",
        _ => null
    };

    public static List<Mutant> Read(string report)
    {
        using JsonDocument json = JsonDocument.Parse(System.IO.File.ReadAllText(report));
        var mutants = new List<Mutant>();
        foreach (JsonProperty file in json.RootElement.GetProperty("files").EnumerateObject())
        {
            string name = Regex.Replace(file.Name, ".*/Rabit.Core/", "");
            foreach (JsonElement mutant in file.Value.GetProperty("mutants").EnumerateArray())
            {
                if (mutant.GetProperty("status").GetString() is "Ignored" or "CompileError")
                    continue;
                int line = mutant.GetProperty("location").GetProperty("start").GetProperty("line").GetInt32();
                string replacement = Regex.Replace(mutant.GetProperty("replacement").GetString() ?? "", @"\s+", " ");
                mutants.Add(new Mutant(
                    int.Parse(mutant.GetProperty("id").GetString()!, CultureInfo.InvariantCulture), name, line,
                    $"[{mutant.GetProperty("mutatorName").GetString()}] {replacement}"));
            }
        }

        return mutants;
    }

    public static void WriteTables(Mutant[] mutants, int all)
    {
        // 95 %: the normal approximation, with the correction for a sample that is a good part of the whole.
        double share = mutants.Count(m => m.Outcome is "Killed" or "Timeout") / (double)mutants.Length;
        double error =
            1.96 * Math.Sqrt(share * (1 - share) / mutants.Length * (all - mutants.Length) / Math.Max(all - 1, 1));
        Console.WriteLine(string.Create(
            CultureInfo.InvariantCulture, $"{mutants.Length} of {all} mutants tried: {share:0.0 %} +- {error:0.0 %}"));
        Console.WriteLine(
            "| where | mutants | killed | timeout | survived | not reached | score |\n|---|---|---|---|---|---|---|");
        foreach (IGrouping<string, Mutant> file
            in mutants.GroupBy(m => m.File, StringComparer.Ordinal).OrderBy(g => g.Key, StringComparer.Ordinal))
            WriteRow(file.Key, file);
        foreach (IGrouping<string, Mutant> folder in mutants
            .GroupBy(m => m.File.Split('/')[0] + "/", StringComparer.Ordinal)
            .OrderBy(g => g.Key, StringComparer.Ordinal))
            WriteRow(folder.Key, folder);
        WriteRow("all", mutants);
    }

    private static void WriteRow(string where, IEnumerable<Mutant> mutants)
    {
        int[] counts = Outcomes.Select(outcome => mutants.Count(m => m.Outcome == outcome)).ToArray();
        int all = mutants.Count();
        double score = 100.0 * (counts[0] + counts[1]) / all;
        Console.WriteLine(
            string.Create(
                CultureInfo.InvariantCulture, $"| {where} | {all} | {string.Join(" | ", counts)} | {score:0.0} % |"));
    }
}

// A process with the mutated assembly and its tests in it.
internal sealed class WorkerProcess : IDisposable
{
    private readonly Process _process;

    public WorkerProcess(string tests, int? mutant = null)
    {
        var start = new ProcessStartInfo(Environment.ProcessPath!)
        {
            UseShellExecute = false,
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true
        };
        start.ArgumentList.Add("worker");
        start.ArgumentList.Add(tests);
        start.Environment["STRYKER_MUTANT_ID_CONTROL_VAR"] = "RABIT_MUTANT";
        start.Environment["RABIT_MUTANT"] = (mutant ?? -1).ToString(CultureInfo.InvariantCulture);
        _process = Process.Start(start)!;
        _ = _process.StandardError.ReadToEndAsync();
    }

    public bool HasEnded { get; private set; }

    // Empty when the process has broken off.
    public string Ask(string question)
    {
        string? line = null;
        try
        {
            _process.StandardInput.WriteLine(question);
            _process.StandardInput.Flush();
            do
                line = _process.StandardOutput.ReadLine();
            while (line is not null && !line.StartsWith(Worker.Mark, StringComparison.Ordinal));
        }
        catch (IOException)
        {
            // It has ended meanwhile.
        }

        HasEnded = line is null || line.EndsWith("Timeout", StringComparison.Ordinal);
        return line is null ? "" : line[Worker.Mark.Length..];
    }

    public void Dispose()
    {
        if (!_process.HasExited)
            _process.Kill();
        _process.Dispose();
    }
}

// The other side: loads the tests and runs those that it is asked to.
internal sealed class Worker
{
    public const string Mark = "answer: ";

    // Without threads of their own and fast: virtual time, models and units.
    private const string Fast =
        "InVirtualTime$|ModelTests$|VirtualTimeTests$|(BufferPool|MessageTypeCheck|SharedMessage)Tests$"
            + "|(PeriodGrid|DurationStatistics|DurationHistogram|Watchdog|Policy|ManagerArgument|RestartWindow)Tests$"
            + "|WakeUpStatisticsTests$|WiringTests$|Modelled(Duration|Hang)Tests$|EventLogTests$|RealTimeRequestTests$";

    // Its coverage takes too long to be measured: each step of an exploration would be noted.
    private const string Exploration = "[.]Exploration[.].*ExplorationTests$";

    // What says nothing about the mutated code: the compiler, the documents, other processes, what is allocated (a
    // mutated assembly allocates), and what takes too long while each line that it reaches is noted.
    private const string Apart =
        "[.](Analyzers|Api|Documentation|Exploration|Predecessors|Samples)[.]"
            + "|Architecture|ClauseCoverage|Allocation|Determinism|HostileException|Stress";

    private static readonly TimeSpan MaxClassTime = TimeSpan.FromSeconds(20);

    private static readonly TimeSpan CheckInterval = TimeSpan.FromMilliseconds(100);

    // A test of these takes a few milliseconds. It hangs when it has used so much of a processor, or, where it waits,
    // so much time; times in which this process itself stood still do not count.
    private static readonly TimeSpan MaxWork = TimeSpan.FromSeconds(4);
    private const int MaxChecks = 250;

    private readonly Type _control;
    private readonly Assembly _tests;
    private readonly Dictionary<string, TimeSpan> _times = [];
    private int _testsBegun;
    private string? _failure;   // of the class that ran last

    private Worker(Assembly tests)
    {
        _control = Assembly.Load("Rabit.Core").GetTypes().Single(t => t.Name == "MutantControl");
        _tests = tests;
    }

    private IEnumerable<Type> Classes(string set) => _tests.GetTypes().Where(t => !t.IsAbstract && Tests(t).Any()
        && !t.CustomAttributes.Any(a => a.ConstructorArguments is [{ Value: "Category" }, _])
        && set switch
        {
            "fast" => Regex.IsMatch(t.FullName!, Fast),
            "exploration" => Regex.IsMatch(t.FullName!, Exploration),
            _ => !Regex.IsMatch(t.FullName!, Fast) && !Regex.IsMatch(t.FullName!, Apart),
        });

    public static int Run(string path)
    {
        string folder = Path.GetDirectoryName(path)!;
        AssemblyLoadContext.Default.Resolving += (context, name) =>
            File.Exists(Path.Combine(folder, name.Name + ".dll"))
                ? context.LoadFromAssemblyPath(Path.Combine(folder, name.Name + ".dll"))
                : null;
        var worker = new Worker(AssemblyLoadContext.Default.LoadFromAssemblyPath(path));
        while (Console.ReadLine() is { } question)
        {
            string answer = worker.Answer(question.Split(' '));
            Console.WriteLine(Mark + answer);
            Console.Out.Flush();
            if (answer == "Timeout")
                Environment.Exit(1);
        }

        return 0;
    }

    private string Answer(string[] words)
    {
        if (words[0] == "coverage")
            return JsonSerializer.Serialize(Coverage(words[1]));
        int mutant = int.Parse(words[2], CultureInfo.InvariantCulture);
        bool all = words[0] == "all";
        IEnumerable<Type> classes = all ? Classes(words[1]) : words[3].Split(',').Select(name => _tests.GetType(name)!);
        foreach (Type type in classes)
        {
            Switch(mutant);
            string result = Watch(type);
            if (result == "Passed")
                continue;
            if (result == "Timeout" || all)
                return result == "Failed" ? "Killed" : result;
            Switch(-1);
            return Watch(type) == "Passed" ? "Killed" : "Dirty";
        }

        return "Survived";
    }

    private void Switch(int mutant) => _control.GetField("ActiveMutant")!.SetValue(null, mutant);

    // Which mutants each class reaches, and which are reached only once in a process; quick classes first.
    private Covered Coverage(string set)
    {
        var reached = new Dictionary<int, List<Type>>();
        var statics = new HashSet<int>();
        var leftOut = new List<string>();
        Type[] classes = [.. Classes(set)];
        if (set == "exploration")
            return new Covered(classes.Length, statics, [], leftOut, [.. classes.Select(c => c.FullName!)]);
        foreach (Type type in classes)
        {
            Switch(-1);
            _control.GetField("CaptureCoverage")!.SetValue(null, true);
            _control.GetMethod("ResetCoverage", Type.EmptyTypes)!.Invoke(null, null);
            var watch = Stopwatch.StartNew();
            string result = Watch(type);
            _control.GetField("CaptureCoverage")!.SetValue(null, false);
            if (result != "Passed" || watch.Elapsed > MaxClassTime)
            {
                leftOut.Add($"{type.FullName}: {result} after {watch.Elapsed.TotalSeconds:0.0} s. {_failure}");
                if (result == "Timeout")
                    throw new InvalidOperationException(leftOut[^1]);   // its thread goes on and would be measured too
                continue;
            }

            _times[type.FullName!] = watch.Elapsed;
            var covered = (IList<int>[])_control.GetMethod("GetCoverageData")!.Invoke(null, null)!;
            statics.UnionWith(covered[1]);
            foreach (int mutant in covered[0].Concat(covered[1]))
            {
                if (!reached.TryGetValue(mutant, out List<Type>? by))
                    reached[mutant] = by = [];
                if (!by.Contains(type))
                    by.Add(type);
            }
        }

        return new Covered(
            classes.Length - leftOut.Count, statics,
            reached.ToDictionary(p => p.Key, p => p.Value.Select(t => t.FullName!).OrderBy(n => _times[n]).ToArray()),
            leftOut, null);
    }

    // On a thread of its own, which has no state of the thread from others.
    private string Watch(Type type)
    {
        _failure = null;
        var thread = new Thread(() => _failure = FirstFailure(type)) { IsBackground = true };
        using Process self = Process.GetCurrentProcess();
        thread.Start();
        int seen = -1;
        int looks = 0;
        TimeSpan worked = default;
        while (!thread.Join(CheckInterval))
        {
            self.Refresh();
            int begun = Volatile.Read(ref _testsBegun);
            if (begun != seen)
                (seen, looks, worked) = (begun, 0, self.TotalProcessorTime);
            else if (++looks > MaxChecks || (looks > 40 && self.TotalProcessorTime - worked > MaxWork))
                return "Timeout";
        }

        return _failure is null ? "Passed" : "Failed";
    }

    private string? FirstFailure(Type type)
    {
        foreach (MethodInfo test in Tests(type))
        {
            foreach (object?[] row in Rows(test))
            {
                Interlocked.Increment(ref _testsBegun);
                try
                {
                    RunOne(type, test, row);
                }
                catch (Exception e)
                {
                    return $"{test.Name}: {e.InnerException?.Message ?? e.Message}";
                }
            }
        }

        return null;
    }

    private static void RunOne(Type type, MethodInfo test, object?[] row)
    {
        object?[] made = [.. type.GetConstructors()[0].GetParameters()
            .Select(p => DispatchProxy.Create(p.ParameterType, typeof(Silent)))];
        object instance = Activator.CreateInstance(type, made)!;
        try
        {
            if (test.Invoke(instance, row) is Task task)
                task.GetAwaiter().GetResult();
        }
        finally
        {
            (instance as IDisposable)?.Dispose();
        }
    }

    private static IEnumerable<MethodInfo> Tests(Type type) => type.GetMethods()
        .Where(m => m.GetCustomAttributes().Any(a => a.GetType().Name is "FactAttribute" or "TheoryAttribute")
            && !m.CustomAttributes.Any(a => a.ConstructorArguments is [{ Value: "Category" }, _]));

    private static IEnumerable<object?[]> Rows(MethodInfo test)
    {
        Attribute[] sources = [.. test.GetCustomAttributes().Where(a => a.GetType().GetMethod("GetData") is not null)];
        return sources.Length == 0
            ? [[]]
            : sources.SelectMany(a => (IEnumerable<object?[]?>)a.GetType().GetMethod("GetData")!.Invoke(a, [test])!)
                .Select(row => Completed(test, row));
    }

    private static object?[] Completed(MethodInfo test, object?[]? row)
        => [.. row ?? [null], .. test.GetParameters().Skip(row?.Length ?? 1).Select(p => p.DefaultValue)];

}

// Of a set of test classes: how many are run, the mutants in static state, the classes that reach each mutant, those
// that do not pass here or last too long, and, where the reach is not known, all of them.
internal sealed record Covered(
    int Classes, HashSet<int> Statics, Dictionary<int, string[]> Reached, List<string> LeftOut, string[]? All);

// Where the tests of a class write to: nowhere.
public class Silent : DispatchProxy
{
    protected override object? Invoke(MethodInfo? targetMethod, object?[]? args) => null;
}
