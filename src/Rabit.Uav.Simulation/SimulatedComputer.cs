using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The companion computer of a simulated flight, looked at once a second: well, but for what the script says. Made by
/// <see cref="SimulatedWorld.CreateComputer"/>, for <see cref="UavOptions.Computer"/>.
/// </summary>
public sealed class SimulatedComputer : IReaderSource<ComputerStatus>
{
    private static readonly TimeSpan Period = TimeSpan.FromSeconds(1);

    private const double Celsius = 55;
    private const long MemoryTotal = 4L << 30;
    private const long DiskTotal = 32_000_000_000;
    private const long DiskFree = 20_000_000_000;
    private const byte CorePercent = 40;

    private readonly FaultScript _script;
    private ReaderContext? _context;
    private TimeSpan _due;

    internal SimulatedComputer(IReadOnlyList<ScriptedFault> faults) => _script = new FaultScript(faults);

    /// <inheritdoc/>
    public bool Blocks => false;

    /// <inheritdoc/>
    public void Open(ReaderContext context) => _context = context ?? throw new ArgumentNullException(nameof(context));

    /// <inheritdoc/>
    public ReaderStep Read(out ComputerStatus value)
    {
        value = default;
        if (_context is not { } context)
            return ReaderStep.Ended;
        TimeSpan now = context.Now;
        if (now < _due)
            return ReaderStep.WaitUntil(_due);
        _due = now + Period;
        value = At(now);
        return ReaderStep.Value;
    }

    /// <inheritdoc/>
    public void Unblock()
    {
    }

    /// <inheritdoc/>
    public void Close()
    {
    }

    private ComputerStatus At(TimeSpan now)
    {
        var cores = default(ByteArray8);
        for (int core = 0; core < cores.Length; core++)
            cores[core] = core < 4 ? CorePercent : byte.MaxValue;
        return new ComputerStatus
        {
            Time = now,
            Uptime = now,
            TemperatureCelsius = _script.ValueOf(ScriptedFaultKind.ComputerHot, now) ?? Celsius,
            CpuLoad = CorePercent / 100.0,
            CoreLoads = cores,
            MemoryTotalBytes = MemoryTotal,
            MemoryUsedBytes = MemoryTotal / 3,
            DiskTotalBytes = DiskTotal,
            DiskFreeBytes = (long?)_script.ValueOf(ScriptedFaultKind.DiskLow, now) ?? DiskFree,
            Throttling = _script.IsOn(ScriptedFaultKind.ComputerUnderVoltage, now)
                ? ComputerThrottling.UnderVoltage | ComputerThrottling.UnderVoltageOccurred
                : ComputerThrottling.None,
        };
    }
}
