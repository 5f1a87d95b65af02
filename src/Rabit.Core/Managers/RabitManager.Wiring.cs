using System;
using Rabit.Core.Devices;
using Rabit.Core.Messages;
using Rabit.Core.Queues;
using Rabit.Core.WakeUp;
using Rabit.Core.Wiring;

namespace Rabit.Core;

/// <content>What a constructor records: the endpoints of messages and queues, the readers and writers.</content>
public abstract partial class RabitManager
{
    /// <summary>Records that this manager posts a message.</summary>
    /// <typeparam name="T">
    /// A struct with value semantics. A class needs <see cref="Publish{T}(string, T, bool)"/>, which states a first
    /// value.
    /// </typeparam>
    /// <param name="name">The name under which subscribers find it.</param>
    /// <exception cref="InvalidOperationException">The reactor has started: what is wired stays wired.</exception>
    protected MessagePublisher<T> Publish<T>(string name)
        => new(Declare(new MessageBinding<T>(_owner, EndpointRole.Publish, MessageName(name))));

    /// <summary>Records that this manager posts a message, and what its value is before the first post.</summary>
    /// <typeparam name="T">
    /// A struct with value semantics, an immutable class, or a class that copies itself
    /// (<see cref="ISelfCopying{TSelf}"/>).
    /// </typeparam>
    /// <param name="name">The name under which subscribers find it.</param>
    /// <param name="initial">What every local copy holds before the first post; never news.</param>
    /// <param name="allowOtherPublishers">Whether others may publish it too; all of them must say so.</param>
    /// <exception cref="InvalidOperationException">The reactor has started: what is wired stays wired.</exception>
    protected MessagePublisher<T> Publish<T>(string name, T initial, bool allowOtherPublishers = false)
        => new(Declare(new MessageBinding<T>(_owner, EndpointRole.Publish, MessageName(name))
        {
            Initial = initial,
            StatesInitial = initial is not null,
            IsShared = allowOtherPublishers,
        }));

    /// <summary>Records that this manager fetches a message.</summary>
    /// <typeparam name="T">The type that its publisher posts.</typeparam>
    /// <param name="name">The name of the message.</param>
    /// <param name="wakeOnPost">Whether a post wakes this manager.</param>
    /// <param name="optional">
    /// Whether it may have no publisher. Its value is the default then, null for a class; see
    /// <see cref="MessageSubscriber{T}.WasPosted"/>.
    /// </param>
    /// <exception cref="InvalidOperationException">The reactor has started: what is wired stays wired.</exception>
    protected MessageSubscriber<T> Subscribe<T>(string name, bool wakeOnPost = false, bool optional = false)
        => new(
            Declare(
                new MessageBinding<T>(_owner, EndpointRole.Subscribe, MessageName(name))
                {
                    Wakes = wakeOnPost,
                    IsOptional = optional
                }));

    /// <summary>Records that this manager fetches the status of a manager.</summary>
    /// <param name="managerName">The manager; it must be in the same reactor.</param>
    /// <param name="wakeOnPost">Whether each status wakes this manager.</param>
    /// <exception cref="InvalidOperationException">The reactor has started: what is wired stays wired.</exception>
    protected MessageSubscriber<ManagerStatus> SubscribeToStatus(string managerName, bool wakeOnPost = false)
        => Subscribe<ManagerStatus>(StatusMessageName(managerName), wakeOnPost);

    /// <summary>Records that this manager receives a queue. A queue has one receiver.</summary>
    /// <typeparam name="T">What the senders push.</typeparam>
    /// <param name="name">The name under which senders find it.</param>
    /// <param name="capacity">How many values fit in; at least one.</param>
    /// <param name="whenFull">What happens to a push into a full queue.</param>
    /// <param name="wakeOnPush">Whether a push wakes this manager; its own pushes do too.</param>
    /// <param name="maxWait">
    /// With <see cref="QueueFullMode.Wait"/> only: how long a push may wait for room. Without it: until there is some.
    /// </param>
    /// <exception cref="InvalidOperationException">The reactor has started: what is wired stays wired.</exception>
    protected QueueReceiver<T> Receive<T>(
        string name, int capacity = 100, QueueFullMode whenFull = QueueFullMode.Reject, bool wakeOnPush = true,
        TimeSpan? maxWait = null)
        => new(DeclareReceiver<T>(_owner, QueueName(name), capacity, whenFull, wakeOnPush, maxWait));

    /// <summary>Records that this manager sends to a queue.</summary>
    /// <typeparam name="T">The type that its receiver pops.</typeparam>
    /// <param name="name">The name of the queue.</param>
    /// <param name="wakeOnPop">Whether a pop wakes this manager.</param>
    /// <exception cref="InvalidOperationException">The reactor has started: what is wired stays wired.</exception>
    protected QueueSender<T> Send<T>(string name, bool wakeOnPop = false)
        => new(Declare(new QueueBinding<T>(_owner, EndpointRole.Send, QueueName(name)) { Wakes = wakeOnPop }));

