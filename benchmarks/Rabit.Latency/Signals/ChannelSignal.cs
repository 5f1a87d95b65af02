using System.Threading.Channels;
using System.Threading.Tasks;

namespace Rabit.Latency.Signals;

/// <summary>A bounded <see cref="Channel{T}"/> whose reader is a thread.</summary>
internal sealed class ChannelSignal : Signal
{
    private readonly Channel<int> _channel = Channel.CreateBounded<int>(
        new BoundedChannelOptions(16) { SingleReader = true, SingleWriter = true });

    public override void Set() => _channel.Writer.TryWrite(1);

    public override void Wait()
    {
        while (!_channel.Reader.TryRead(out _))
        {
            ValueTask<bool> came = _channel.Reader.WaitToReadAsync();
            if (!came.IsCompleted)
                came.AsTask().Wait();
        }
    }

    public override void Dispose() => _channel.Writer.TryComplete();
}
