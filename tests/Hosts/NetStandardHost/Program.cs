using System;
using System.Reflection;
using System.Runtime.Versioning;
using Rabit.Core;

// Prints what happens, one line each, until Ctrl-C or SIGTERM.
Console.WriteLine(typeof(RabitReactor).Assembly.GetCustomAttribute<TargetFrameworkAttribute>()!.FrameworkName);
ReactorResult result =
    new RabitReactor(new ReactorOptions { Log = entry => Console.WriteLine(entry.Text) }) { new Worker() }.Run();
return result.ExitCode;

internal sealed class Worker() : RabitManager("worker")
{
    protected override void ExecuteUnitOfWork() => Console.WriteLine("unit of work");

    protected override void Shutdown() => Console.WriteLine("shutdown");
}
