using System;
using System.IO;
using System.Reflection;
using System.Runtime.Versioning;
using Rabit.Core;

// Prints what happens, one line each, until a signal stops the run: to the console, or to the file that the argument
// names, for a test that takes the console away.
using TextWriter output = args.Length == 0
    ? Console.Out
    : new StreamWriter(new FileStream(args[0], FileMode.Open, FileAccess.Write)) { AutoFlush = true };
output.WriteLine(typeof(RabitReactor).Assembly.GetCustomAttribute<TargetFrameworkAttribute>()!.FrameworkName);
ReactorResult result = new RabitReactor(new ReactorOptions { Log = entry => output.WriteLine(entry.Text) })
{
    new Worker(output),
}.Run();
output.WriteLine("exit code " + result.ExitCode);
return result.ExitCode;

internal sealed class Worker(TextWriter output) : RabitManager("worker")
{
    protected override void ExecuteUnitOfWork() => output.WriteLine("unit of work");

    protected override void Shutdown() => output.WriteLine("shutdown");
}
