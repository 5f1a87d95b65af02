using System;
using System.IO;
using Rabit.Mavlink;

namespace Rabit.Uav.Communications;

/// <summary>Keeps a signing clock in two small files beside each other. One thread at a time.</summary>
public sealed class FileTimestampStore : IMavlinkTimestampStore
{
    private const int RecordLength = 12;

    private readonly string _path;
    private readonly byte[] _record = new byte[RecordLength];

    /// <summary>Makes a store; nothing is read or written yet.</summary>
    /// <param name="path">The files are this with <c>.0</c> and <c>.1</c> appended. They hold no secret.</param>
    /// <exception cref="ArgumentException">No path.</exception>
    public FileTimestampStore(string path)
        => _path = string.IsNullOrEmpty(path) ? throw new ArgumentException("A path is needed.", nameof(path)) : path;

    /// <inheritdoc/>
    public int Read(int slot, Span<byte> record)
    {
        try
        {
            using var file = new FileStream(PathOf(slot), FileMode.Open, FileAccess.Read);
            int count = file.Read(_record, 0, Math.Min(record.Length, RecordLength));
            _record.AsSpan(0, count).CopyTo(record);
            return count;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return 0;
        }
    }

    /// <inheritdoc/>
    public bool Write(int slot, ReadOnlySpan<byte> record)
    {
        record.CopyTo(_record);
        try
        {
            using var file = new FileStream(PathOf(slot), FileMode.Create, FileAccess.Write);
            file.Write(_record, 0, record.Length);
            file.Flush(flushToDisk: true);
            return true;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return false;
        }
    }

    private string PathOf(int slot) => _path + (slot == 0 ? ".0" : ".1");
}
