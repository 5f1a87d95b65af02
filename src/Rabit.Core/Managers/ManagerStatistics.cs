using System;

namespace Rabit.Core.Managers;

/// <summary>
/// Keeps the figures of a status: the simple ones with every unit of work, the percentiles, which take a look at a whole histogram, once a second
/// and when the manager ends. The manager's thread only.
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
        TimeSpan took = end - begin;
        _unitOfWork.Add(took);
        status.UnitOfWorkTime = status.UnitOfWorkTime.With(took);
        if (wokenAt is { } at)
        {
            _wakeLatency.Add(begin - at);
            status.WakeLatency = status.WakeLatency.With(begin - at);
        }

        if (deadline is { } due)
        {
            _periodError.Add(begin - due);
            status.PeriodError = status.PeriodError.With(begin - due);
        }

        if (end >= _nextPercentiles)
        {
            _nextPercentiles = Times.Later(end, PercentilesEvery);
            FillPercentiles(ref status);
        }
    }

    public void FillPercentiles(ref ManagerStatus status)
    {
        status.UnitOfWorkTime = status.UnitOfWorkTime.WithPercentilesOf(_unitOfWork);
        status.WakeLatency = status.WakeLatency.WithPercentilesOf(_wakeLatency);
        status.PeriodError = status.PeriodError.WithPercentilesOf(_periodError);
    }
}
