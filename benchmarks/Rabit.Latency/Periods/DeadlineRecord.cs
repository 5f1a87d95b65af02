using System;
using System.Linq;
using Rabit.Latency.Measuring;

namespace Rabit.Latency.Periods;

/// <summary>When a periodic thread ran: its grid begins with the first run.</summary>
internal sealed class DeadlineRecord(long periodNanoseconds, int samples)
{
    // What a run may come too early by the clocks' rounding and still be one for its deadline.
    private const long Tolerance = 2000;

    private readonly long[] _times = new long[samples];
    private long _last;   // the number of the deadline that a thread without Rabit waited for

    public int Count { get; private set; }

    /// <summary>Deadlines that had no run of their own, as the periodic thread itself counts them.</summary>
    public long Missed { get; set; }

    public bool IsFull => Count == _times.Length;

    /// <summary>Called at the beginning of each run, the first one included.</summary>
    public void Add(long now) => _times[Count++] = now;

    /// <summary>
    /// When a thread without Rabit is to run next: the first deadline that has not passed. Those in between are missed.
    /// </summary>
    public long NextDeadline(long now)
    {
        long next = ((now - _times[0]) / periodNanoseconds) + 1;
        Missed += next - _last - 1;
        _last = next;
        return _times[0] + (next * periodNanoseconds);
    }

    /// <returns>
    /// p50 and p99 of the lateness in microseconds, without the first run, and the part of the deadlines that had a run
    /// in per cent.
    /// </returns>
    public double[] Lateness()
    {
        var histogram = new LatencyHistogram();
        for (int i = 1; i < Count; i++)
            histogram.Record(((_times[i] - _times[0] + Tolerance) % periodNanoseconds) - Tolerance);
        return [histogram.Percentile(0.5) / 1e3, histogram.Percentile(0.99) / 1e3, 100.0 * Count / (Count + Missed)];
    }

    /// <summary>
    /// By how much the mean period was wrong, in parts per million, from the medians of the first tenth and of the last
    /// one.
    /// </summary>
    public double Drift()
    {
        int tenth = Math.Max(1, Count / 10);
        double late = MedianLate(Count - tenth, tenth) - MedianLate(0, tenth) - (Missed * (double)periodNanoseconds);
        return late / ((Count - tenth) * (double)periodNanoseconds) * 1e6;
    }

    private double MedianLate(int from, int count)
    {
        long[] sorted = [.. Enumerable.Range(from, count).Select(i => _times[i] - _times[0] - (i * periodNanoseconds))
            .OrderBy(late => late)];
        return sorted[count / 2];
    }
}
