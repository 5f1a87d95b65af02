using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Diagnostics;
using Rabit.Core.Messages;
using Rabit.Core.Queues;
using Rabit.Core.Supervision;
using Rabit.Core.Time;
using Rabit.Core.Wiring;

namespace Rabit.Core;

/// <summary>
/// Where the managers of one reactor meet: its messages and queues, found by type and name. An object like any other:
/// many in one process, in parallel. Code outside managers (a main program, a user interface, a test) gets endpoints of
/// its own here.
/// </summary>
/// <remarks>
/// An endpoint made here may be used by any one thread at a time; a manager's endpoints are made by the manager.
/// </remarks>
public sealed partial class RabitWorkspace
{
    private const string OutsideName = "outside";

    // Guards the declarations and connectors: outside subscribers may come at any time, on any thread.
    private readonly object _gate = new();
    private readonly EndpointOwner _outside = new(OutsideName, isManager: false, wakeUp: null);
    private readonly List<EndpointDeclaration> _outsideDeclarations = [];
    private readonly Dictionary<string, IConnector> _messages = new(StringComparer.Ordinal);
    private readonly List<IMessageQueue> _queues = [];
    private readonly HashSet<Type> _trusted = [];
    private readonly List<AbsentManager> _absent = [];
    private readonly List<BufferPool> _pools = [];
    private WiringGraph? _wiring;

    internal RabitWorkspace()
    {
    }

    /// <summary>
    /// The wiring: every message and queue, who posts, fetches, pushes and pops it, who is woken by it, and, as text,
    /// notes on what looks odd. Any thread; empty before the reactor has started.
    /// </summary>
    /// <param name="format">How it is written.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such format.</exception>
    public string DescribeWiring(WiringFormat format = WiringFormat.Text)
    {
        lock (_gate)
        {
            return format switch
            {
                _ when format is < WiringFormat.Text or > WiringFormat.Dot =>
                    throw new ArgumentOutOfRangeException(nameof(format), format, "There is no such format."),
                _ when _wiring is null => string.Empty,
                WiringFormat.Mermaid => WiringDrawing.Mermaid(_wiring),
                WiringFormat.Dot => WiringDrawing.Dot(_wiring),
                _ => WiringText.Describe(_wiring),
            };
        }
    }

    /// <summary>
    /// Vouches for a type that is not one's own, and cannot carry <see cref="TrustedImmutableAttribute"/>: messages and
    /// queues of this workspace may hold it as they hold a string. Before the start only; any thread.
    /// </summary>
    /// <param name="type">
    /// The type; <c>typeof(Matrix&lt;&gt;)</c> for all of a generic one, whose arguments are still checked.
    /// </param>
    /// <exception cref="InvalidOperationException">The reactor has started.</exception>
    public void TrustImmutable(Type type)
    {
        Require.NotNull(type, nameof(type));
        lock (_gate)
        {
            if (_wiring is not null)
                throw new InvalidOperationException(
                    $"The reactor has started: trust in {TypeNames.Of(type)} comes too late.");
            _trusted.Add(type);
        }
    }

    /// <summary>
    /// States that a manager is absent on purpose. The check of the wiring then names it where the others need its part
    /// and have it from nowhere else; a queue whose only sender is absent, otherwise a note in the log, is a fault.
    /// Before the start only; any thread.
    /// </summary>
    /// <param name="absent">The manager, and what its part would have been.</param>
    /// <exception cref="InvalidOperationException">The reactor has started.</exception>
    public void LeaveOut(AbsentManager absent)
    {
        Require.NotNull(absent, nameof(absent));
        lock (_gate)
        {
            if (_wiring is not null)
                throw new InvalidOperationException(
                    $"The reactor has started: to leave out manager '{absent.Name}' comes too late.");
            _absent.Add(absent);
        }
    }

    /// <summary>
    /// Has the run look at the end, when all managers have shut down and the queues have returned what was left in
    /// them, whether every buffer of a pool was returned. One that was not is in the log and in
    /// <see cref="ReactorResult.Failure"/>, with who has it. At any time before the end, on any thread. The pool is to
    /// be used by this run alone.
    /// </summary>
    /// <param name="pool">The pool.</param>
    public void Watch(BufferPool pool)
    {
        Require.NotNull(pool, nameof(pool));
        lock (_gate)
            _pools.Add(pool);
    }

    internal IReadOnlyList<string> Notes
    {
        get
        {
            lock (_gate)
                return _wiring is null ? [] : WiringText.Notes(_wiring).ToList();
        }
    }

    /// <summary>What is wrong with what all managers declared; ties nothing.</summary>
    internal IReadOnlyList<string> FindFaults(IReadOnlyList<RabitManager> managers, ReactorOptions options)
    {
        lock (_gate)
            return FindFaults(new WiringGraph(managers, _outsideDeclarations), options);
    }

