using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Messages;

/// <summary>
/// How the companion computer is, by one look at it. A plain value; what it does not know of itself is NaN or null, and
/// never a fault. Read by <see cref="UavOptions.Computer"/> about once a second, and posted in
/// <see cref="HealthReport.Computer"/>.
/// </summary>
public struct ComputerStatus
{
    /// <summary>Everything unknown.</summary>
    public static ComputerStatus Unknown => new()
    {
        TemperatureCelsius = double.NaN,
        CpuLoad = double.NaN,
        CoreLoads = NoCores,
    };

    /// <summary>When it was read, by the clock of the run.</summary>
    public TimeSpan Time { get; set; }

    /// <summary>Since the computer was started; null where it is not known.</summary>
    public TimeSpan? Uptime { get; set; }

    /// <summary>Temperature of the processor, degrees Celsius; NaN where it is not known.</summary>
    public double TemperatureCelsius { get; set; }

    /// <summary>Load of all cores since the last look, 0 to 1; NaN where it is not known.</summary>
    public double CpuLoad { get; set; }

    /// <summary>Load of each of the first eight cores, per cent; 255 where there is none.</summary>
    public ByteArray8 CoreLoads { get; set; }

    /// <summary>Memory in use, bytes: all but what is free or can be freed at once; null where unknown.</summary>
    public long? MemoryUsedBytes { get; set; }

    /// <summary>Memory, bytes; null where it is not known.</summary>
    public long? MemoryTotalBytes { get; set; }

    /// <summary>Free space where logs and pictures are written, bytes; null where it is not known.</summary>
    public long? DiskFreeBytes { get; set; }

    /// <summary>Size of that disk, bytes; null where it is not known.</summary>
    public long? DiskTotalBytes { get; set; }

    /// <summary>
    /// What the firmware of a Raspberry Pi reports of its supply and its clock; null on other computers.
    /// </summary>
    public ComputerThrottling? Throttling { get; set; }

    /// <summary>Memory in use, 0 to 1; NaN where it is not known.</summary>
    public readonly double MemoryUsedFraction
        => MemoryUsedBytes is { } used && MemoryTotalBytes is { } total and > 0 ? (double)used / total : double.NaN;

    internal static ByteArray8 NoCores
    {
        get
        {
            var cores = default(ByteArray8);
            for (int core = 0; core < cores.Length; core++)
                cores[core] = byte.MaxValue;
            return cores;
        }
    }
}
