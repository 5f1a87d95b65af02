using System.Collections.Concurrent;
using System.Threading;

namespace Rabit.Core.Tests.Devices;

/// <summary>A source that blocks its thread until a test gives it a value.</summary>
internal sealed class FedSource : IReaderSource<int>
{
    private readonly BlockingCollection<int> _values = [];

    public bool Blocks => true;

    /// <summary>Any thread.</summary>
    public void Feed(int value) => _values.Add(value);

    public void Open(ReaderContext context)
    {
    }

    public ReaderStep Read(out int value)
        => _values.TryTake(out value, Timeout.Infinite) ? ReaderStep.Value : ReaderStep.Ended;

    public void Unblock() => _values.CompleteAdding();

    public void Close()
    {
    }
}
