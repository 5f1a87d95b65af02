using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Diagnostics;
using Rabit.Core.Managers;
using Rabit.Core.RealTimeKit;
using Rabit.Core.Time;
using Xunit;

namespace Rabit.Core.Tests.RealTimeKit;

public sealed class RealTimeSetupTests
{
    private readonly FakeThreadControl _system = new(0, 1);
    private readonly List<string> _log = [];
    private RealTimeSetup? _setup;

    private RealTimeSetup Setup => _setup ??= new RealTimeSetup(NewLog(), _system, "no system");

    [Fact]
    public void Apply_Everything_IsAskedOnceWithThePriorityLast()
    {
        RealTimeReport report = Apply(new RealTimeRequest
        {
            Priority = 50,
            Policy = RealTimePolicy.RoundRobin,
            Cpus = [1],
            LocksMemory = true,
            TimerSlack = TimeSpan.FromTicks(10),
            WarmUpRuns = 3,
        });

        Assert.Equal(["lock", "slack 1000", "CPUs 1", "RoundRobin 50"], _system.Asked);
        Assert.True(report.IsGranted);
        Assert.Equal(5, report.Grants.Count);
        Assert.Contains(
            _log, line => line.EndsWith("m: real time: priority round robin 50: granted", StringComparison.Ordinal));
    }

    [Fact]
    public void Apply_NoRequest_AsksNothing()
    {
        Assert.Same(RealTimeReport.Empty, Apply(request: null));
        Assert.Empty(_system.Asked);
        Assert.Empty(_log);
    }

    [Fact]
    public void Apply_EmptyRequest_AsksNothing()
    {
        Assert.Empty(Apply(new RealTimeRequest()).Grants);
        Assert.Empty(_system.Asked);
    }

    [Fact]
    public void Apply_NotPermitted_NamesTheErrorAndWhatWouldHelp()
    {
        _system.Error = SystemErrors.NotPermitted;

        RealTimeReport report = Apply(new RealTimeRequest { Priority = 20, LocksMemory = true });

        Assert.False(report.IsGranted);
        Assert.Equal(
            ["EPERM: it needs CAP_IPC_LOCK or a limit of locked memory (ulimit -l) above zero",
                "EPERM: it needs CAP_SYS_NICE or a limit of real-time priority (ulimit -r) of at least 20"],
            report.Grants.Select(g => g.Reason));
    }

    [Theory]
    [InlineData(SystemErrors.OutOfMemory, "ENOMEM: the limit of locked memory")]
    [InlineData(38, "ENOSYS")]
    [InlineData(99, "error 99")]
    public void Apply_MemoryNotLocked_SaysWhy(int error, string expected)
    {
        _system.Error = error;
        Assert.StartsWith(
            expected, Assert.Single(Apply(new RealTimeRequest { LocksMemory = true }).Grants).Reason,
            StringComparison.Ordinal);
    }

    [Fact]
    public void Apply_CpusThatTheProcessMayNotUse_SaysWhichRemain()
    {
        RealTimeGrant grant = Assert.Single(Apply(new RealTimeRequest { Cpus = [1, 7] }).Grants);
        Assert.Equal("CPUs 1, 7: not granted, the process may use only 1 of them", grant.ToString());
    }

    [Fact]
    public void Apply_NoCpuThatTheProcessMayUse_SaysSo()
        => Assert.Equal(
            "EINVAL: the process may use none of them",
            Assert.Single(Apply(new RealTimeRequest { Cpus = [7] }).Grants).Reason);

    [Fact]
    public void Apply_NoSystem_GrantsNothingAndSaysWhy()
    {
        _setup = new RealTimeSetup(NewLog(), control: null, "only on a Tuesday");

        RealTimeReport report = Apply(
            new RealTimeRequest
            {
                Priority = 1,
                Cpus = [0],
                LocksMemory = true,
                TimerSlack = TimeSpan.FromTicks(1),
                WarmUpRuns = 1
            });

        Assert.Equal(5, report.Grants.Count);
        Assert.All(report.Grants, g => Assert.Equal("only on a Tuesday", g.Reason));
        Assert.Equal(5, _log.Count);
    }

    [Fact]
    public void Apply_WarmUp_RunsAsOftenAsAsked()
    {
        var manager = new RequestingManager("m", new RealTimeRequest { WarmUpRuns = 30 });
        Setup.Apply(new ManagerActivity(manager, NewRun()));
        Assert.Equal(30, manager.WarmUps);
    }

