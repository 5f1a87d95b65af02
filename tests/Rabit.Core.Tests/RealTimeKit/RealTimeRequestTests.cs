using System;
using System.Collections.Generic;
using System.Linq;
using Xunit;

namespace Rabit.Core.Tests.RealTimeKit;

public sealed class RealTimeRequestTests
{
    [Fact]
    public void Properties_OutOfRange_AreRefused()
    {
        var request = new RealTimeRequest();
        Assert.Throws<ArgumentOutOfRangeException>(() => request.Priority = 0);
        Assert.Throws<ArgumentOutOfRangeException>(() => request.Priority = 100);
        Assert.Throws<ArgumentOutOfRangeException>(() => request.Policy = (RealTimePolicy)2);
        Assert.Throws<ArgumentOutOfRangeException>(() => request.Cpus = [-1]);
        Assert.Throws<ArgumentOutOfRangeException>(() => request.Cpus = [3, 1024]);
        Assert.Throws<ArgumentOutOfRangeException>(() => request.TimerSlack = TimeSpan.Zero);
        Assert.Throws<ArgumentOutOfRangeException>(() => request.TimerSlack = TimeSpan.FromSeconds(2));
        Assert.Throws<ArgumentOutOfRangeException>(() => request.WarmUpRuns = -1);
        Assert.Throws<ArgumentNullException>(() => request.Cpus = null!);
    }

    [Fact]
    public void Cpus_InAnyOrderAndTwice_AreKeptSorted()
        => Assert.Equal([1, 4], new RealTimeRequest { Cpus = [4, 1, 4] }.Cpus);

    [Fact]
    public void RequestRealTime_ChangedAfterwards_KeepsWhatWasAsked()
    {
        var request = new RealTimeRequest { WarmUpRuns = 1 };
        var manager = new RequestingManager("m", request);
        request.WarmUpRuns = 5;
        Run(new RabitReactor(), manager);
        Assert.Equal(manager.WarmUps, OnLinux(1));
    }

    [Fact]
    public void RequestRealTime_AfterTheStart_IsRefused()
    {
        var manager = new RequestingManager("late", request: null);
        Run(new RabitReactor(), manager);
        var thrown = Assert.Throws<InvalidOperationException>(() => manager.RequestLater(new RealTimeRequest()));
        Assert.Contains("'late'", thrown.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Run_EverythingAskedOfThisMachine_IsAnsweredAndNeverThrows()
    {
        // Whatever this machine grants; but for locked memory, which would last for all tests after this one.
        var log = new List<string>();
        var manager = new RequestingManager("m", new RealTimeRequest
        {
            Priority = 1,
            Cpus = [0],
            TimerSlack = TimeSpan.FromTicks(10),
            WarmUpRuns = 2,
        });
        ReactorResult result = Run(
            new RabitReactor(new ReactorOptions { Log = e => log.Add(e.Text), StopsOnSignals = false }), manager);

        Assert.Equal(0, result.ExitCode);
        RealTimeReport report = Assert.Single(result.Managers).RealTime;
        Assert.Same(manager.RealTimeReport, report);
        Assert.Equal(4, report.Grants.Count);
        Assert.Equal(4, log.Count(line => line.StartsWith("real time: ", StringComparison.Ordinal)));
        Assert.All(report.Grants, grant => Assert.Equal(grant.IsGranted, grant.Reason is null));
        Assert.Equal(OnLinux(2), manager.WarmUpsAtStartup);

        // No system refuses a thread an exacter timer.
        Assert.Equal(
            OperatingSystem.IsLinux(),
            report.Grants.Single(g => g.Requested.StartsWith("timer slack", StringComparison.Ordinal)).IsGranted);
    }

    [Fact]
    public void Run_InVirtualTime_GrantsNothingWithANote()
    {
        var manager = new RequestingManager("m", new RealTimeRequest { Priority = 1, WarmUpRuns = 2 });
        ReactorResult result = Run(new RabitReactor(new VirtualTime(seed: 1)), manager);

        Assert.Equal(0, manager.WarmUps);
        Assert.All(
            Assert.Single(result.Managers).RealTime.Grants, g => Assert.Equal("virtual time has no threads", g.Reason));
    }

    [Fact]
    public void WarmUp_PostsSomething_IsStoppedAndReported()
    {
        var manager = new RequestingManager("m", new RealTimeRequest { WarmUpRuns = 2 }) { PostsInWarmUp = true };
        ReactorResult result = Run(new RabitReactor(), manager);

        Assert.Equal(0, result.ExitCode);
        Assert.False(Assert.Single(manager.RealTimeReport.Grants).IsGranted);
        Assert.Equal(OnLinux(1), manager.WarmUps);
    }

    private static int OnLinux(int runs) => OperatingSystem.IsLinux() ? runs : 0;

    private static ReactorResult Run(RabitReactor reactor, RabitManager manager)
    {
        reactor.Add(manager);
        reactor.Start();
        reactor.RunFor(TimeSpan.Zero);
        reactor.Stop();
        return reactor.Finish();
    }
}
