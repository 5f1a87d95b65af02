using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Messages;
using Rabit.Core.Queues;

namespace Rabit.Core;

/// <content>Messages and queues for code that knows them by name only: diagnostics, a logger of everything.</content>
public sealed partial class RabitWorkspace
{
    /// <summary>
    /// Every message, the statuses of the managers among them, in the order of their names: for tools that learn at run
    /// time what there is. It adds nothing to a post. At any time, on any thread.
    /// </summary>
    /// <returns>Observers of their own for each call; empty before the reactor has started.</returns>
    public IReadOnlyList<MessageObserver> ObserveMessages()
    {
        lock (_gate)
            return _wiring is null
                ? []
                : _wiring.Messages.Keys.Select(name => ((IObservedMessage)_messages[name]).Observe()).ToList();
    }

    /// <summary>
    /// Every queue, in the order of their names. It adds nothing to a push or a pop. At any time, on any thread.
    /// </summary>
    /// <returns>Empty before the reactor has started.</returns>
    public IReadOnlyList<QueueObserver> ObserveQueues()
    {
        lock (_gate)
            return _queues.ConvertAll(queue => new QueueObserver(queue, _wiring!.Queues[queue.Name][0].ValueType));
    }
}
