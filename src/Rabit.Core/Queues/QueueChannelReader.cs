using System.Diagnostics.CodeAnalysis;
using System.Threading;
using System.Threading.Channels;
using System.Threading.Tasks;

namespace Rabit.Core.Queues;

/// <summary>
/// A queue's receiving endpoint as a channel, for async code outside managers. It completes when the run is over and
/// all was popped.
/// </summary>
internal sealed class QueueChannelReader<T>(QueueBinding<T> binding) : ChannelReader<T>
{
    public override bool CanCount => true;

    public override int Count => binding.Use().Count;

    public override Task Completion => binding.UseWaiting().Drained;

    public override bool TryRead([MaybeNullWhen(false)] out T item) => binding.Use().TryPop(out item);

    public override ValueTask<bool> WaitToReadAsync(CancellationToken cancellationToken = default)
        => binding.UseWaiting().WaitForNewsAsync(cancellationToken);
}
