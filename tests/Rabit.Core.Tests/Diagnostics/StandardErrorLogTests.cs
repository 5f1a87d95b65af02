using System;
using System.IO;
using System.Linq;
using Rabit.Core.Diagnostics;
using Rabit.Core.Tests.Contracts;
using Rabit.Core.Tests.Time;
using Xunit;

namespace Rabit.Core.Tests.Diagnostics;

/// <summary>Contract 1.7: where no log is given, faults and hangs are on standard error.</summary>
public sealed class StandardErrorLogTests
{
    private readonly ManualClock _clock = new();
    private readonly StringWriter _written = new() { NewLine = "\n" };

    private string[] Lines => _written.ToString().Split(['\n'], StringSplitOptions.RemoveEmptyEntries);

    [Theory, Trait("Clause", "1.7")]
    [InlineData(RabitLogKind.Fault, true)]
    [InlineData(RabitLogKind.Hang, true)]
    [InlineData(RabitLogKind.Note, false)]
    [InlineData(RabitLogKind.Lifecycle, false)]
    [InlineData(RabitLogKind.Manager, false)]
    public void Entry_WithoutALog_IsALineIfItIsAFaultOrAHang(RabitLogKind kind, bool isWritten)
    {
        Log().Write(kind, "camera", "two\nlines");

        Assert.Equal(isWritten ? ["run: 0.000 s, camera: two lines"] : [], Lines);
    }

    [Fact, Trait("Clause", "1.7")]
    public void Entry_WithALog_IsNotWritten()
    {
        Log(_ => { }).Write(RabitLogKind.Fault, "camera", "boom");

        Assert.Empty(Lines);
    }

    [Fact, Trait("Clause", "1.7")]
    public void Entry_ThatTheLogDoesNotTake_IsWritten()
    {
        RabitLog log = Log(_ => throw new HostileException(Hostility.Throws));
        log.Write(RabitLogKind.Fault, "camera", "boom");
        log.Write(RabitLogKind.Note, "camera", "by the way");

        Assert.Equal(["run: 0.000 s, camera: boom"], Lines);
    }

    [Fact, Trait("Clause", "1.7")]
    public void Fault_WithAnException_NamesThePlace()
    {
        Exception thrown = Assert.Throws<InvalidOperationException>(void () => throw new InvalidOperationException());
        Log().Write(RabitLogKind.Fault, "camera", "boom", thrown);

        Assert.StartsWith("run: 0.000 s, camera: boom (at ", Assert.Single(Lines), StringComparison.Ordinal);
        Assert.Contains(nameof(Fault_WithAnException_NamesThePlace), Lines[0], StringComparison.Ordinal);
    }

    [Theory, Trait("Clause", "1.7")]
    [InlineData(Hostility.Throws)]
    [InlineData(Hostility.ReturnsNull)]
    [InlineData(Hostility.IsHuge)]
    public void Fault_WithAHostileException_IsALine(Hostility hostility)
    {
        Log().Write(RabitLogKind.Fault, "camera", "boom", new HostileException(hostility));

        Assert.StartsWith("run: 0.000 s, camera: boom", Assert.Single(Lines), StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "1.7")]
    public void Faults_ManyAtOnce_AreTenThenOneASecondAndTheRestIsCounted()
    {
        RabitLog log = Log();
        for (int i = 0; i < 25; i++)
            log.Write(RabitLogKind.Fault, "camera", "boom");
        Assert.Equal(StandardErrorLog.MaxAtOnce, Lines.Length);

        _clock.Timestamp += TimeSpan.TicksPerSecond;
        log.Write(RabitLogKind.Fault, "camera", "late");
        log.Write(RabitLogKind.Fault, "camera", "too many");
        log.Close();

        Assert.Equal(
            ["run: 15 more faults and hangs are not shown", "run: 1.000 s, camera: late",
                "run: 1 more faults and hangs are not shown"],
            Lines.Skip(StandardErrorLog.MaxAtOnce));
    }

    [Fact, Trait("Clause", "1.7")]
    public void Fault_StandardErrorIsClosed_DoesNotThrow()
    {
        _written.Dispose();

        Log().Write(RabitLogKind.Fault, "camera", "boom");
    }

    [Fact, Trait("Clause", "1.7")]
    public void Run_WithoutALog_WritesTheFaultToStandardError()
    {
        string name = "newcomer " + Guid.NewGuid();
        using var error = new StringWriter();
        TextWriter before = Console.Error;
        Console.SetError(TextWriter.Synchronized(error));
        try
        {
            var manager = new ScriptedManager(name, new TestBoard())
            {
                OnUnit = () => throw new InvalidOperationException("the first exception"),
            };
            Assert.Equal(1, new RabitReactor(new ReactorOptions { StopsOnSignals = false }) { manager }.Run().ExitCode);
        }
        finally
        {
            Console.SetError(before);
        }

        Assert.Contains(
            name + " in UnitOfWork: InvalidOperationException: the first exception (at ", error.ToString(),
            StringComparison.Ordinal);
    }

    private RabitLog Log(Action<RabitLogEntry>? sink = null)
        => new(
            sink, logRuns: false, new Rabit.Core.Time.RunClock(_clock), events: null,
            new StandardErrorLog("run", _clock, () => _written));
}
