using System;
using Rabit.Core.Locks;
using Rabit.Core.Messages;

namespace Rabit.Core.Supervision;

/// <summary>
/// The library's own endpoint of a manager's status: for the watchdog, the meter and the result. Any thread.
/// </summary>
/// <param name="binding">Of the status.</param>
/// <param name="inheritsPriority">
/// Whether the manager has requested a priority: it may wait for the watchdog that posts in its place
/// (<see cref="HangWatch"/>), and that for another reader of the status.
/// </param>
internal sealed class StatusEndpoint(MessageBinding<ManagerStatus> binding, bool inheritsPriority)
{
    // Guards the local copy behind both endpoints.
    private readonly EndpointLock _gate = new(inheritsPriority);
    private readonly MessageSubscriber<ManagerStatus> _subscriber = new(binding);
    private readonly MessagePublisher<ManagerStatus> _publisher = new(binding);

    public bool InheritsPriority => _gate.InheritsPriority;

    public ManagerStatus Read()
    {
        using (_gate.Enter())
        {
            _subscriber.Fetch();
            return _subscriber.Value;
        }
    }

    /// <summary>Posts what the manager posted last, but that it hangs.</summary>
    public void PostHang(TimeSpan since, long count, string text)
    {
        using (_gate.Enter())
        {
            _subscriber.Fetch();
            ref ManagerStatus status = ref _publisher.Value;
            status.State = ManagerState.Hanging;
            status.HangingSince = since;
            status.Hangs = count;
            status.LastHang = text;
            _publisher.Post();
        }
    }
}
