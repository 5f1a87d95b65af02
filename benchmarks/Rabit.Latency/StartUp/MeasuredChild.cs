using System;
using System.Diagnostics;
using Rabit.Latency.Native;

namespace Rabit.Latency.StartUp;

/// <summary>This program, once more, as a child whose processor time is measured.</summary>
internal static class MeasuredChild
{
    /// <param name="argument">Its only argument.</param>
    /// <returns>
    /// Milliseconds of processor time from its start to its end, all threads, user and kernel; and of the clock.
    /// </returns>
    public static double[] Run(string argument)
    {
        var start = new ProcessStartInfo(Runtime(out string program), program + argument) { UseShellExecute = false };
        long began = MonotonicClock.Now;
        long before = ResourceUsage.OfEndedChildren();
        using Process child = Process.Start(start)
            ?? throw new InvalidOperationException("The child process was not started.");
        child.WaitForExit();
        long took = MonotonicClock.Now - began;
        if (child.ExitCode != 0)
            throw new InvalidOperationException($"The child '{argument}' ended with code {child.ExitCode}.");
        return [(ResourceUsage.OfEndedChildren() - before) / 1e3, took / 1e6];
    }

    // Mono, or 'dotnet', runs an assembly; a program of .NET runs itself.
    private static string Runtime(out string program)
    {
        using Process own = Process.GetCurrentProcess();
        string runtime = own.MainModule!.FileName;
        string assembly = typeof(MeasuredChild).Assembly.Location;
        bool isProgram = string.Equals(
            System.IO.Path.GetFileName(runtime), System.IO.Path.GetFileNameWithoutExtension(assembly),
            StringComparison.Ordinal);
        program = isProgram ? string.Empty : $"\"{assembly}\" ";
        return runtime;
    }
}
