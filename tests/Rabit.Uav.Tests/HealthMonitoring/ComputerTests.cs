using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink.Messages;
using Rabit.Uav.HealthMonitoring;
using Rabit.Uav.Messages;
using Rabit.Uav.Preflight;
using Xunit;

namespace Rabit.Uav.Tests.HealthMonitoring;

/// <summary>The rules for the companion computer, and what is sent of it.</summary>
public sealed class ComputerTests : IDisposable
{
    private readonly ScriptedComputer _computer = new();
    private readonly HealthRig _rig;

    public ComputerTests()
    {
        _rig = new HealthRig(new VirtualTime(1), new HealthOptions { Computer = _computer });
        _rig.PostAddress();
        _rig.PostMission(MissionPhase.Searching);
    }

    public void Dispose() => _rig.Dispose();

    [Fact]
    public void Computer_KnowsNothing_IsNoReason()
    {
        _rig.Fly(20);
        Assert.Equal(HealthReasons.None, _rig.Report.Reasons);
    }

    [Theory]
    [InlineData(74.9, HealthReasons.None, HealthAdvice.None, null)]
    [InlineData(75, HealthReasons.ComputerHot, HealthAdvice.None, "computer hot (75 degrees Celsius)")]
    [InlineData(83.9, HealthReasons.ComputerHot, HealthAdvice.None, "computer hot (83 degrees Celsius)")]
    [InlineData(84, HealthReasons.ComputerHot, HealthAdvice.ReturnToLaunch, "computer hot (84 degrees Celsius)")]
    public void Temperature_AboveALimitForFiveSeconds_IsAReason(
        double celsius, HealthReasons reasons, HealthAdvice advice, string? text)
    {
        Set((ref ComputerStatus s) => s.TemperatureCelsius = celsius);
        _rig.Fly(4);
        Assert.Equal(HealthReasons.None, _rig.Report.Reasons);
        _rig.Fly(4);
        Assert.Equal((reasons, advice, text), (_rig.Report.Reasons, _rig.Report.Advice, _rig.Report.Text));
        Set((ref ComputerStatus s) => s.TemperatureCelsius = 71);
        _rig.Fly(20);
        Assert.Equal(reasons, _rig.Report.Reasons);
        Set((ref ComputerStatus s) => s.TemperatureCelsius = 69);
        _rig.Fly(3);
        Assert.Equal(HealthReasons.None, _rig.Report.Reasons);
    }

    [Fact]
    public void Throttling_Now_IsAReasonAndSinceTheStartIsNot()
    {
        Set((ref ComputerStatus s) => s.Throttling = ComputerThrottling.UnderVoltageOccurred);
        _rig.Fly(5);
        Assert.Equal(HealthReasons.None, _rig.Report.Reasons);
        Set((ref ComputerStatus s) => s.Throttling = ComputerThrottling.UnderVoltage | ComputerThrottling.Throttled);
        _rig.Fly(2);
        Assert.Equal("computer throttled (under-voltage, clock lowered)", _rig.Report.Text);
        Set((ref ComputerStatus s) => s.Throttling = ComputerThrottling.UnderVoltageOccurred);
        _rig.Fly(9);
        Assert.Equal(HealthReasons.ComputerThrottled, _rig.Report.Reasons);
        _rig.Fly(4);
        Assert.Equal(HealthReasons.None, _rig.Report.Reasons);
    }

    [Fact]
    public void MemoryAndDisk_Low_AreWarningsOnly()
    {
        Set((ref ComputerStatus s) =>
        {
            (s.MemoryTotalBytes, s.MemoryUsedBytes) = (1000, 870);
            (s.DiskTotalBytes, s.DiskFreeBytes) = (32_000_000_000, 950_000_000);
        });
        _rig.Fly(8);
        Assert.Equal(
            (HealthLevel.Warning, HealthAdvice.None, "memory low (87 % used); disk nearly full (900 MB free)"),
            (_rig.Report.Level, _rig.Report.Advice, _rig.Report.Text));
    }

