using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>The load of the processor between two looks at /proc/stat.</summary>
internal sealed class CpuLoads
{
    private const int MaxCores = 8;

    // The first is all of them together; each line counts the time since the start in ten columns.
    private readonly (long Busy, long Total)[] _last = new (long, long)[MaxCores + 1];

    /// <summary>Load since the last look: of all cores, 0 to 1 or NaN, and of each, per cent or 255.</summary>
    public double Update(ReadOnlySpan<byte> stat, out ByteArray8 cores)
    {
        cores = ComputerStatus.NoCores;
        double all = double.NaN;
        while (KernelText.TakeLine(ref stat, out ReadOnlySpan<byte> line) && line.StartsWith("cpu"u8))
        {
            line = line.Slice(3);
            bool isCore = line.Length > 0 && line[0] != ' ';
            long core = -1;
            if (isCore && !KernelText.TakeNumber(ref line, out core))
                break;
            if (core >= MaxCores)
                continue;
            double load = Load((int)core + 1, Times(line));
            if (!isCore)
                all = load;
            else if (!double.IsNaN(load))
                cores[(int)core] = (byte)Math.Round(load * 100);
        }

        return all;
    }

    // user nice system idle iowait irq softirq steal guest guest_nice; the last two are in the first two already.
    private static (long Busy, long Total) Times(ReadOnlySpan<byte> line)
    {
        (long busy, long total) = (0, 0);
        for (int column = 0; column < 8 && KernelText.TakeNumber(ref line, out long ticks); column++)
        {
            total += ticks;
            busy += column is 3 or 4 ? 0 : ticks;
        }

        return (busy, total);
    }

    // The time of iowait may go back (man 5 proc): then there is none for this look.
    private double Load(int index, (long Busy, long Total) now)
    {
        (long busy, long total) = (now.Busy - _last[index].Busy, now.Total - _last[index].Total);
        bool isFirst = _last[index].Total == 0;
        _last[index] = now;
        return !isFirst && total > 0 && busy >= 0 && busy <= total ? (double)busy / total : double.NaN;
    }
}
