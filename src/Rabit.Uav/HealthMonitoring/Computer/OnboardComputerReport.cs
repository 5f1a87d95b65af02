using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>
/// ONBOARD_COMPUTER_STATUS: the state of the computer, for the ground station. What is not known is as common.xml says:
/// the largest value of its type.
/// </summary>
internal static class OnboardComputerReport
{
    /// <summary>How many links the message has room for.</summary>
    public const int MaxLinks = 6;

    private const double BytesPerMebi = 1024 * 1024;

    // common.xml: 0 to 9 is a UART, 10 to 19 a wired network. Whether a network is wired is not known to a link.
    private const uint Uart = 0;
    private const uint Network = 10;

    public static OnboardComputerStatus Of(in ComputerStatus computer, TimeSpan now, HealthOptions options)
    {
        TimeSpan uptime = computer.Uptime ?? now;
        OnboardComputerStatus message = Unknown();
        message.TimeUsec = (ulong)(uptime.Ticks / 10);
        message.Uptime = unchecked((uint)(uptime.Ticks / TimeSpan.TicksPerMillisecond));
        message.CpuCores = computer.CoreLoads;
        if (!double.IsNaN(computer.TemperatureCelsius))
            message.TemperatureCore = With(message.TemperatureCore, computer.TemperatureCelsius);
        message.RamUsage = Mebi(computer.MemoryUsedBytes);
        message.RamTotal = Mebi(computer.MemoryTotalBytes);
        if (computer is { DiskFreeBytes: { } free, DiskTotalBytes: { } total })
        {
            message.StorageUsage = First(message.StorageUsage, Mebi(total - free));
            message.StorageTotal = First(message.StorageTotal, Mebi(total));
        }

        message.StatusFlags = FlagsOf(computer, options);
        return message;
    }

    /// <summary>Adds a link by its number and its URL.</summary>
    public static void AddLink(ref OnboardComputerStatus message, int number, string? url)
    {
        if (number >= MaxLinks || url is null)
            return;
        UInt32Array6 types = message.LinkType;
        types[number] = url.StartsWith("serial", StringComparison.Ordinal) ? Uart : Network;
        message.LinkType = types;
    }

    private static ComputerStatusFlags FlagsOf(in ComputerStatus computer, HealthOptions options)
    {
        ComputerThrottling throttling = computer.Throttling ?? ComputerThrottling.None;
        var flags = default(ComputerStatusFlags);
        if ((throttling & ComputerThrottling.UnderVoltage) != 0)
            flags |= ComputerStatusFlags.UnderVoltage;
        if ((throttling & (ComputerThrottling.Throttled | ComputerThrottling.FrequencyCapped)) != 0)
            flags |= ComputerStatusFlags.CpuThrottle;
        if ((throttling & ComputerThrottling.SoftTemperatureLimit) != 0)
            flags |= ComputerStatusFlags.ThermalThrottle;
        if (computer.DiskFreeBytes < options.DiskFullBytes)
            flags |= ComputerStatusFlags.DiskFull;
        return flags;
    }

    private static OnboardComputerStatus Unknown()
    {
        var message = default(OnboardComputerStatus);
        message.CpuCombined = Filled(message.CpuCombined);
        message.GpuCombined = Filled(message.GpuCombined);
        ByteArray4 gpu = message.GpuCores;
        Int16Array4 fans = message.FanSpeed;
        SByteArray8 cores = message.TemperatureCore;
        UInt32Array4 storage = message.StorageType;
        UInt32Array6 links = message.LinkType;
        for (int i = 0; i < 4; i++)
            (gpu[i], fans[i], storage[i]) = (byte.MaxValue, short.MaxValue, uint.MaxValue);
        for (int i = 0; i < cores.Length; i++)
            cores[i] = sbyte.MaxValue;
        for (int i = 0; i < MaxLinks; i++)
            links[i] = uint.MaxValue;
        (message.GpuCores, message.FanSpeed, message.TemperatureCore) = (gpu, fans, cores);
        (message.StorageType, message.StorageUsage, message.StorageTotal) = (storage, storage, storage);
        message.LinkType = message.LinkTxRate = message.LinkRxRate = message.LinkTxMax = message.LinkRxMax = links;
        (message.TemperatureBoard, message.RamUsage, message.RamTotal) =
            (sbyte.MaxValue, uint.MaxValue, uint.MaxValue);
        return message;
    }

    private static ByteArray10 Filled(ByteArray10 slices)
    {
        for (int i = 0; i < slices.Length; i++)
            slices[i] = byte.MaxValue;
        return slices;
    }

    private static SByteArray8 With(SByteArray8 cores, double celsius)
    {
        cores[0] = (sbyte)Math.Round(Math.Max(sbyte.MinValue, Math.Min(sbyte.MaxValue - 1, celsius)));
        return cores;
    }

    private static UInt32Array4 First(UInt32Array4 values, uint first)
    {
        values[0] = first;
        return values;
    }

    private static uint Mebi(long? bytes)
        => bytes is { } known ? (uint)Math.Min(uint.MaxValue - 1, Math.Round(known / BytesPerMebi)) : uint.MaxValue;
}
