using System;
using System.Runtime.InteropServices;
using System.Threading;
using Rabit.Core.Tests.Contracts;
using Xunit;

namespace Rabit.Core.Tests.Reactors;

/// <summary>Contract 4.3: Ctrl-C and SIGTERM end a run in order. A real signal, to this very process.</summary>
public sealed class StopSignalTests
{
    [UnixFact, Trait("Clause", "4.3")]
    public void Sigterm_ToTheProcess_StopsTheRunInOrder() => AssertStops(signal: 15, "SIGTERM");

    [UnixFact, Trait("Clause", "4.3")]
    public void Sigint_ToTheProcess_StopsTheRunInOrder() => AssertStops(signal: 2, "Ctrl-C");

    private static void AssertStops(int signal, string reason)
    {
        using var isRunning = new ManualResetEventSlim();
        var manager = new ScriptedManager("m", new TestBoard()) { OnUnit = isRunning.Set };
        var reactor = new RabitReactor { manager };
        ReactorResult? result = null;
        var thread = new Thread(() => result = reactor.Run());
        thread.Start();
        Assert.True(isRunning.Wait(TimeSpan.FromSeconds(20)));

        Assert.Equal(0, Kill(OwnId(), signal));
        bool ended = thread.Join(TimeSpan.FromSeconds(20));
        reactor.Stop("no signal came");

        Assert.True(ended);
        Assert.Equal(reason, result!.StopReason);
        Assert.Equal(1, manager.Shutdowns);
        Assert.Equal(0, result.ExitCode);
    }

    [DllImport("libc", EntryPoint = "getpid")]
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    private static extern int OwnId();

    [DllImport("libc", EntryPoint = "kill")]
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    private static extern int Kill(int process, int signal);

    private sealed class UnixFactAttribute : FactAttribute
    {
        public UnixFactAttribute()
        {
            if (Environment.OSVersion.Platform != PlatformID.Unix)
                Skip = "Signals are sent by kill(2), which this system lacks.";
        }
    }
}
