using System;
using System.Collections.Generic;
using System.Diagnostics.Metrics;
using System.Linq;

namespace Rabit.Core.Diagnostics;

/// <summary>
/// The meter "Rabit.Core" of one run: the figures of the statuses, for dotnet-counters and OpenTelemetry. All
/// instruments are observable: they cost nothing until they are collected, on the collecting thread.
/// </summary>
internal sealed class ManagerMeter : IDisposable
{
    private const string MeterName = "Rabit.Core";

    private readonly IReadOnlyList<string> _managers;
    private readonly Func<ManagerStatus[]> _read;
    private readonly Meter _meter;

    public ManagerMeter(string run, IReadOnlyList<string> managers, Func<ManagerStatus[]> read)
    {
        _managers = managers;
        _read = read;
        _meter = new Meter(new MeterOptions(MeterName)
        {
            Tags = new KeyValuePair<string, object?>[] { new("rabit.run", run) },
            Scope = this,
        });
        Gauge(
            "rabit.manager.state", "Where the manager is in its life, as a number of ManagerState.", s => (int)s.State);
        Counter("rabit.manager.runs", "{run}", "Units of work.", s => s.Runs);
        Counter(
            "rabit.manager.merged_wakeups", "{wakeup}", "Wake-ups that merged with one that waited.",
            s => s.WakeUps.Merged);
        Counter(
            "rabit.manager.missed_deadlines", "{deadline}",
            "Deadlines of a period that passed before their unit of work began.", s => s.MissedDeadlines);
        Counter("rabit.manager.faults", "{fault}", "Exceptions that left the manager's code.", s => s.Faults);
        Counter("rabit.manager.restarts", "{restart}", "Start-ups after a fault.", s => s.Restarts);
        Counter("rabit.manager.hangs", "{hang}", "Times the watchdog found the manager hanging.", s => s.Hangs);
        _meter.CreateObservableCounter(
            "rabit.manager.wakeups", ObserveCauses, "{run}", "Units of work by what woke the manager.");
        Percentiles("rabit.manager.unit_of_work.duration", "How long units of work take.", s => s.UnitOfWorkTime);
        Percentiles("rabit.manager.wake.latency", "From the wake-up to the unit of work.", s => s.WakeLatency);
        Percentiles(
            "rabit.manager.period.error", "How late after its deadline a periodic unit of work begins.",
            s => s.PeriodError);
    }

    public void Dispose() => _meter.Dispose();

    private void Counter(string name, string unit, string description, Func<ManagerStatus, long> value)
        => _meter.CreateObservableCounter(name, () => Observe(value), unit, description);

    private void Gauge(string name, string description, Func<ManagerStatus, long> value)
        => _meter.CreateObservableGauge(name, () => Observe(value), unit: null, description);

    private void Percentiles(string name, string description, Func<ManagerStatus, DurationStatistics> value)
        => _meter.CreateObservableGauge(name, () => ObservePercentiles(value), "s", description);

    private Measurement<long>[] Observe(Func<ManagerStatus, long> value)
        => _read().Select((status, i) => new Measurement<long>(value(status), Manager(i))).ToArray();

    private Measurement<long>[] ObserveCauses() => _read().SelectMany(CausesOf).ToArray();

    private IEnumerable<Measurement<long>> CausesOf(ManagerStatus status, int i)
    {
        WakeUpStatistics counts = status.WakeUps;
        yield return Of(WakeUpCauses.Timer, counts.Timer);
        yield return Of(WakeUpCauses.Post, counts.Post);
        yield return Of(WakeUpCauses.Push, counts.Push);
        yield return Of(WakeUpCauses.Pop, counts.Pop);
        yield return Of(WakeUpCauses.Request, counts.Request);
        yield return Of(WakeUpCauses.Device, counts.Device);

        Measurement<long> Of(WakeUpCauses cause, long count) => new(count, Manager(i), new("cause", cause.ToString()));
    }

    private Measurement<double>[] ObservePercentiles(Func<ManagerStatus, DurationStatistics> value)
        => _read().SelectMany((status, i) => PercentilesOf(value(status), i)).ToArray();

    private IEnumerable<Measurement<double>> PercentilesOf(DurationStatistics times, int i)
    {
        yield return Of("0.5", times.Percentile50);
        yield return Of("0.99", times.Percentile99);
        yield return Of("0.999", times.Percentile999);
        yield return Of("1", times.Max);

        Measurement<double> Of(string quantile, TimeSpan time)
            => new(time.TotalSeconds, Manager(i), new("quantile", quantile));
    }

    private KeyValuePair<string, object?> Manager(int i) => new("manager", _managers[i]);
}
