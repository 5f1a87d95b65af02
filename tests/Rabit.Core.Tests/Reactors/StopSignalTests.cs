using System;
using System.Threading;
using System.Threading.Tasks;
using Rabit.Core.Tests.Contracts;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Reactors;

/// <summary>
/// Contract 4.3 and 1.9: Ctrl-C, SIGTERM and SIGHUP end a run in order. A real signal, to this very process.
/// </summary>
public sealed class StopSignalTests
{
    [SignalFact(Signals.Terminate), Trait("Clause", "4.3")]
    public void Sigterm_ToTheProcess_StopsTheRunInOrder() => AssertStops(Signals.Terminate, "SIGTERM");

    [SignalFact(Signals.Interrupt), Trait("Clause", "4.3")]
    public void Sigint_ToTheProcess_StopsTheRunInOrder() => AssertStops(Signals.Interrupt, "Ctrl-C");

    [SignalFact(Signals.HangUp), Trait("Clause", "4.3")]
    public void Sighup_ToTheProcess_StopsTheRunInOrder() => AssertStops(Signals.HangUp, "SIGHUP");

    /// <summary>On a busy machine, on which the signal comes before the thread of the run works.</summary>
    [SignalFact(Signals.Terminate), Trait("Clause", "4.3")]
    public void Sigterm_AsSoonAsRunAsyncHasReturned_StopsTheRunInOrder()
    {
        int isOver = 0;
        for (int i = 0; i < 8 * Environment.ProcessorCount; i++)
        {
            new Thread(() =>
            {
                while (Volatile.Read(ref isOver) == 0)
                    Thread.SpinWait(100);
            })
            { IsBackground = true }.Start();
        }

        try
        {
            for (int i = 0; i < 10; i++)
            {
                var reactor = new RabitReactor { new ScriptedManager("m", new TestBoard()) };
                Task<ReactorResult> run = reactor.RunAsync();

                Assert.Equal(0, Signals.Send(Signals.OwnProcess, Signals.Terminate));
                bool ended = run.Wait(TestTimeout.Limit);
                reactor.Stop("no signal came");

                Assert.True(ended);
                Assert.Equal(("SIGTERM", 0), (run.Result.StopReason, run.Result.ExitCode));
            }
        }
        finally
        {
            Volatile.Write(ref isOver, 1);
        }
    }

    [SignalFact(Signals.Interrupt), Trait("Clause", "1.9")]
    public void Sigint_WhileAManagerDelays_IsDelayedOnceAndTheSecondEndsIt()
        => AssertDelays(Signals.Interrupt, Signals.Interrupt, "Ctrl-C");

    [SignalFact(Signals.HangUp), Trait("Clause", "1.9")]
    public void Sigterm_WhileAManagerDelaysAfterSighup_EndsTheDelay()
        => AssertDelays(Signals.HangUp, Signals.Terminate, "SIGHUP");

    private static void AssertDelays(int first, int second, string reason)
    {
        using var isRunning = new ManualResetEventSlim();
        using var isAsked = new ManualResetEventSlim();
        var manager = new ScriptedManager("m", new TestBoard()) { DelaysStop = true };
        manager.OnUnit = () => (manager.IsStopRequested ? isAsked : isRunning).Set();
        var reactor = new RabitReactor(new ReactorOptions { MaxStopDelay = TimeSpan.FromHours(1) }) { manager };
        ReactorResult? result = null;
        var thread = new Thread(() => result = reactor.Run());
        thread.Start();
        Assert.True(isRunning.Wait(TestTimeout.Limit));

        Assert.Equal(0, Signals.Send(Signals.OwnProcess, first));
        Assert.True(isAsked.Wait(TestTimeout.Limit));
        Assert.Equal(0, Signals.Send(Signals.OwnProcess, second));
        bool ended = thread.Join(TestTimeout.Limit);
        reactor.Stop("no signal came");

        Assert.True(ended);
        Assert.Equal((reason, 1), (result!.StopReason, result.ExitCode));
        Assert.Equal(["m"], result.StillDelaying);
    }

    private static void AssertStops(int signal, string reason)
    {
        using var isRunning = new ManualResetEventSlim();
        var manager = new ScriptedManager("m", new TestBoard()) { OnUnit = isRunning.Set };
        var reactor = new RabitReactor { manager };
        ReactorResult? result = null;
        var thread = new Thread(() => result = reactor.Run());
        thread.Start();
        Assert.True(isRunning.Wait(TestTimeout.Limit));

        Assert.Equal(0, Signals.Send(Signals.OwnProcess, signal));
        bool ended = thread.Join(TestTimeout.Limit);
        reactor.Stop("no signal came");

        Assert.True(ended);
        Assert.Equal(reason, result!.StopReason);
        Assert.Equal(1, manager.Shutdowns);
        Assert.Equal(0, result.ExitCode);
    }

    private sealed class SignalFactAttribute : FactAttribute
    {
        public SignalFactAttribute(int signal)
        {
            if (Environment.OSVersion.Platform != PlatformID.Unix)
                Skip = "Signals are sent by kill(2), which this system lacks.";
            else if (Signals.IsIgnored(signal))
                Skip = Signals.WhyIgnored;
        }
    }
}
