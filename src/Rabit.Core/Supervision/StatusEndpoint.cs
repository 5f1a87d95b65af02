using System;
using Rabit.Core.Messages;

namespace Rabit.Core.Supervision;

/// <summary>
/// The library's own endpoint of a manager's status: for the watchdog, the meter and the result. Any thread.
/// </summary>
internal sealed class StatusEndpoint(MessageBinding<ManagerStatus> binding)
{
    // Guards the local copy behind both endpoints.
    private readonly object _gate = new();
    private readonly MessageSubscriber<ManagerStatus> _subscriber = new(binding);
    private readonly MessagePublisher<ManagerStatus> _publisher = new(binding);

    public ManagerStatus Read()
    {
        lock (_gate)
        {
            _subscriber.Fetch();
            return _subscriber.Value;
        }
    }

    /// <summary>Posts what the manager posted last, but that it hangs.</summary>
    public void PostHang(TimeSpan since, long count, string text)
    {
        lock (_gate)
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
