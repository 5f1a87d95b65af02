using System;
using System.Threading;
using Xunit;

namespace Rabit.Core.Tests.Supervision;

/// <summary>
/// Contract 1.7 to 1.9: the figures of the ready-made policies, which figures are taken, and what is said of the
/// others.
/// </summary>
public sealed class PolicyTests
{
    private static readonly TimeSpan Second = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan Minute = TimeSpan.FromMinutes(1);

    [Fact]
    public void FaultPolicy_ReadyMade_HasTheFiguresOfItsDocumentation()
    {
        Assert.Equal(FaultAction.StopSystem, FaultPolicy.StopSystem.Action);
        Assert.Equal(FaultAction.StopManager, FaultPolicy.StopManager.Action);

        FaultPolicy carryOn = FaultPolicy.CarryOn;
        Assert.Equal(FaultAction.CarryOn, carryOn.Action);
        Assert.Equal(TimeSpan.FromMilliseconds(10), carryOn.FirstDelay);
        Assert.Equal(Second, carryOn.MaxDelay);

        FaultPolicy restart = FaultPolicy.Restart;
        Assert.Equal(FaultAction.Restart, restart.Action);
        Assert.Equal(TimeSpan.FromMilliseconds(100), restart.FirstDelay);
        Assert.Equal(TimeSpan.FromSeconds(10), restart.MaxDelay);
        Assert.Equal(5, restart.MaxRestarts);
        Assert.Equal(Minute, restart.Window);
        Assert.Equal(FaultAction.StopSystem, restart.Finally);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(1000)]
    public void RestartAfter_OutermostFigures_AreTaken(int maxRestarts)
    {
        FaultPolicy policy = FaultPolicy.RestartAfter(Second, Second, maxRestarts, Minute, FaultAction.StopManager);

        Assert.Equal(Second, policy.FirstDelay);
        Assert.Equal(Second, policy.MaxDelay);
        Assert.Equal(maxRestarts, policy.MaxRestarts);
        Assert.Equal(Minute, policy.Window);
        Assert.Equal(FaultAction.StopManager, policy.Finally);
    }

    [Fact]
    public void FaultPolicy_BadFigures_AreRefusedByName()
    {
        AssertRefused(() => FaultPolicy.CarryOnAfter(TimeSpan.Zero, Second), "firstDelay", "The delay after a fault");
        AssertRefused(() => FaultPolicy.CarryOnAfter(Minute, Second), "maxDelay", "The longest delay after a fault");
        AssertRefused(
            () => FaultPolicy.RestartAfter(TimeSpan.Zero, Second, 1, Minute), "firstDelay",
            "The delay before a restart");
        AssertRefused(
            () => FaultPolicy.RestartAfter(Minute, Second, 1, Minute), "maxDelay",
            "The longest delay before a restart");
        AssertRefused(() => FaultPolicy.RestartAfter(Second, Second, 0, Minute), "maxRestarts", "1 to 1000 times");
        AssertRefused(() => FaultPolicy.RestartAfter(Second, Second, 1001, Minute), "maxRestarts", "1 to 1000 times");
        AssertRefused(
            () => FaultPolicy.RestartAfter(Second, Second, 1, TimeSpan.Zero), "window",
            "The window in which restarts are counted");
        AssertRefused(
            () => FaultPolicy.RestartAfter(Second, Second, 1, Minute, FaultAction.CarryOn), "finally",
            "Restarts end with a stop");
    }

    [Fact]
    public void ReconnectPolicy_ReadyMadeAndOutermost_HasTheFiguresOfItsDocumentation()
    {
        Assert.Equal(0, ReconnectPolicy.Never.MaxAttempts);

        ReconnectPolicy always = ReconnectPolicy.Always;
        Assert.Equal(TimeSpan.FromMilliseconds(100), always.FirstDelay);
        Assert.Equal(TimeSpan.FromSeconds(5), always.MaxDelay);
        Assert.Equal(int.MaxValue, always.MaxAttempts);

        ReconnectPolicy once = ReconnectPolicy.After(Second, Second, maxAttempts: 1);
        Assert.Equal(Second, once.FirstDelay);
        Assert.Equal(Second, once.MaxDelay);
        Assert.Equal(1, once.MaxAttempts);
    }

