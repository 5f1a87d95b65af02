using System.Threading;

namespace Rabit.Latency.Signals;

/// <summary>An <see cref="AutoResetEvent"/> without Rabit.</summary>
/// <param name="milliseconds">
/// The longest wait; -1 for ever. A thread that has a timer beside its signal, as every manager has, waits with one.
/// </param>
internal sealed class EventSignal(int milliseconds) : Signal
{
    private readonly AutoResetEvent _event = new(initialState: false);

    public override void Set() => _event.Set();

    public override void Wait() => _event.WaitOne(milliseconds);

    public override void Dispose() => _event.Dispose();
}
