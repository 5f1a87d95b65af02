using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Diagnostics;
using Rabit.Core.Managers;
using Rabit.Core.Reactors;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Supervision;

/// <summary>
/// What watches the managers of a run: the watchdog, and whatever shows their statuses to the outside.
/// </summary>
internal sealed class ReactorSupervision : IDisposable
{
    private static readonly TimeSpan MinInterval = TimeSpan.FromMilliseconds(5);
    private static readonly TimeSpan MaxInterval = TimeSpan.FromSeconds(2);
    private static readonly TimeSpan WatchdogStopTimeout = TimeSpan.FromSeconds(1);

    private readonly IReadOnlyList<ManagerActivity> _managers;
    private readonly StatusEndpoint[] _statuses;
    private readonly WatchdogActivity? _watchdog;
    private readonly ManagerMeter _meter;

    private ReactorSupervision(
        ReactorOptions options, RabitWorkspace workspace, RunClock clock, IReadOnlyList<ManagerActivity> managers)
    {
        _managers = managers;
        _statuses = managers.Select(m => workspace.StatusEndpointOf(m.Name, m.Hangs.InheritsPriority)).ToArray();
        _meter = new ManagerMeter(options.Name, managers.Select(m => m.Name).ToArray(), ReadStatuses);
        if (options.Time is VirtualTime modelled)
        {
            // A watchdog without anything to watch would still be dispatched.
            if (managers.Any(
                m => modelled.MaxUnitOfWorkDuration(m.Name) > m.Hangs.Policy.LimitOf(ManagerStage.UnitOfWork)))
                _watchdog = new WatchdogActivity(managers, _statuses, clock, TimeSpan.MaxValue, hasThreads: false);
            WatchdogWakeUp = _watchdog?.WakeUp;
            return;
        }

        TimeSpan shortest = TimeSpan.MaxValue;
        foreach (ManagerActivity manager in managers)
            shortest = Times.Earlier(shortest, MinLimit(manager.Hangs.Policy));
        if (shortest < TimeSpan.MaxValue)
            _watchdog = new WatchdogActivity(managers, _statuses, clock, IntervalFor(shortest), hasThreads: true);
    }

    public static ReactorSupervision Create(
        ReactorOptions options, RabitWorkspace workspace, RunClock clock, IReadOnlyList<ManagerActivity> managers)
        => new(options, workspace, clock, managers);

    /// <summary>Wakes the watchdog of virtual time, if there is one.</summary>
    public WakeUpEvent? WatchdogWakeUp { get; }

    public ManagerStatus StatusOf(int manager) => _statuses[manager].Read();

    public string StatusTable() => ManagerTable.Format(_managers.Select((m, i) => Describe(m, _statuses[i].Read())));

    /// <summary>Before the first manager begins: start-ups are watched too.</summary>
    public void Begin(ReactorEngine engine)
    {
        if (_watchdog is null)
            return;
        engine.Begin(_watchdog);
        _watchdog.WakeUp.Wake(WakeUpCauses.Start);
    }

    /// <summary>After the last manager has ended: shutdowns are watched too.</summary>
    public void End(ReactorEngine engine, RabitLog log, TimeSpan now)
    {
        // It does not end while a callback of the user's does not return.
        if (_watchdog is not null
            && !engine.TryEnd(_watchdog, WatchdogStopTimeout, Times.Later(now, WatchdogStopTimeout)))
            log.Write(
                RabitLogKind.Note, _watchdog.Name,
                "did not stop: it is in the callback of a hang policy, or in a post handler of a status");
    }

    public void Dispose() => _meter.Dispose();

    // One that has not begun, was stopped, or waits for its restart, sleeps too: that would say too little.
    private static (string Name, string State, ManagerStatus Status) Describe(
        ManagerActivity manager, ManagerStatus status)
    {
        string doing = manager.Doing;
        bool isDown = status.State is ManagerState.Created
            or ManagerState.Stopped or ManagerState.Faulted or ManagerState.Restarting;
        return (manager.Name,
            isDown && doing == HangWatch.Sleeping ? status.State.ToString().ToLowerInvariant() : doing, status);
    }

    private static TimeSpan MinLimit(HangPolicy policy)
        => Times.Earlier(
            policy.LimitOf(ManagerStage.Startup),
            Times.Earlier(policy.LimitOf(ManagerStage.UnitOfWork), policy.LimitOf(ManagerStage.Shutdown)));

    // Found within a quarter more than its limit, at next to no cost.
    private static TimeSpan IntervalFor(TimeSpan limit)
    {
        var quarter = new TimeSpan(limit.Ticks / 4);
        return quarter < MinInterval ? MinInterval : Times.Earlier(quarter, MaxInterval);
    }

    private ManagerStatus[] ReadStatuses() => Array.ConvertAll(_statuses, s => s.Read());
}
