using System;
using System.Collections.Generic;
using System.Diagnostics.Tracing;
using System.Globalization;
using System.Linq;
using Rabit.Core.Tests.Contracts;
using Xunit;

namespace Rabit.Core.Tests.Diagnostics;

/// <summary>
/// Contract 4.4: what a listener in the process, dotnet-trace or PerfView sees of a run. Mono 6.8 hands no events to
/// listeners.
/// </summary>
public sealed class EventSourceTests
{
    [Fact, Trait("Clause", "4.4")]
    public void Listener_ToRabitCore_SeesTheLogAndEveryUnitOfWork()
    {
        // Other tests run beside this one, and an event source serves the whole process: the name distinguishes them.
        string name = "seen-" + Guid.NewGuid().ToString("N");
        using var listener = new Listener(name);
        using var run = new TestRun(TimeKind.Virtual);
        ScriptedManager manager = run.Add(name);
        manager.FaultPolicy = FaultPolicy.CarryOn;
        manager.OnUnit = () => throw new InvalidOperationException("boom");

        run.Start();
        run.Reactor.RunFor(TimeSpan.FromMilliseconds(15));
        run.Finish();

        Assert.Equal(
            2, listener.Events.Count(e => e.StartsWith("Fault ", StringComparison.Ordinal) && e.Contains("boom")));
        Assert.Contains(listener.Events, e => e.StartsWith("Lifecycle ", StringComparison.Ordinal));
        Assert.Equal(2, listener.Events.Count(e => e.StartsWith("UnitOfWork ", StringComparison.Ordinal)));
        Assert.Contains(listener.Events, e => e == $"UnitOfWork {name} 0 0");
    }

    [Fact, Trait("Clause", "4.4")]
    public void UnitOfWork_ThatTakesTime_ReportsItsDurationAndTheWakeLatency()
    {
        string name = "long-" + Guid.NewGuid().ToString("N");
        using var listener = new Listener(name);
        using var run = new TestRun(
            TimeKind.Virtual,
            o => ((VirtualTime)o.Time).SetUnitOfWorkDuration(name, TimeSpan.FromMilliseconds(5)));
        ScriptedManager manager = run.Add(name);
        ScriptedManager waker = run.Add("waker");
        waker.WakeUpDelay = TimeSpan.FromMilliseconds(2);
        waker.OnUnit = () =>
        {
            if (waker.Units is 2 or 7)
                manager.WakeUp();
        };

        run.Start();
        run.Reactor.RunFor(TimeSpan.FromMilliseconds(20));
        run.Finish();

        // Woken at 2 ms, while its first unit of work takes until 5: no latency. And at 12, while it sleeps.
        Assert.Equal(
            [$"UnitOfWork {name} 5000 0", $"UnitOfWork {name} 5000 -1", $"UnitOfWork {name} 5000 0"],
            listener.Events.Where(e => e.StartsWith("UnitOfWork ", StringComparison.Ordinal)).ToArray());
    }

    private sealed class Listener(string name) : EventListener
    {
        private readonly List<string> _events = [];   // guarded by itself

        public IReadOnlyList<string> Events
        {
            get
            {
                lock (_events)
                    return _events.ToArray();
            }
        }

        protected override void OnEventSourceCreated(EventSource eventSource)
        {
            if (eventSource.Name == "Rabit-Core")
                EnableEvents(eventSource, EventLevel.Verbose);
        }

        protected override void OnEventWritten(EventWrittenEventArgs eventData)
        {
            // The base class calls this before the constructor has ended.
            if (name is null || eventData.Payload is null || !name.Equals(eventData.Payload[0]))
                return;
            lock (_events)
                _events.Add(
                    eventData.EventName + " "
                        + string.Join(
                            " ", eventData.Payload.Select(p => Convert.ToString(p, CultureInfo.InvariantCulture))));
        }
    }
}
