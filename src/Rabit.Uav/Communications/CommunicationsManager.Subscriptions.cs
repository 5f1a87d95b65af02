using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

// Frames for queues of other managers.
public sealed partial class CommunicationsManager
{
    private readonly SubscriptionPort[] _subscriptions;

    // By message id, for those that name ids; the others get everything.
    private readonly Dictionary<int, SubscriptionPort[]> _subscriptionsById = [];
    private SubscriptionPort[] _subscriptionsToAll = [];

    /// <summary>What went to the queue of each subscription, in the order of the options. Any thread.</summary>
    public IReadOnlyList<MavlinkSubscriptionCounters> CountSubscriptions()
        => _subscriptions.Select(s => s.Counters).ToArray();

    private SubscriptionPort[] OpenSubscriptions()
    {
        SubscriptionPort[] ports = _options.Subscriptions.Select(s => new SubscriptionPort(s, Send<LinkFrame>(s.Queue)))
            .ToArray();
        foreach (int id in _options.Subscriptions.SelectMany(s => s.MessageIds).Distinct())
            _subscriptionsById.Add(id, ports.Where(p => p.Includes(id)).ToArray());
        _subscriptionsToAll = ports.Where((_, index) => _options.Subscriptions[index].MessageIds.Count == 0).ToArray();
        foreach (byte component in _options.Subscriptions.Select(s => s.ComponentId).OfType<byte>())
            _router.AddOwnComponent(component);
        return ports;
    }

    private void DeliverToSubscriptions(in LinkFrame frame, bool isForComputer)
    {
        if (_subscriptions.Length == 0)
            return;
        if (!_subscriptionsById.TryGetValue(frame.Frame.MessageId, out SubscriptionPort[]? ports))
            ports = _subscriptionsToAll;
        foreach (SubscriptionPort port in ports)
            port.Deliver(frame, _ownAddress.Value.SystemId, isForComputer);
    }
}
