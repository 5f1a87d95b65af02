using System;

namespace Rabit.Core.Tests.Exploration;

/// <summary>A clock that stands still until the explorer lets time pass; 0 while the model is built.</summary>
internal sealed class ExploredClock : TimeProvider
{
    public override long TimestampFrequency => TimeSpan.TicksPerSecond;

    public override long GetTimestamp() => Recorder.Current?.Perform(new SyncOperation(SyncKind.ReadClock)) ?? 0;
}
