using System;
using System.Collections.Generic;
using System.Diagnostics.Metrics;
using System.Linq;
using System.Text;
using Rabit.Core;
using Xunit;

namespace Rabit.Documentation.Tests;

/// <summary>docs/concepts/hosting.md has the meter and its instruments as the library makes them.</summary>
public sealed class MeterPageTests
{
    [Fact]
    public void Table_OfTheInstruments_IsThatOfTheMeter()
        => GeneratedBlock.AssertUpToDate("docs/concepts/hosting.md", "instruments", Render());

    private static string Render()
    {
        var instruments = new List<Instrument>();
        var tags = new Dictionary<string, string>(StringComparer.Ordinal);
        using var listener = new MeterListener
        {
            InstrumentPublished = (instrument, l) =>
            {
                if (instrument.Meter.Name != "Rabit.Core" || !IsOfOurRun(instrument.Meter))
                    return;
                instruments.Add(instrument);
                l.EnableMeasurementEvents(instrument);
            },
        };
        listener.SetMeasurementEventCallback<long>((instrument, _, of, _) => tags[instrument.Name] = NamesOf(of));
        listener.SetMeasurementEventCallback<double>((instrument, _, of, _) => tags[instrument.Name] = NamesOf(of));
        listener.Start();

        using var reactor = new RabitReactor(
            new ReactorOptions { Name = RunName, Time = new VirtualTime(seed: 1), Log = _ => { } }) { new Idle() };
        reactor.Start();
        reactor.RunFor(TimeSpan.FromSeconds(1));
        listener.RecordObservableInstruments();
        reactor.Stop();
        reactor.Finish();

        var text = new StringBuilder("| instrument | kind | unit | tags | is |\n|---|---|---|---|---|\n");
        foreach (Instrument i in instruments.OrderBy(i => i.Name, StringComparer.Ordinal))
            text.Append($"| `{i.Name}` | {KindOf(i)} | {i.Unit} | {tags[i.Name]} | {i.Description} |\n");
        return text.ToString();
    }

    private const string RunName = "documented";

    private static bool IsOfOurRun(Meter meter)
        => meter.Tags!.Any(t => t.Key == "rabit.run" && RunName.Equals(t.Value));

    private static string NamesOf(ReadOnlySpan<KeyValuePair<string, object?>> tags)
        => string.Join(", ", tags.ToArray().Select(t => $"`{t.Key}`"));

    private static string KindOf(Instrument instrument)
        => instrument.GetType().Name.Split('`')[0] switch
        {
            "ObservableCounter" => "counter",
            "ObservableGauge" => "gauge",
            var other => other,
        };

    private sealed class Idle : RabitManager
    {
        public Idle()
            : base("idle")
            => Period = TimeSpan.FromSeconds(0.1);

        protected override void ExecuteUnitOfWork()
        {
        }
    }
}