    [Fact]
    public void ReconnectPolicy_BadFigures_AreRefusedByName()
    {
        AssertRefused(
            () => ReconnectPolicy.After(TimeSpan.Zero, Second), "firstDelay",
            "The delay before a device is opened again");
        AssertRefused(
            () => ReconnectPolicy.After(Minute, Second), "maxDelay",
            "The longest delay before a device is opened again");
        AssertRefused(
            () => ReconnectPolicy.After(Second, Second, maxAttempts: 0), "maxAttempts", "ReconnectPolicy.Never");
    }

    [Fact]
    public void HangPolicy_ReadyMade_HasTheFiguresOfItsDocumentation()
    {
        HangPolicy report = HangPolicy.Report;
        AssertLimits(report, TimeSpan.FromSeconds(30), TimeSpan.FromSeconds(5), TimeSpan.FromSeconds(5));
        Assert.False(report.StopsSystem);
        Assert.Null(report.Callback);

        AssertLimits(HangPolicy.StopSystem, TimeSpan.FromSeconds(30), TimeSpan.FromSeconds(5), TimeSpan.FromSeconds(5));
        Assert.True(HangPolicy.StopSystem.StopsSystem);

        AssertLimits(HangPolicy.Off, Timeout.InfiniteTimeSpan, Timeout.InfiniteTimeSpan, Timeout.InfiniteTimeSpan);
        Assert.False(HangPolicy.Off.StopsSystem);
    }

    [Fact]
    public void HangPolicy_MadeFromAnother_KeepsWhatIsNotSaid()
    {
        void OnHang(ManagerHang hang)
        {
        }

        HangPolicy all = HangPolicy.Report.AndStopSystem().AndCall(OnHang).WithLimits(Second);
        AssertLimits(all, TimeSpan.FromSeconds(30), Second, TimeSpan.FromSeconds(5));
        Assert.True(all.StopsSystem);
        Assert.Equal(OnHang, all.Callback);

        HangPolicy other = all.WithLimits(Minute, startup: Second, shutdown: Timeout.InfiniteTimeSpan).AndStopSystem();
        AssertLimits(other, Second, Minute, Timeout.InfiniteTimeSpan);
        Assert.Equal(OnHang, other.Callback);
    }

    [Fact]
    public void HangPolicy_BadFigures_AreRefusedByName()
    {
        AssertRefused(() => HangPolicy.Report.WithLimits(TimeSpan.Zero), "unitOfWork", "limit of the watchdog");
        AssertRefused(
            () => HangPolicy.Report.WithLimits(Second, startup: TimeSpan.Zero), "startup", "limit of the watchdog");
        AssertRefused(
            () => HangPolicy.Report.WithLimits(Second, shutdown: TimeSpan.Zero), "shutdown", "limit of the watchdog");
        AssertRefused(() => HangPolicy.Report.AndCall(null!), "callback");
    }

    private static void AssertLimits(HangPolicy policy, TimeSpan startup, TimeSpan unitOfWork, TimeSpan shutdown)
    {
        Assert.Equal(startup, policy.StartupLimit);
        Assert.Equal(unitOfWork, policy.UnitOfWorkLimit);
        Assert.Equal(shutdown, policy.ShutdownLimit);
    }

    private static void AssertRefused(Func<object> bad, string parameter, string expected = "")
    {
        ArgumentException thrown = Assert.ThrowsAny<ArgumentException>(bad);
        Assert.Equal(parameter, thrown.ParamName);
        Assert.Contains(expected, thrown.Message, StringComparison.Ordinal);
    }
}
