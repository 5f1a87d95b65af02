using System;
using Rabit.Core.Time;

namespace Rabit.Core.Statistics;

/// <summary>
/// Keeps the figures of a status: the simple ones with every unit of work, the percentiles, which take a look at a
/// whole histogram, once a second and when the manager ends. The manager's thread only.
/// </summary>
internal sealed class ManagerStatistics
{
    private static readonly TimeSpan PercentilesEvery = TimeSpan.FromSeconds(1);

    private readonly DurationHistogram _unitOfWork = new();
    private readonly DurationHistogram _wakeLatency = new();
    private readonly DurationHistogram _periodError = new();
    private TimeSpan _nextPercentiles;   // at once at first

    public void Reset(ref ManagerStatus status)
    {
        _unitOfWork.Clear();
        _wakeLatency.Clear();
        _periodError.Clear();
        _nextPercentiles = TimeSpan.Zero;
        status = new ManagerStatus
        {
            Faults = status.Faults,
            LastFault = status.LastFault,
            Restarts = status.Restarts,
            Hangs = status.Hangs,
            LastHang = status.LastHang,
        };
    }

    public void CountRun(ref ManagerStatus status, TimeSpan begin, TimeSpan end, TimeSpan? wokenAt, TimeSpan? deadline)
    {
        Add(end - begin, _unitOfWork, ref status._unitOfWorkTime);
        if (wokenAt is { } at)
            Add(begin - at, _wakeLatency, ref status._wakeLatency);
        if (deadline is { } due)
            Add(begin - due, _periodError, ref status._periodError);
        if (end >= _nextPercentiles)
        {
            _nextPercentiles = Times.Later(end, PercentilesEvery);
            FillPercentiles(ref status);
        }
    }

    public void FillPercentiles(ref ManagerStatus status)
    {
        status._unitOfWorkTime.TakePercentiles(_unitOfWork);
        status._wakeLatency.TakePercentiles(_wakeLatency);
        status._periodError.TakePercentiles(_periodError);
    }

    private static void Add(TimeSpan duration, DurationHistogram histogram, ref DurationStatistics statistics)
    {
        histogram.Add(duration);
        statistics.Add(duration);
    }
}
