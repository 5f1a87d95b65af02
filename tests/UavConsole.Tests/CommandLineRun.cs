using System;
using System.CommandLine;
using System.IO;
using System.Threading;
using Xunit;

namespace UavConsole.Tests;

/// <summary>
/// UavConsole's command line inside the process of the tests: for what it reads, and what it refuses before anything
/// runs. What it does and prints is <see cref="ConsoleProcess"/>'s.
/// </summary>
internal static class CommandLineRun
{
    // Only a test that fails waits for it: what should have been refused runs.
    private static readonly TimeSpan MaxWait = TimeSpan.FromSeconds(150);

    // The options are shared, and keep the commands that they belong to: one at a time.
    private static readonly object Gate = new();

    /// <summary>What is written of a command line that is refused.</summary>
    public static string[] Refuse(params string[] arguments)
    {
        using var errors = new StringWriter();
        int? exitCode = null;
        var run = new Thread(() =>
        {
            lock (Gate)
                exitCode = CommandLine.Run(arguments, errors, FlightRun.Run);
        })
        { IsBackground = true };
        run.Start();
        Assert.True(run.Join(MaxWait), "It is not refused, but runs.");
        Assert.True(exitCode == 2, errors.ToString());
        return errors.ToString().Split([Environment.NewLine], StringSplitOptions.RemoveEmptyEntries);
    }

    /// <summary>What was asked for by a command line that is accepted.</summary>
    public static ConsoleOptions Read(params string[] arguments)
    {
        ConsoleOptions? read = null;
        using var errors = new StringWriter();
        lock (Gate)
        {
            int exitCode = CommandLine.Run(
                arguments,
                errors,
                (options, _) =>
                {
                    read = options;
                    return 0;
                });
            Assert.True(exitCode == 0, errors.ToString());
        }

        return read!;
    }

    /// <summary>The command with all its options.</summary>
    public static RootCommand Create()
    {
        lock (Gate)
            return CommandLine.Create(TextWriter.Null, (_, _) => 0);
    }
}
