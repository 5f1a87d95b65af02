using System;
using System.Threading;
using System.Threading.Channels;
using System.Threading.Tasks;

namespace Rabit.Core.Queues;

/// <summary>
/// A queue's sending endpoint as a channel, for async code outside managers. It is closed by the end of the run and by
/// nothing else.
/// </summary>
internal sealed class QueueChannelWriter<T>(QueueBinding<T> binding) : ChannelWriter<T>
{
    public override bool TryWrite(T item) => binding.Use().Push(item) != PushResult.Rejected;

    public override ValueTask<bool> WaitToWriteAsync(CancellationToken cancellationToken = default)
        => binding.UseWaiting().WaitForRoomAsync(cancellationToken);

    public override async ValueTask WriteAsync(T item, CancellationToken cancellationToken = default)
    {
        PushResult result = await binding.UseWaiting().PushAsync(item, cancellationToken).ConfigureAwait(false);
        if (result == PushResult.TimedOut)
            throw new TimeoutException($"Queue '{binding.Name}' was full for as long as a push may wait.");
        if (result == PushResult.Rejected)
            throw new ChannelClosedException($"The run has ended: queue '{binding.Name}' has no receiver any more.");
    }
}
