using System;
using System.IO;
using System.Linq;
using System.Threading;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>
/// Contract 1.8 and 4.4: what a manager and the log get to know of a device, and what is not counted or reported.
/// </summary>
public abstract class DeviceReportContract(TimeKind kind) : ContractTests(kind)
{
    // Only a test that fails waits this long.
    private static TimeSpan MaxWait => TestTimeout.Limit;

    [Fact, Trait("Clause", "1.8")]
    public void Reader_FailsAndIsOpenAgain_WakesItsManagerEachTimeAndIsReported()
    {
        using TestRun run = NewRun();
        using var woken = new ManualResetEventSlim();
        ScriptedManager manager = run.Add("m");
        manager.OnUnit = () =>
        {
            if ((manager.CausesNow & WakeUpCauses.Device) != 0)
                woken.Set();
        };
        int opens = 0;
        bool hasFailed = false;
        var source = new ScriptedSource(run.Board, TimeSpan.Zero) { AtTheEnd = ReaderStep.WaitForSignal };
        source.OnRead = () =>
        {
            if (hasFailed)
                return;
            hasFailed = true;
            throw new IOException("unplugged");
        };
        source.OnOpen = () => Assert.True(++opens == 1 || woken.Wait(MaxWait));
        manager.AttachReader(
            "line", source,
            reconnect: ReconnectPolicy.After(TimeSpan.FromMilliseconds(2), TimeSpan.FromMilliseconds(2)));

        run.StartAndSettle();
        run.Until(
            () => manager.Causes.Count(c => (c & WakeUpCauses.Device) != 0) == 2,
            "its manager is woken by the fault and when the device is open again");
        run.Finish();

        RabitLogEntry fault = Assert.Single(run.Log, e => e.Kind == RabitLogKind.Fault);
        Assert.Equal(
            ("m/line", "failed, and will be opened again: IOException: unplugged"), (fault.Source, fault.Text));
        Assert.Single(run.Log, e => e.Source == "m/line" && e.Text == "its device is open again, reconnect 1");
    }

    [Fact, Trait("Clause", "1.8")]
    public void Writer_TargetThrowsWhileItsManagerShutsDown_IsReportedAndTheRestIsCounted()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        var target = new ScriptedTarget(run.Board);
        target.OnWrite = value =>
        {
            if (value == 2)
                throw new IOException("unplugged");
        };
        BlockingWriter<int> writer = manager.AttachWriter("radio", target);
        manager.OnShutdown = () => Assert.Equal(
            3, Enumerable.Range(1, 3).Count(i => writer.Push(i) == PushResult.Queued));

        run.StartAndSettle();
        run.Until(() => writer.State == DeviceState.Running, "the writer runs");
        run.Finish();

        Assert.Equal([1], target.Written);
        Assert.Equal((1, 2), (writer.Faults, writer.Discarded));
        Assert.Equal("unplugged", writer.Fault!.Message);
        RabitLogEntry fault = Assert.Single(run.Log, e => e.Kind == RabitLogKind.Fault);
        Assert.Equal(("m/radio", "failed: IOException: unplugged"), (fault.Source, fault.Text));
        Assert.Single(run.Log, e => e.Source == "m/radio" && e.Text == "2 values were lost at the end");
    }

    [Fact, Trait("Clause", "1.8")]
    public void Reader_CloseThrows_IsReportedWithItsName()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        var source = new ScriptedSource(run.Board, TimeSpan.Zero)
        {
            OnClose = () => throw new IOException("stuck"),
            AtTheEnd = ReaderStep.WaitForSignal
        };
        BlockingReader<int> reader = manager.AttachReader("line", source);

        run.StartAndSettle();
        run.Until(() => reader.State == DeviceState.Running, "the reader runs");
        run.Finish();

        RabitLogEntry fault = Assert.Single(run.Log, e => e.Kind == RabitLogKind.Fault);
        Assert.Equal(("m/line", "could not close its device: IOException: stuck"), (fault.Source, fault.Text));
    }

    [Fact, Trait("Clause", "4.4")]
    public void PeriodError_OtherWakesThanTheTimer_HasNone()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.Period = TimeSpan.FromHours(1);

        run.StartAndSettle();
        for (int i = 0; i < 3; i++)
            run.OnAndSettle(manager, () => { });
        ManagerStatus status = run.StatusOf(manager);
        run.Finish();

        Assert.Equal((4L, 0L, 0L), (status.Runs, status.WakeUps.Timer, status.PeriodError.Count));
        Assert.DoesNotContain(run.Log, e => e.Kind == RabitLogKind.Hang);
    }
}

public sealed class DeviceReportInRealTime() : DeviceReportContract(TimeKind.Real);

public sealed class DeviceReportInVirtualTime() : DeviceReportContract(TimeKind.Virtual);