    /// <summary>
    /// Gives this manager a reader: a thread of the library's that reads a source and wakes the manager with what it
    /// read.
    /// </summary>
    /// <typeparam name="T">What one read gives.</typeparam>
    /// <param name="name">Unique within the manager.</param>
    /// <param name="source">What is read; used by one reader.</param>
    /// <param name="capacity">How many values that were read may wait for the manager.</param>
    /// <param name="whenFull">
    /// What happens when that many wait; <see cref="QueueFullMode.Wait"/> makes the reader wait and loses nothing.
    /// </param>
    /// <param name="maxWait">
    /// With <see cref="QueueFullMode.Wait"/> only: how long the reader may wait for room; then what it read is
    /// rejected, and it reads on.
    /// </param>
    /// <param name="reconnect">Whether the source is opened again after a fault; null for never.</param>
    /// <exception cref="InvalidOperationException">The reactor has started: what is wired stays wired.</exception>
    protected BlockingReader<T> AttachReader<T>(
        string name,
        IReaderSource<T> source,
        int capacity = 100,
        QueueFullMode whenFull = QueueFullMode.Wait,
        TimeSpan? maxWait = null,
        ReconnectPolicy? reconnect = null)
    {
        EndpointOwner reader = DeviceOwner(name, "reader");
        QueueBinding<T> receiver = DeclareReceiver<T>(
            _owner, reader.Name, capacity, whenFull, wakeOnPush: true, maxWait);
        QueueBinding<T> sender = Declare(new QueueBinding<T>(reader, EndpointRole.Send, reader.Name));
        var health = new DeviceHealth();
        Readers.Add(new ReaderActivity<T>(
            reader.Name, reader.WakeUp!, _owner, health, reconnect ?? ReconnectPolicy.Never,
            Require.NotNull(source, nameof(source)), sender));
        return new BlockingReader<T>(name, new QueueReceiver<T>(receiver), health);
    }

    /// <summary>
    /// Gives this manager a writer: a thread of the library's that writes to a target what the manager pushes.
    /// </summary>
    /// <typeparam name="T">What one write takes.</typeparam>
    /// <param name="name">Unique within the manager.</param>
    /// <param name="target">What is written to; used by one writer.</param>
    /// <param name="capacity">How many values may wait to be written.</param>
    /// <param name="whenFull">
    /// What happens when that many wait: reject, or drop the oldest or the newest. The manager never waits.
    /// </param>
    /// <param name="reconnect">Whether the target is opened again after a fault; null for never.</param>
    /// <exception cref="InvalidOperationException">The reactor has started: what is wired stays wired.</exception>
    protected BlockingWriter<T> AttachWriter<T>(
        string name,
        IWriterTarget<T> target,
        int capacity = 100,
        QueueFullMode whenFull = QueueFullMode.Reject,
        ReconnectPolicy? reconnect = null)
    {
        EndpointOwner writer = DeviceOwner(name, "writer");
        QueueBinding<T> receiver = DeclareReceiver<T>(writer, writer.Name, capacity, whenFull, wakeOnPush: true);
        QueueBinding<T> sender = Declare(new QueueBinding<T>(_owner, EndpointRole.Send, writer.Name));
        var health = new DeviceHealth();
        Writers.Add(new WriterActivity<T>(
            writer.Name, writer.WakeUp!, _owner, health, reconnect ?? ReconnectPolicy.Never,
            Require.NotNull(target, nameof(target)), receiver));
        return new BlockingWriter<T>(name, new QueueSender<T>(sender), health);
    }

    private QueueBinding<T> DeclareReceiver<T>(
        EndpointOwner owner, string name, int capacity, QueueFullMode whenFull, bool wakeOnPush,
        TimeSpan? maxWait = null)
        => Declare(new QueueBinding<T>(owner, EndpointRole.Receive, name)
        {
            Capacity = capacity,
            FullMode = whenFull,
            Wakes = wakeOnPush,
            MaxWait = maxWait,
        });

    private TDeclaration Declare<TDeclaration>(TDeclaration declaration)
        where TDeclaration : EndpointDeclaration
    {
        if (_run is not null)
            throw new InvalidOperationException(
                $"Manager '{Name}' has started: '{declaration.Name}' can be declared in its constructor only.");
        Declarations.Add(declaration);
        return declaration;
    }

    private EndpointOwner DeviceOwner(string name, string what)
        => new(
            $"{Name}/{Require.Name(name, nameof(name), $"A {what} of manager '{Name}'")}", isManager: false,
            new WakeUpEvent());

    private string MessageName(string name) => Require.Name(name, nameof(name), $"A message of manager '{Name}'");

    private string QueueName(string name) => Require.Name(name, nameof(name), $"A queue of manager '{Name}'");
}