    /// <summary>Checks what all managers declared and ties their endpoints together.</summary>
    /// <exception cref="RabitWiringException">It does not fit together.</exception>
    internal void Wire(IReadOnlyList<RabitManager> managers, ReactorOptions options, RunClock clock, RabitLog log)
    {
        lock (_gate)
        {
            var wiring = new WiringGraph(managers, _outsideDeclarations);
            List<string> faults = FindFaults(wiring, options);
            if (faults.Count > 0)
                throw new RabitWiringException(faults);

            foreach (IReadOnlyList<EndpointDeclaration> endpoints in wiring.Messages.Values)
                _messages.Add(endpoints[0].Name, Bind(endpoints, clock, log));
            foreach (IReadOnlyList<EndpointDeclaration> endpoints in wiring.Queues.Values)
                _queues.Add(BindQueue(endpoints, clock, log));
            _wiring = wiring;
        }
    }

    /// <summary>What keeps the time of pushes that wait; null where the wiring has none.</summary>
    internal QueueTimeKeeper? TimeKeeper { get; private set; }

    /// <summary>The library's own endpoint of a status, once all is wired.</summary>
    internal StatusEndpoint StatusEndpointOf(string managerName, bool inheritsPriority)
    {
        var binding = new MessageBinding<ManagerStatus>(
            NewOwner(), EndpointRole.Publish, RabitManager.StatusMessageName(managerName))
        {
            PostsRarely = true, // only when the manager hangs
        };
        lock (_gate)
            BindLate(binding);
        return new StatusEndpoint(binding, inheritsPriority);
    }

    /// <summary>
    /// The run has ended: waiters of queues are released, and what is left and must be returned is returned.
    /// </summary>
    /// <returns>
    /// The counters of all queues as they were when nothing more came in and nothing was returned yet.
    /// </returns>
    internal IReadOnlyList<QueueResult> CloseQueues()
    {
        List<QueueResult> results;
        lock (_gate)
        {
            // In this order, or a value that is pushed in between would be neither rejected nor reported.
            foreach (IMessageQueue queue in _queues)
                queue.Close();
            results = _queues.ConvertAll(
                queue => new QueueResult(queue.Name, queue.Counters, SendersOf(queue.Name).Count(s => s.IsHolding)));
        }

        // Not under the lock: Dispose is user code. Nothing was added to the queues and messages since they were wired.
        foreach (IMessageQueue queue in _queues)
        {
            queue.DisposeRest();
            foreach (IQueueDeclaration sender in SendersOf(queue.Name))
                sender.DisposeHeld();
        }

        lock (_gate)
        {
            foreach (IConnector message in _messages.Values)
                message.Close();
        }

        return results;
    }

    /// <summary>
    /// The run has ended: the owners of buffers that were not returned to the watched pools, a line for each pool.
    /// </summary>
    internal IReadOnlyList<string> FindLeaks()
    {
        lock (_gate)
            return _pools.Distinct().Select(p => p.FindLeak()).OfType<string>().ToList();
    }

    // Under _gate.
    private List<string> FindFaults(WiringGraph wiring, ReactorOptions options)
    {
        List<string> faults = WiringCheck.FindFaults(wiring, options.Time, _trusted, _absent);
        List<string> shared = WiringCheck.FindSharedValues(wiring, _trusted);
        (options.RefusesMutableQueueTypes ? faults : wiring.Notes).AddRange(shared);
        return faults;
    }

    private IEnumerable<IQueueDeclaration> SendersOf(string queue)
        => _wiring!.Queues[queue].Where(e => e.Role == EndpointRole.Send).Cast<IQueueDeclaration>();

    private IMessageQueue BindQueue(IReadOnlyList<EndpointDeclaration> endpoints, RunClock clock, RabitLog log)
    {
        IConnector queue = Bind(endpoints, clock, log);
        bool mayTimeOut = endpoints.Any(e => ((IQueueDeclaration)e).MaxWait is not null)
            && endpoints.Any(e => e.Role == EndpointRole.Send && e.Owner.IsOutside);
        if (mayTimeOut && queue is ITimeLimitedQueue limited)
            (TimeKeeper ??= new QueueTimeKeeper(clock)).Watch(limited);
        return (IMessageQueue)queue;
    }

    private static IConnector Bind(IReadOnlyList<EndpointDeclaration> endpoints, RunClock clock, RabitLog log)
    {
        IConnector connector = endpoints[0].CreateConnector(endpoints, clock, log);
        if (log.Events is { } events)
            endpoints[0].Watch(connector, events);
        var firsts = new Dictionary<EndpointOwner, EndpointDeclaration>();
        foreach (EndpointDeclaration endpoint in endpoints)
        {
            firsts.TryGetValue(endpoint.Owner, out EndpointDeclaration? first);
            endpoint.Bind(connector, first);
            if (first is null)
                firsts.Add(endpoint.Owner, endpoint);
        }

        return connector;
    }
}
