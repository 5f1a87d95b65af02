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
    private static readonly TimeSpan MaxWait = TimeSpan.FromSeconds(60);

    private static string Host => Path.Combine(
        Repository.Root, "artifacts", "bin", "NetStandardHost",
        Path.GetFileName(AppContext.BaseDirectory.TrimEnd('/', '\\')), "NetStandardHost.dll");

    [HostFact, Trait("Clause", "4.3")]
    public Task Sigterm_ToTheNetStandardBuild_StopsTheRunInOrder() => AssertStops(signal: 15, "stops: SIGTERM");

    [HostFact, Trait("Clause", "4.3")]
    public Task Sigint_ToTheNetStandardBuild_StopsTheRunInOrder() => AssertStops(signal: 2, "stops: Ctrl-C");

    private static async Task AssertStops(int signal, string reason)
    {
        var start = new ProcessStartInfo("dotnet", [Host]) { RedirectStandardOutput = true, UseShellExecute = false };
        using Process process = Process.Start(start)!;
        try
        {
            List<string> lines = [];
            await ReadUntil(process, lines, line => line == "unit of work").WaitAsync(MaxWait);

            Assert.Equal(".NETStandard,Version=v2.0", lines[0]);
            Assert.Equal(0, Kill(process.Id, signal));
            await ReadUntil(process, lines, _ => false).WaitAsync(MaxWait);
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

    // To a line that is wanted, or to the end.
    private static async Task ReadUntil(Process process, List<string> lines, Func<string, bool> isWanted)
    {
        while (await process.StandardOutput.ReadLineAsync() is { } line)
        {
            lines.Add(line);
            if (isWanted(line))
                return;
        }
    }

    [DllImport("libc", EntryPoint = "kill")]
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    private static extern int Kill(int process, int signal);

    private sealed class HostFactAttribute : FactAttribute
    {
        public HostFactAttribute()
        {
            if (!OperatingSystem.IsLinux() && !OperatingSystem.IsMacOS())
                Skip = "Signals are sent by kill(2), which this system lacks.";
            else if (!File.Exists(Host))
                Skip = $"'{Host}' is missing: a build with RabitQuick has one framework only.";
        }
    }
}