    [Fact]
    public void Disk_NearlyFullBeforeTheFlight_FailsTheChecklist()
    {
        Set((ref ComputerStatus s) => s.DiskFreeBytes = 5);
        using var rig = new HealthRig(
            new VirtualTime(1), new HealthOptions { Computer = _computer, Preflight = new PreflightOptions() });
        rig.Fly(3);
        PreflightLine line = rig.Preflight.Lines.Single(l => l.Name == "disk");
        Assert.Equal((PreflightResult.Fail, "0 MB free"), (line.Result, line.Value));
    }

    // A disk that hangs holds up the look at it.
    [Fact]
    public void Figures_OutOfDate_AreUnknown()
    {
        Set((ref ComputerStatus s) => s.DiskFreeBytes = 5);
        _rig.Fly(3);
        Assert.Equal(HealthReasons.DiskLow, _rig.Report.Reasons);
        _computer.Hangs = true;
        _rig.Fly(8);
        Assert.Equal(HealthReasons.None, _rig.Report.Reasons);
        OnboardComputerStatus last = Last(_rig.Sink.MessagesOf<OnboardComputerStatus>());
        Assert.Equal(uint.MaxValue, last.StorageTotal[0]);
    }

    [Fact]
    public void Message_OnceASecond_HasTheFiguresInTheUnitsOfTheWire()
    {
        Set((ref ComputerStatus s) =>
        {
            s.Uptime = TimeSpan.FromSeconds(100);
            s.TemperatureCelsius = 61.6;
            (s.MemoryTotalBytes, s.MemoryUsedBytes) = (8L << 30, 3L << 30);
            (s.DiskTotalBytes, s.DiskFreeBytes) = (32L << 30, 100L << 20);
            s.Throttling = ComputerThrottling.UnderVoltage | ComputerThrottling.SoftTemperatureLimit;
        });
        _rig.Fly(10);

        (TimeSpan Time, Mavlink.MavlinkFrame Frame)[] sent = _rig.Sink.Frames
            .Where(f => f.Frame.MessageId == OnboardComputerStatus.MavlinkId).ToArray();
        Assert.InRange(sent.Length, 9, 11);
        Assert.Equal((1, 191), (sent[0].Frame.SystemId, sent[0].Frame.ComponentId));
        OnboardComputerStatus message = OutgoingSink.Decode<OnboardComputerStatus>(sent.Last().Frame);
        Assert.Equal((100_000_000UL, 100_000u, (byte)0), (message.TimeUsec, message.Uptime, message.Type));
        Assert.Equal(
            (62, 127, 127), (message.TemperatureCore[0], message.TemperatureCore[1], message.TemperatureBoard));
        Assert.Equal((3072u, 8192u), (message.RamUsage, message.RamTotal));
        Assert.Equal(
            (32u * 1024 - 100, 32u * 1024, uint.MaxValue),
            (message.StorageUsage[0], message.StorageTotal[0], message.StorageTotal[1]));
        Assert.Equal((10u, uint.MaxValue, uint.MaxValue),
            (message.LinkType[0], message.LinkType[1], message.LinkTxRate[0]));
        Assert.Equal(
            ComputerStatusFlags.UnderVoltage | ComputerStatusFlags.ThermalThrottle | ComputerStatusFlags.DiskFull,
            message.StatusFlags);
    }

    [Fact]
    public void Message_NothingKnown_HasTheValuesOfUnknown()
    {
        _rig.Fly(3);
        OnboardComputerStatus message = Last(_rig.Sink.MessagesOf<OnboardComputerStatus>());
        Assert.Equal((255, 255, 255, 255),
            (message.CpuCores[0], message.CpuCombined[9], message.GpuCores[3], message.GpuCombined[9]));
        Assert.Equal((127, 127, short.MaxValue),
            (message.TemperatureBoard, message.TemperatureCore[7], message.FanSpeed[3]));
        Assert.Equal((uint.MaxValue, uint.MaxValue, uint.MaxValue),
            (message.RamUsage, message.RamTotal, message.StorageType[0]));
        Assert.Equal(default, message.StatusFlags);
    }

    private static OnboardComputerStatus Last(IReadOnlyList<OnboardComputerStatus> sent) => sent[sent.Count - 1];

    private delegate void Change(ref ComputerStatus status);

    private void Set(Change change)
    {
        ComputerStatus status = _computer.Status;
        change(ref status);
        _computer.Status = status;
    }
}
