using System;
using Rabit.Core;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>
/// The computer that this runs on, by the files of Linux, once a second, on a reader's thread: a disk that hangs holds
/// up these figures, which then are out of date, and nothing else. On another system everything but the disk is
/// unknown.
/// </summary>
/// <param name="directory">Where logs and pictures are written.</param>
/// <param name="root">Where /proc and /sys are; empty but in tests.</param>
internal sealed class LinuxComputer(string directory, string root = "") : IReaderSource<ComputerStatus>, IDisposable
{
    private static readonly TimeSpan Period = TimeSpan.FromSeconds(1);

    // A processor that works is warmer than the coldest and cooler than the hottest that any is rated for.
    private const double MinCelsius = -55;
    private const double MaxCelsius = 150;

    private const long Kibi = 1024;
    private const ComputerThrottling KnownBits = (ComputerThrottling)0xF000F;

    private readonly KernelFile _temperature = new(root + "/sys/class/thermal/thermal_zone0/temp");
    private readonly KernelFile _throttled = new(root + "/sys/devices/platform/soc/soc:firmware/get_throttled");
    private readonly KernelFile _memory = new(root + "/proc/meminfo");
    private readonly KernelFile _stat = new(root + "/proc/stat");
    private readonly KernelFile _uptime = new(root + "/proc/uptime");
    private readonly CpuLoads _loads = new();
    private readonly DataDisk _disk = new(directory);
    private ReaderContext _context = null!; // given by Open
    private TimeSpan _due;

    public bool Blocks => true;

    public void Open(ReaderContext context) => _context = context;

    public ReaderStep Read(out ComputerStatus value)
    {
        value = default;
        TimeSpan now = _context.Now;
        if (now < _due)
            return ReaderStep.WaitUntil(_due);
        _due = now + Period;
        value = Look(now);
        return ReaderStep.Value;
    }

    /// <summary>One look at everything.</summary>
    public ComputerStatus Look(TimeSpan now)
    {
        ComputerStatus status = ComputerStatus.Unknown;
        status.Time = now;
        status.TemperatureCelsius = Temperature();
        status.CpuLoad = _loads.Update(_stat.Read(), out ByteArray8 cores);
        status.CoreLoads = cores;
        status.Uptime = KernelText.Number(_uptime.Read()) is { } seconds and >= 0 and < int.MaxValue
            ? TimeSpan.OfSeconds(seconds)
            : null;
        status.Throttling = Throttling();
        if (Memory() is { } memory)
            (status.MemoryUsedBytes, status.MemoryTotalBytes) = (memory.Used, memory.Total);
        if (_disk.Read() is { } disk)
            (status.DiskFreeBytes, status.DiskTotalBytes) = (disk.Free, disk.Total);
        return status;
    }

    /// <summary>A look is short, or waits for a disk: nothing ends that wait.</summary>
    public void Unblock()
    {
    }

    public void Close() => Dispose();

    public void Dispose()
    {
        foreach (KernelFile file in new[] { _temperature, _throttled, _memory, _stat, _uptime })
            file.Dispose();
    }

    // In thousandths of a degree.
    private double Temperature()
        => KernelText.Number(_temperature.Read()) / 1000.0 is { } celsius and >= MinCelsius and <= MaxCelsius
            ? celsius
            : double.NaN;

    private ComputerThrottling? Throttling()
        => KernelText.HexNumber(_throttled.Read()) is { } bits && (bits & ~(long)KnownBits) == 0
            ? (ComputerThrottling)bits
            : null;

    private (long Used, long Total)? Memory()
    {
        ReadOnlySpan<byte> text = _memory.Read();
        return KernelText.NumberAfter(text, "MemTotal:"u8) is { } total and > 0
            && KernelText.NumberAfter(text, "MemAvailable:"u8) is { } available and >= 0 && available <= total
            && total < long.MaxValue / Kibi
                ? ((total - available) * Kibi, total * Kibi)
                : null;
    }
}
