using System;
using System.Collections.Generic;
using System.Diagnostics.Metrics;
using System.Linq;
using Rabit.Core.Tests.Contracts;
using Xunit;

namespace Rabit.Core.Tests.Diagnostics;

/// <summary>
/// Contract 4.4: what OpenTelemetry and dotnet-counters read, by the listener of the runtime that both use.
/// </summary>
public sealed class MeterTests
{
    [Fact, Trait("Clause", "4.4")]
    public void Meter_WhileARunLasts_ShowsTheFiguresOfEachManager()
    {
        const string Name = "meter-test";
        using var run = new TestRun(TimeKind.Virtual, options => options.Name = Name);
        ScriptedManager manager = run.Add("m");
        run.Add("other");
        manager.Period = TimeSpan.FromSeconds(1);
        manager.FaultPolicy = FaultPolicy.CarryOn;
        manager.OnUnit = () =>
        {
            if (manager.Units == 1)
                throw new InvalidOperationException("once");
        };
        var seen = new Dictionary<string, double>(StringComparer.Ordinal);
        using var listener = new MeterListener { InstrumentPublished = (instrument, l) => Enable(instrument, l, Name) };
        listener.SetMeasurementEventCallback<long>((instrument, value, tags, _) => seen[Key(instrument, tags)] = value);
        listener.SetMeasurementEventCallback<double>(
            (instrument, value, tags, _) => seen[Key(instrument, tags)] = value);

        run.Start();
        listener.Start();
        run.Reactor.RunFor(TimeSpan.FromSeconds(10));
        listener.RecordObservableInstruments();
        ManagerStatus status = run.StatusOf(manager);
        run.Finish();

        Assert.Equal(status.Runs, seen["rabit.manager.runs manager=m"]);
        Assert.Equal(1, seen["rabit.manager.runs manager=other"]);
        Assert.Equal(1, seen["rabit.manager.faults manager=m"]);
        Assert.Equal((double)ManagerState.Running, seen["rabit.manager.state manager=m"]);
        Assert.Equal(status.WakeUps.Timer, seen["rabit.manager.wakeups manager=m cause=Timer"]);
        Assert.Equal(
            status.UnitOfWorkTime.Percentile99.TotalSeconds,
            seen["rabit.manager.unit_of_work.duration manager=m quantile=0.99"]);
        Assert.Contains("rabit.manager.wake.latency manager=m quantile=1", seen.Keys);
        Assert.Contains("rabit.manager.period.error manager=m quantile=0.5", seen.Keys);

        // The meter ends with its run.
        seen.Clear();
        listener.RecordObservableInstruments();
        Assert.Empty(seen);
    }

    private static void Enable(Instrument instrument, MeterListener listener, string run)
    {
        if (instrument.Meter.Name == "Rabit.Core"
            && instrument.Meter.Tags!.Any(t => t.Key == "rabit.run" && run.Equals(t.Value)))
            listener.EnableMeasurementEvents(instrument);
    }

    private static string Key(Instrument instrument, ReadOnlySpan<KeyValuePair<string, object?>> tags)
        => instrument.Name + string.Concat(tags.ToArray().Select(t => $" {t.Key}={t.Value}"));
}
