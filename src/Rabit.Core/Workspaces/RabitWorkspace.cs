using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Diagnostics;
using Rabit.Core.Managers;
using Rabit.Core.Messaging;
using Rabit.Core.Workspaces;

namespace Rabit.Core;

/// <summary>
/// Where the managers of one reactor meet: its messages and queues, found by type and name. An object like any other: many in
/// one process, in parallel. Code outside managers (a main program, a user interface, a test) gets ends of its own here.
/// </summary>
/// <remarks>An end made here may be used by any one thread at a time; a manager's ends are made by the manager.</remarks>
public sealed class RabitWorkspace
{
    private const string OutsideName = "outside";

    // Guards the declarations and hubs: outside subscribers may come at any time, on any thread.
    private readonly object _gate = new();
    private readonly EndOwner _outside = new(OutsideName, isManager: false, wakeUp: null);
    private readonly List<EndDeclaration> _outsideDeclarations = [];
    private readonly Dictionary<string, object> _messages = new(StringComparer.Ordinal);
    private readonly List<IMessageQueue> _queues = [];
    private Wiring? _wiring;

    internal RabitWorkspace()
    {
    }

    /// <summary>
    /// The wiring: every message and queue, who posts, fetches, pushes and pops it, who is woken by it, and, as text, notes on what looks
    /// odd. Any thread; empty before the reactor has started.
    /// </summary>
    /// <param name="format">How it is written.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such format.</exception>
    public string DescribeWiring(WiringFormat format = WiringFormat.Text)
    {
        lock (_gate)
        {
            return format switch
            {
                _ when format is < WiringFormat.Text or > WiringFormat.Dot => throw new ArgumentOutOfRangeException(nameof(format), format, "There is no such format."),
                _ when _wiring is null => string.Empty,
                WiringFormat.Mermaid => WiringDrawing.Mermaid(_wiring),
                WiringFormat.Dot => WiringDrawing.Dot(_wiring),
                _ => WiringText.Describe(_wiring),
            };
        }
    }

    /// <summary>Makes an end that posts, for code outside managers. Before the start only.</summary>
    /// <typeparam name="T">As for <see cref="RabitManager.Publish{T}(string)"/>.</typeparam>
    /// <param name="name">The name of the message.</param>
    /// <exception cref="InvalidOperationException">The reactor has started.</exception>
    public MessagePublisher<T> Publish<T>(string name)
        => new(Declare(new MessageBinding<T>(NewOwner(), EndRole.Publish, MessageName(name))));

    /// <summary>Makes an end that posts, for code outside managers, and states the value before the first post. Before the start only.</summary>
    /// <typeparam name="T">As for <see cref="RabitManager.Publish{T}(string, T, bool)"/>.</typeparam>
    /// <param name="name">The name of the message.</param>
    /// <param name="initial">What every local copy holds before the first post; never news.</param>
    /// <param name="allowOtherPublishers">Whether others may publish it too; all of them must say so.</param>
    /// <exception cref="InvalidOperationException">The reactor has started.</exception>
    public MessagePublisher<T> Publish<T>(string name, T initial, bool allowOtherPublishers = false)
        => new(Declare(new MessageBinding<T>(NewOwner(), EndRole.Publish, MessageName(name))
        {
            Initial = initial,
            StatesInitial = initial is not null,
            IsShared = allowOtherPublishers,
        }));

    /// <summary>Makes an end that pushes, for code outside managers. Before the start only.</summary>
    /// <typeparam name="T">The type that the receiver pops.</typeparam>
    /// <param name="name">The name of the queue.</param>
    /// <exception cref="InvalidOperationException">The reactor has started.</exception>
    public QueueSender<T> Send<T>(string name)
        => new(Declare(new QueueBinding<T>(_outside, EndRole.Send, Require.Name(name, nameof(name), "A queue"))));

    /// <summary>Makes an end that fetches, for code outside managers. At any time, on any thread.</summary>
    /// <typeparam name="T">The type that the publisher posts.</typeparam>
    /// <param name="name">The name of the message.</param>
    /// <exception cref="InvalidOperationException">The reactor has started and nobody publishes a message of that name and type.</exception>
    public MessageSubscriber<T> Subscribe<T>(string name)
    {
        var binding = new MessageBinding<T>(NewOwner(), EndRole.Subscribe, MessageName(name));
        lock (_gate)
        {
            if (_wiring is null)
                _outsideDeclarations.Add(binding);
            else
                BindLate(binding);
        }

        return new MessageSubscriber<T>(binding);
    }

