using System;
using System.Collections.Generic;
using System.Threading;
using Rabit.Core.Diagnostics;
using Rabit.Core.Tests.Supervision;
using Rabit.Core.Time;
using Xunit;

namespace Rabit.Core.Tests.Diagnostics;

/// <summary>Contract 1.7: a fault goes to the log, whatever reading its exception did to the thread.</summary>
public sealed class RabitLogTests : InterruptingTests
{
    private readonly List<string> _taken = [];

    // As a log that has to wait for its lock: only then is the interrupt thrown.
    [Fact, Trait("Clause", "1.7")]
    public void Write_InterruptPending_LogTakesTheEntry()
    {
        using var never = new ManualResetEvent(initialState: false);
        RabitLog log = New(entry =>
        {
            never.WaitOne(1);
            _taken.Add(entry.Text);
        });
        Thread.CurrentThread.Interrupt();

        log.Write(RabitLogKind.Fault, "m", "failed");

        Assert.Equal(["failed"], _taken);
    }

    [Fact, Trait("Clause", "1.7")]
    public void Write_LogInterruptsItselfAlways_IsTriedTwice()
    {
        int calls = 0;
        RabitLog log = New(_ =>
        {
            calls++;
            throw new ThreadInterruptedException();
        });

        log.Write(RabitLogKind.Fault, "m", "failed");

        Assert.Equal(2, calls);
    }

    private static RabitLog New(Action<RabitLogEntry> sink)
        => new(sink, logRuns: false, new RunClock(TimeProvider.System));
}
