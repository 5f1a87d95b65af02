using System;
using System.IO;
using Rabit.Tests.Shared;
using Rabit.Uav.HealthMonitoring;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.HealthMonitoring;

/// <summary>The files of Linux, in a directory of the test's.</summary>
public sealed class LinuxComputerTests : IDisposable
{
    private const string Throttled = "sys/devices/platform/soc/soc:firmware/get_throttled";
    private const string Temperature = "sys/class/thermal/thermal_zone0/temp";

    private readonly string _root = Path.Combine(Path.GetTempPath(), "rabit-computer-" + Guid.NewGuid().ToString("N"));
    private readonly LinuxComputer _computer;

    public LinuxComputerTests()
    {
        Directory.CreateDirectory(_root);
        _computer = new LinuxComputer(_root, _root);
    }

    public void Dispose()
    {
        _computer.Dispose();
        Directory.Delete(_root, recursive: true);
    }

    [Fact]
    public void Look_NoFiles_IsUnknown()
    {
        ComputerStatus status = Look();

        Assert.True(double.IsNaN(status.TemperatureCelsius));
        Assert.True(double.IsNaN(status.CpuLoad));
        Assert.True(double.IsNaN(status.MemoryUsedFraction));
        Assert.Equal((255, 255), (status.CoreLoads[0], status.CoreLoads[7]));
        Assert.Equal((null, null, null), (status.MemoryTotalBytes, status.Throttling, status.Uptime));
    }

    [Fact]
    public void Look_RaspberryPi_HasItsFigures()
    {
        Write(Temperature, "61322\n");
        Write(Throttled, "50005\n");
        Write("proc/uptime", "3611.50 14000.00\n");
        Write("proc/meminfo", "MemTotal:        8000000 kB\nMemFree:  100 kB\nMemAvailable:    6000000 kB\n");
        Write("proc/stat", "cpu  100 0 100 800 0 0 0 0 0 0\ncpu0 50 0 50 400 0 0 0 0 0 0\nintr 1 2\n");
        Look();
        Write("proc/stat", "cpu  150 0 150 900 0 0 0 0 0 0\ncpu0 140 0 50 410 0 0 0 0 0 0\nintr 1 2\n");
        ComputerStatus status = Look();

        Assert.Equal(61.322, status.TemperatureCelsius, 6);
        Assert.Equal(
            ComputerThrottling.UnderVoltage | ComputerThrottling.Throttled
                | ComputerThrottling.UnderVoltageOccurred | ComputerThrottling.ThrottledOccurred,
            status.Throttling);
        Assert.Equal(0.25, status.MemoryUsedFraction, 9);
        Assert.Equal(0.5, status.CpuLoad, 9);
        Assert.Equal((90, 255), (status.CoreLoads[0], status.CoreLoads[1]));
        Assert.Equal(3611, status.Uptime?.TotalSeconds);
    }

    [Fact]
    public void Look_OwnDisk_HasRoomAndSize()
    {
        ComputerStatus status = Look();
        Assert.InRange(status.DiskFreeBytes ?? -1, 0, status.DiskTotalBytes ?? -2);
    }

    [Fact]
    public void Look_ThisComputer_KnowsWhatLinuxReports()
    {
        using var computer = new LinuxComputer(".");
        ComputerStatus status = computer.Look(TimeSpan.Zero);
        Assert.InRange(status.DiskFreeBytes ?? -1, 0, status.DiskTotalBytes ?? -2);
        if (!File.Exists("/proc/meminfo"))
            return;
        Assert.InRange(status.MemoryUsedFraction, 0.001, 1);
        Assert.True(status.Uptime > TimeSpan.Zero);
        for (int look = 0; look < 50 && double.IsNaN(status.CpuLoad); look++)
            status = computer.Look(TimeSpan.Zero);
        Assert.True(double.IsNaN(status.CpuLoad) || status.CpuLoad is >= 0 and <= 1);
    }

    // Once a second: the disk's figures are strings on their way.
    [Fact]
    public void Look_AgainAndAgain_HardlyAllocates()
    {
        Write("proc/meminfo", "MemTotal:        8000000 kB\nMemAvailable:    6000000 kB\n");
        Write("proc/stat", "cpu  100 0 100 800 0 0 0 0 0 0\ncpu0 50 0 50 400 0 0 0 0 0 0\n");
        Write(Temperature, "61322\n");
        Look();
        Assert.InRange(Allocated.By(() => Look()), 0, 4000);
    }

    [Theory]
    [InlineData("151000")]
    [InlineData("-60000")]
    [InlineData("n/a")]
    [InlineData("")]
    public void Look_TemperatureThatIsNone_IsUnknown(string text)
    {
        Write(Temperature, text);
        Assert.True(double.IsNaN(Look().TemperatureCelsius));
    }

    [Theory]
    [InlineData("0x5", 5)]
    [InlineData("0", 0)]
    [InlineData("F0000", 0xF0000)]
    [InlineData("80000000", null)]    // bits that are not defined
    [InlineData("xyz", null)]
    public void Look_Throttling_IsReadFromHex(string text, int? expected)
    {
        Write(Throttled, text);
        Assert.Equal((ComputerThrottling?)expected, Look().Throttling);
    }

    [Fact]
    public void Look_MemoryThatCannotBe_IsUnknown()
    {
        Write("proc/meminfo", "MemTotal: 100 kB\nMemAvailable: 200 kB\n");
        Assert.Null(Look().MemoryTotalBytes);
    }

    [Fact]
    public void Look_TimesThatGoBack_AreUnknownOnce()
    {
        Write("proc/stat", "cpu  100 0 100 800 0\n");
        Look();
        Write("proc/stat", "cpu  100 0 90 850 0\n");
        Assert.True(double.IsNaN(Look().CpuLoad));
        Write("proc/stat", "cpu  150 0 90 900 0\n");
        Assert.Equal(0.5, Look().CpuLoad, 9);
    }

    private ComputerStatus Look() => _computer.Look(TimeSpan.FromSeconds(1));

    private void Write(string file, string text)
    {
        string path = Path.Combine(_root, file);
        Directory.CreateDirectory(Path.GetDirectoryName(path)!);

        // Into the same file, as the kernel does, which is open already.
        using var stream = new FileStream(path, FileMode.OpenOrCreate, FileAccess.Write, FileShare.ReadWrite);
        stream.SetLength(0);
        byte[] bytes = System.Text.Encoding.ASCII.GetBytes(text);
        stream.Write(bytes, 0, bytes.Length);
    }
}