    /// <summary>As <see cref="Subscribe{T}"/>, for the status of a manager.</summary>
    /// <param name="managerName">The manager.</param>
    /// <exception cref="InvalidOperationException">The reactor has started and has no manager of that name.</exception>
    public MessageSubscriber<ManagerStatus> SubscribeToStatus(string managerName)
        => Subscribe<ManagerStatus>(RabitManager.StatusMessageName(managerName));

    internal IReadOnlyList<string> Notes
    {
        get
        {
            lock (_gate)
                return _wiring is null ? [] : WiringText.Notes(_wiring).ToList();
        }
    }

    /// <summary>Checks what all managers declared and ties their ends together.</summary>
    /// <exception cref="RabitWiringException">It does not fit together.</exception>
    internal void Wire(IReadOnlyList<RabitManager> managers, RabitTime time, RunClock clock, RabitLog log)
    {
        lock (_gate)
        {
            var wiring = new Wiring(managers, _outsideDeclarations);
            IReadOnlyList<string> faults = WiringCheck.FindFaults(wiring, time);
            if (faults.Count > 0)
                throw new RabitWiringException(faults);

            foreach (IReadOnlyList<EndDeclaration> ends in wiring.Messages.Values)
                _messages.Add(ends[0].Name, Bind(ends, clock, log));
            foreach (IReadOnlyList<EndDeclaration> ends in wiring.Queues.Values)
                _queues.Add((IMessageQueue)Bind(ends, clock, log));
            _wiring = wiring;
        }
    }

    /// <summary>The library's own end of a status, once all is wired.</summary>
    internal StatusEnd StatusEndOf(string managerName)
    {
        var binding = new MessageBinding<ManagerStatus>(NewOwner(), EndRole.Publish, RabitManager.StatusMessageName(managerName));
        lock (_gate)
            BindLate(binding);
        return new StatusEnd(binding);
    }

    /// <summary>The run is over: what is left in the queues, and must be given back, is given back.</summary>
    internal void CloseQueues()
    {
        lock (_gate)
        {
            foreach (IMessageQueue queue in _queues)
                queue.Close();
        }
    }

    private static object Bind(IReadOnlyList<EndDeclaration> ends, RunClock clock, RabitLog log)
    {
        object hub = ends[0].CreateHub(ends, clock, log);
        var firsts = new Dictionary<EndOwner, EndDeclaration>();
        foreach (EndDeclaration end in ends)
        {
            firsts.TryGetValue(end.Owner, out EndDeclaration? first);
            end.Bind(hub, first);
            if (first is null)
                firsts.Add(end.Owner, end);
        }

        return hub;
    }

    // Each outside end is an owner of its own: two of them are news to each other, as two managers are.
    private static EndOwner NewOwner() => new(OutsideName, isManager: false, wakeUp: null);

    private static string MessageName(string name) => Require.Name(name, nameof(name), "A message");

    private TDeclaration Declare<TDeclaration>(TDeclaration declaration)
        where TDeclaration : EndDeclaration
    {
        lock (_gate)
        {
            if (_wiring is not null)
                throw new InvalidOperationException($"The reactor has started: an end for '{declaration.Name}' comes too late. Only subscribers may come later.");
            _outsideDeclarations.Add(declaration);
            return declaration;
        }
    }

    private void BindLate<T>(MessageBinding<T> binding)
    {
        if (!_messages.TryGetValue(binding.Name, out object? hub))
        {
            string known = string.Join(", ", _messages.Keys.OrderBy(n => n, StringComparer.Ordinal));
            throw new InvalidOperationException($"There is no message '{binding.Name}'; there are: {known}.");
        }

        if (hub is not SharedMessage<T>)
            throw new InvalidOperationException($"Message '{binding.Name}' is not of type {TypeNames.Of(typeof(T))}.");
        binding.Bind(hub, firstOfOwner: null);
    }
}
