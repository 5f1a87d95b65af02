using Rabit.Core;
using Rabit.Diagnostics.Protocol;
using Rabit.Diagnostics.Values;

namespace Rabit.Diagnostics.Observing;

/// <summary>Reads the counters of one queue.</summary>
internal sealed class QueueProbe(QueueObserver queue)
{
    private readonly string _type = TypeText.Of(queue.ValueType);
    private long _lastPushed;

    public QueueFigures Read(Elapsed? elapsed)
    {
        QueueCounters counters = queue.ReadCounters();
        double? rate = elapsed?.Rate(counters.Pushed - _lastPushed);
        _lastPushed = counters.Pushed;
        return new QueueFigures
        {
            Name = queue.Name,
            ValueType = _type,
            Level = counters.Resident,
            HighWater = counters.HighWater,
            Capacity = counters.Capacity,
            Pushed = counters.Pushed,
            PushesPerSecond = rate,
            Popped = counters.Popped,
            Dropped = counters.Dropped,
            Rejected = counters.Rejected,
        };
    }
}
