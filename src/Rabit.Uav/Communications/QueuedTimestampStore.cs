using System;
using Rabit.Core;
using Rabit.Mavlink;

namespace Rabit.Uav.Communications;

/// <summary>Reads the store at once, before the run, and hands what is to be written to a writer.</summary>
internal sealed class QueuedTimestampStore(
    IMavlinkTimestampStore store, TimestampTarget target, BlockingWriter<TimestampRecord> writer)
    : IMavlinkTimestampStore
{
    public int Read(int slot, Span<byte> record) => store.Read(slot, record);

    /// <returns>
    /// False also where the write before it failed: the clock then tries again a second later, until one succeeds.
    /// </returns>
    public bool Write(int slot, ReadOnlySpan<byte> record)
        => writer.Push(TimestampRecord.Of(slot, record)) != PushResult.Rejected && !target.HasFailed;
}
