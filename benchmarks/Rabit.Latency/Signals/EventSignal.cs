using System.Threading;

namespace Rabit.Latency.Signals;

/// <summary>An <see cref="AutoResetEvent"/> by hand.</summary>
internal sealed class EventSignal : Signal
{
    private readonly AutoResetEvent _event = new(initialState: false);

    public override void Set() => _event.Set();

    public override void Wait() => _event.WaitOne();

    public override void Dispose() => _event.Dispose();
}
