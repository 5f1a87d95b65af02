using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Messages;
using Rabit.Core.Queues;
using Rabit.Core.Wiring;

namespace Rabit.Core;

/// <content>Endpoints for code outside managers.</content>
public sealed partial class RabitWorkspace
{
    /// <summary>Makes an endpoint that posts, for code outside managers. Before the start only.</summary>
    /// <typeparam name="T">As for <see cref="RabitManager.Publish{T}(string)"/>.</typeparam>
    /// <param name="name">The name of the message.</param>
    /// <exception cref="InvalidOperationException">The reactor has started.</exception>
    public MessagePublisher<T> Publish<T>(string name)
        => new(Declare(new MessageBinding<T>(NewOwner(), EndpointRole.Publish, MessageName(name))));

    /// <summary>
    /// Makes an endpoint that posts, for code outside managers, and states the value before the first post. Before the
    /// start only.
    /// </summary>
    /// <typeparam name="T">As for <see cref="RabitManager.Publish{T}(string, T, bool)"/>.</typeparam>
    /// <param name="name">The name of the message.</param>
    /// <param name="initial">What every local copy holds before the first post; never news.</param>
    /// <param name="allowOtherPublishers">Whether others may publish it too; all of them must say so.</param>
    /// <exception cref="InvalidOperationException">The reactor has started.</exception>
    public MessagePublisher<T> Publish<T>(string name, T initial, bool allowOtherPublishers = false)
        => new(Declare(new MessageBinding<T>(NewOwner(), EndpointRole.Publish, MessageName(name))
        {
            Initial = initial,
            StatesInitial = initial is not null,
            IsShared = allowOtherPublishers,
        }));

    /// <summary>Makes an endpoint that pushes, for code outside managers. Before the start only.</summary>
    /// <typeparam name="T">The type that the receiver pops.</typeparam>
    /// <param name="name">The name of the queue.</param>
    /// <exception cref="InvalidOperationException">The reactor has started.</exception>
    public QueueSender<T> Send<T>(string name)
        => new(Declare(new QueueBinding<T>(_outside, EndpointRole.Send, Require.Name(name, nameof(name), "A queue"))));

    /// <summary>
    /// Makes the endpoint that pops, for code outside managers: async code drains it through
    /// <see cref="QueueReceiver{T}.AsChannelReader"/>. Before the start only.
    /// </summary>
    /// <typeparam name="T">The type that the senders push.</typeparam>
    /// <param name="name">The name of the queue.</param>
    /// <param name="capacity">How many values fit in; at least one.</param>
    /// <param name="whenFull">What happens to a push into a full queue.</param>
    /// <param name="maxWait">As for a manager's.</param>
    /// <exception cref="InvalidOperationException">The reactor has started.</exception>
    public QueueReceiver<T> Receive<T>(
        string name, int capacity = 100, QueueFullMode whenFull = QueueFullMode.Reject, TimeSpan? maxWait = null)
        => new(Declare(new QueueBinding<T>(_outside, EndpointRole.Receive, Require.Name(name, nameof(name), "A queue"))
        {
            Capacity = capacity,
            FullMode = whenFull,
            MaxWait = maxWait,
        }));

    /// <summary>Makes an endpoint that fetches, for code outside managers. At any time, on any thread.</summary>
    /// <typeparam name="T">The type that the publisher posts.</typeparam>
    /// <param name="name">The name of the message.</param>
    /// <exception cref="InvalidOperationException">
    /// The reactor has started and no message of that name and type is published.
    /// </exception>
    public MessageSubscriber<T> Subscribe<T>(string name)
    {
        var binding = new MessageBinding<T>(NewOwner(), EndpointRole.Subscribe, MessageName(name));
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

    // Each outside endpoint is an owner of its own: two of them are news to each other, as two managers are.
    private static EndpointOwner NewOwner() => new(OutsideName, isManager: false, wakeUp: null);

    private static string MessageName(string name) => Require.Name(name, nameof(name), "A message");

    private TDeclaration Declare<TDeclaration>(TDeclaration declaration)
        where TDeclaration : EndpointDeclaration
    {
        lock (_gate)
        {
            if (_wiring is not null)
                throw new InvalidOperationException(
                    $"The reactor has started: an endpoint for '{declaration.Name}' comes too late. Only subscribers "
                        + "may come later.");
            _outsideDeclarations.Add(declaration);
            return declaration;
        }
    }

    private void BindLate<T>(MessageBinding<T> binding)
    {
        if (!_messages.TryGetValue(binding.Name, out IConnector? connector))
        {
            string known = string.Join(", ", _messages.Keys.OrderBy(n => n, StringComparer.Ordinal));
            throw new InvalidOperationException(
                $"There is no message '{binding.Name}'; there are: {known}."
                    + NameSuggestion.For(binding.Name, _messages.Keys, _queues.Select(q => q.Name), "queue"));
        }

        if (connector is not SharedMessage<T>)
            throw AnotherType(binding, _wiring!.Messages[binding.Name][0].ValueType);
        binding.Bind(connector, firstOfOwner: null);
    }

    private static InvalidOperationException AnotherType(EndpointDeclaration wanted, Type there)
    {
        IReadOnlyList<string> names = TypeNames.Of([there, wanted.ValueType]);
        return new InvalidOperationException(
            $"Message '{wanted.Name}' is of type {names[0]}, not of type {names[1]}.");
    }
}
