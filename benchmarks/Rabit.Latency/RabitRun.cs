using System;
using System.Linq;
using Rabit.Core;

namespace Rabit.Latency;

/// <summary>Reactors that are measured.</summary>
internal static class RabitRun
{
    public static string NameOf(WaitEngine engine)
        => engine == WaitEngine.Futex ? "Rabit, futex engine" : "Rabit, event engine";

    // A run that is starved beside much other work is no run that does not end.
    private static readonly TimeSpan StopTimeLimit = TimeSpan.FromMinutes(2);

    public static RabitReactor Create(WaitEngine engine, bool keepsStatistics = true) => new(new ReactorOptions
    {
        StopTimeout = StopTimeLimit,
        TotalStopTimeout = StopTimeLimit,
        Time = new RealTime { WaitEngine = engine },
        StopsOnSignals = false,
        KeepsStatistics = keepsStatistics,
        Log = entry =>
        {
            // A futex engine that is an event after all would be measured under the wrong name.
            if (entry.Source == "wait engine")
                throw new NotSupportedException(entry.Text);
            if (entry.Kind == RabitLogKind.Fault)
                Console.Error.WriteLine(entry);
        },
    });

    /// <summary>Stops a reactor; one that did not end well must not be measured.</summary>
    public static void End(RabitReactor reactor)
    {
        reactor.Stop();
        ReactorResult result = reactor.Finish();
        if (result.ExitCode != 0 || result.Managers.Any(m => m.Outcome != ManagerOutcome.Ended))
            throw new InvalidOperationException("A reactor did not end well: " + result);
    }
}
