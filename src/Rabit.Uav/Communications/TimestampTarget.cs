using System;
using System.IO;
using Rabit.Core;
using Rabit.Mavlink;

namespace Rabit.Uav.Communications;

/// <summary>
/// Stores the signing clock on the writer's thread, since a disk may take its time. What is stored is due only 10 s
/// after it was handed over, so that it is in time all the same.
/// </summary>
internal sealed class TimestampTarget(IMavlinkTimestampStore store) : IWriterTarget<TimestampRecord>
{
    private readonly byte[] _record = new byte[TimestampRecord.Length];

    // Written by the writer's thread, read by the manager's.
    private volatile bool _hasFailed;

    /// <summary>A write is short and ends by itself; there is nothing to unblock.</summary>
    public bool Blocks => false;

    /// <summary>Whether the last write did not succeed. Any thread.</summary>
    public bool HasFailed => _hasFailed;

    public void Open()
    {
    }

    public void Write(in TimestampRecord value)
    {
        value.CopyTo(_record);
        try
        {
            _hasFailed = !store.Write(value.Slot, _record);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            _hasFailed = true;
        }
    }

    public void Unblock()
    {
    }

    public void Close()
    {
    }
}
