using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Runtime.InteropServices;
using System.Threading.Tasks;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Reactors;

/// <summary>
/// Contract 4.3 for the netstandard2.0 build on .NET, which programs of .NET 8 and 9 get from the package: a process of
/// its own (tests/Hosts/NetStandardHost), and a real signal.
/// </summary>
public sealed class StopSignalProcessTests
{
    private const string TerminalCommand = "/usr/bin/script";
    private static readonly TimeSpan MaxWait = TimeSpan.FromSeconds(60);

    private static string Host => Path.Combine(
        Repository.Root, "artifacts", "bin", "NetStandardHost",
        Path.GetFileName(AppContext.BaseDirectory.TrimEnd('/', '\\')), "NetStandardHost.dll");

    [HostFact, Trait("Clause", "4.3")]
    public Task Sigterm_ToTheNetStandardBuild_StopsTheRunInOrder()
        => AssertStops("stops: SIGTERM", "", Signals.Terminate);

    [HostFact(Signals.Interrupt), Trait("Clause", "4.3")]
    public Task Sigint_ToTheNetStandardBuild_StopsTheRunInOrder()
        => AssertStops("stops: Ctrl-C", "", Signals.Interrupt);

    [HostFact(Signals.HangUp), Trait("Clause", "4.3")]
    public Task Sighup_ToTheNetStandardBuild_StopsTheRunInOrder()
        => AssertStops("stops: SIGHUP", "", Signals.HangUp);

    [HostFact, Trait("Clause", "4.3")]
    public Task Sighup_ThatNohupIgnores_StopsNothing()
        => AssertStops("stops: SIGTERM", "trap '' HUP; ", Signals.HangUp, Signals.Terminate);

    [HostFact(Signals.Quit), Trait("Clause", "4.3")]
    public async Task Sigquit_ToTheNetStandardBuild_EndsTheProcessAtOnce()
    {
        using Process process = Start("ulimit -c 0; exec dotnet " + Host);
        try
        {
            List<string> lines = await ReadToUnitOfWork(process);
            Assert.Equal(0, Signals.Send(process.Id, Signals.Quit));
            await ReadUntil(process.StandardOutput, lines, _ => false).WaitAsync(MaxWait);
            await process.WaitForExitAsync().WaitAsync(MaxWait);

            Assert.DoesNotContain("shutdown", lines);
            Assert.Equal(128 + Signals.Quit, process.ExitCode);
        }
        finally
        {
            process.Kill();
        }
    }

    /// <summary>
    /// The terminal goes away with the process that made it: SIGHUP comes, and the console is closed.
    /// </summary>
    [HostFact(Signals.HangUp, NeedsTerminal = true), Trait("Clause", "4.3")]
    public async Task Terminal_IsClosed_StopsTheRunInOrder()
    {
        string pipe = Path.Combine(Path.GetTempPath(), "rabit-" + Guid.NewGuid().ToString("N"));
        using Process process = Start(
            $"mkfifo {pipe} && echo made && exec {TerminalCommand} -qec 'exec dotnet {Host} {pipe}' /dev/null");
        try
        {
            Assert.Equal("made", await process.StandardOutput.ReadLineAsync().WaitAsync(MaxWait));
            using StreamReader reader = await Task.Run(() => File.OpenText(pipe)).WaitAsync(MaxWait);
            var lines = new List<string>();
            await ReadUntil(reader, lines, line => line == "unit of work").WaitAsync(MaxWait);

            process.Kill();
            await ReadUntil(reader, lines, _ => false).WaitAsync(MaxWait);

            Assert.Contains("stops: SIGHUP", lines);
            Assert.Contains("shutdown", lines);
            Assert.Equal("exit code 0", lines[^1]);
        }
        finally
        {
            process.Kill();
            File.Delete(pipe);
        }
    }

    private static async Task AssertStops(string reason, string prepare, params int[] signals)
    {
        using Process process = Start(prepare + "exec dotnet " + Host);
        try
        {
            List<string> lines = await ReadToUnitOfWork(process);

            Assert.Equal(".NETStandard,Version=v2.0", lines[0]);
            foreach (int signal in signals)
                Assert.Equal(0, Signals.Send(process.Id, signal));
            await ReadUntil(process.StandardOutput, lines, _ => false).WaitAsync(MaxWait);
            await process.WaitForExitAsync().WaitAsync(MaxWait);

            Assert.Contains(reason, lines);
            Assert.Contains("shutdown", lines);
            Assert.Equal(0, process.ExitCode);
        }
        finally
        {
            process.Kill();
        }
    }

    // The shell becomes the program, with the same process number.
    private static Process Start(string command)
        => Process.Start(new ProcessStartInfo("/bin/sh", ["-c", command])
        {
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            UseShellExecute = false,
        })!;

    private static async Task<List<string>> ReadToUnitOfWork(Process process)
    {
        var lines = new List<string>();
        await ReadUntil(process.StandardOutput, lines, line => line == "unit of work").WaitAsync(MaxWait);
        return lines;
    }

    // To a line that is wanted, or to the end.
    private static async Task ReadUntil(TextReader reader, List<string> lines, Func<string, bool> isWanted)
    {
        while (await reader.ReadLineAsync() is { } line)
        {
            lines.Add(line);
            if (isWanted(line))
                return;
        }
    }

    private sealed class HostFactAttribute : FactAttribute
    {
        public HostFactAttribute(int signal = 0)
        {
            if (!OperatingSystem.IsLinux() && !OperatingSystem.IsMacOS())
                Skip = "Signals are sent by kill(2), which this system lacks.";
            else if (!File.Exists(Host))
                Skip = $"'{Host}' is missing: a build with RabitQuick has one framework only.";
            else if (Signals.IsIgnored(signal))
                Skip = Signals.WhyIgnored;
        }

        public bool NeedsTerminal
        {
            get;
            init
            {
                field = value;
                if (value && !File.Exists(TerminalCommand))
                    Skip = $"{TerminalCommand}, which makes a terminal, is missing.";
            }
        }
    }
}