    [Fact]
    public void Apply_WarmUpThrows_IsInTheReportAndNoFault()
    {
        var manager = new RequestingManager(
            "m", new RealTimeRequest { WarmUpRuns = 30 }, () => throw new NotSupportedException("too cold"));
        Setup.Apply(new ManagerActivity(manager, NewRun()));
        Assert.Equal(
            "warm-up 30 runs: not granted, NotSupportedException: too cold",
            Assert.Single(manager.RealTimeReport.Grants).ToString());
        Assert.Equal(1, manager.WarmUps);
    }

    [Fact]
    public void Apply_SpinnersThatLeaveACpu_AreAdmitted()
    {
        Assert.True(Apply(new RealTimeRequest { Priority = 1, Spins = true, Cpus = [1] }).IsGranted);
        Assert.True(Apply(new RealTimeRequest { Priority = 1, Spins = true, Cpus = [1] }, "second").IsGranted);
    }

    [Fact]
    public void Apply_SpinnersThatCouldOccupyEveryCpu_AreRefused()
    {
        Assert.True(Apply(new RealTimeRequest { Priority = 1, Spins = true, Cpus = [1] }).IsGranted);

        RealTimeReport report = Apply(new RealTimeRequest { Priority = 1, Spins = true }, "second");

        Assert.Contains("could occupy every CPU", Assert.Single(report.Grants).Reason, StringComparison.Ordinal);
        Assert.DoesNotContain("throttling", report.ToString(), StringComparison.Ordinal);
        Assert.Single(_system.Asked, "Fifo 1");

        // The refused one does not count.
        Assert.True(Apply(new RealTimeRequest { Priority = 1, Spins = true, Cpus = [1] }, "third").IsGranted);
    }

    [Fact]
    public void Apply_ManyThatSleep_AreAdmitted()
    {
        for (int i = 0; i < 5; i++)
            Assert.True(Apply(new RealTimeRequest { Priority = 1 }, "m" + i).IsGranted);
    }

    [Fact]
    public void Apply_ThrottlingIsOff_EveryOneCountsAsASpinner()
    {
        _system.ThrottlesRealTime = false;
        Assert.True(Apply(new RealTimeRequest { Priority = 1 }).IsGranted);
        Assert.Contains(
            "throttling is off", Assert.Single(Apply(new RealTimeRequest { Priority = 1 }, "second").Grants).Reason,
            StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(new[] { 0 }, new[] { 0 }, new int[0], true)]
    [InlineData(new[] { 0 }, new[] { 1 }, new[] { 2 }, false)]
    [InlineData(new[] { 0, 1 }, new[] { 0 }, new[] { 0, 1, 2 }, false)]
    [InlineData(new[] { 0, 1 }, new[] { 0, 1 }, new[] { 0, 1 }, true)]
    public void TryAdmit_ThreeOnThreeCpus_RefusesTheOneThatLeavesNoCpu(
        int[] first, int[] second, int[] third, bool isAdmitted)
    {
        int[] all = [0, 1, 2];
        var guard = new SpinGuard();
        Assert.True(guard.TryAdmit(first, all));
        Assert.True(guard.TryAdmit(second, all));
        Assert.Equal(isAdmitted, guard.TryAdmit(third, all));
    }

    [Fact]
    public void TryAdmit_OneCpu_RefusesEverySpinner()
        => Assert.False(new SpinGuard().TryAdmit([0], [0]));

    [Fact]
    public void ToString_OfAReport_IsATable()
    {
        _system.Error = 3;
        string[] lines = Apply(new RealTimeRequest { Cpus = [0], TimerSlack = TimeSpan.FromTicks(10) })
            .ToString().Split('\n');
        Assert.Equal(
            ["requested         granted  reason", "timer slack 1 µs  no       ESRCH", "CPUs 0            yes"], lines);
    }

    private RealTimeReport Apply(RealTimeRequest? request, string name = "m")
    {
        _system.NextThread();
        var manager = new RequestingManager(name, request);
        Setup.Apply(new ManagerActivity(manager, NewRun()));
        return manager.RealTimeReport;
    }

    private RabitLog NewLog() => new(entry => _log.Add(entry.ToString()), logRuns: false, NewClock());

    private static RunClock NewClock() => new(TimeProvider.System);

    private ManagerRun NewRun() => new(NewClock(), NewLog(), HangPolicy.Off, keepsStatistics: true, _ => { });
}
