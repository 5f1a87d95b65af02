using System;

namespace Rabit.Tool.TelemetryLogs;

/// <summary>How often one sender sent one message.</summary>
internal sealed class MessageCount(string name, int messageId, byte systemId, byte componentId)
{
    private long _firstTime = long.MaxValue;
    private long _lastTime = long.MinValue;

    public string Name => name;

    public int MessageId => messageId;

    public byte SystemId => systemId;

    public byte ComponentId => componentId;

    public long Count { get; private set; }

    /// <summary>Bytes of the frames on the wire.</summary>
    public long Bytes { get; private set; }

    /// <summary>Between the first and the last of them; null where there is nothing to divide by.</summary>
    public double? RateHz => Count > 1 && _lastTime > _firstTime ? (Count - 1) * 1e6 / (_lastTime - _firstTime) : null;

    public void Add(int bytes, long timeMicroseconds)
    {
        Count++;
        Bytes += bytes;
        _firstTime = Math.Min(_firstTime, timeMicroseconds);
        _lastTime = Math.Max(_lastTime, timeMicroseconds);
    }
}
