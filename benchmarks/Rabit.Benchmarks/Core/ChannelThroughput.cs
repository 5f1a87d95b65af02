using System.Threading.Channels;

namespace Rabit.Benchmarks.Core;

/// <summary>A bounded channel between threads: where it is full or empty its thread waits for the task that says otherwise.</summary>
internal sealed class ChannelThroughput(int senders, int capacity) : ThreadedThroughput(senders)
{
    private readonly Channel<Block64> _channel = Channels.Queue<Block64>(capacity, senders);

    protected override void Send(int count)
    {
        Block64 message = default;
        for (int i = 0; i < count; i++)
        {
            message.Number = i;
            while (!_channel.Writer.TryWrite(message))
                _channel.Writer.WaitToWriteAsync().AsTask().Wait();
        }
    }

    protected override void Receive(int count)
    {
        for (int i = 0; i < count; i++)
        {
            while (!_channel.Reader.TryRead(out _))
                _channel.Reader.WaitToReadAsync().AsTask().Wait();
        }
    }
}
