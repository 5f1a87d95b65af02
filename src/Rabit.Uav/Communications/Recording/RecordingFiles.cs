using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Threading;

namespace Rabit.Uav.Communications;

/// <summary>
/// The files of one recording: their names, and which of them are kept. The writer's thread; the figures any thread.
/// </summary>
internal sealed class RecordingFiles(RecordingOptions options)
{
    private static readonly DateTime Epoch = new(1970, 1, 1, 0, 0, 0, DateTimeKind.Utc);

    private readonly Queue<string> _kept = new();
    private string? _stem;
    private int _number;
    private volatile string? _current;
    private int _count;
    private int _deleted;

    /// <summary>The newest one; null before the first.</summary>
    public string? Current => _current;

    public int Count => Volatile.Read(ref _count);

    public int Deleted => Volatile.Read(ref _deleted);

    /// <summary>Makes the next file, and deletes the oldest where there are too many.</summary>
    /// <exception cref="IOException">It cannot be made.</exception>
    public Stream CreateNext(long utcMicroseconds)
    {
        _stem ??= Path.Combine(options.Folder, options.Name + "-" + Epoch.AddTicks(utcMicroseconds * 10)
            .ToString("yyyyMMdd-HHmmss", CultureInfo.InvariantCulture));
        string path;
        do
            path = ++_number == 1 ? _stem + ".tlog" : FormattableString.Invariant($"{_stem}-{_number}.tlog");
        while (File.Exists(path));

        Stream stream = options.CreatesFile(path);
        _current = path;
        _kept.Enqueue(path);
        if (_kept.Count > options.MaxFiles)
            DeleteOldest();
        Volatile.Write(ref _count, _kept.Count);
        return stream;
    }

    /// <summary>Deletes the newest file, which holds nothing; its number is free again.</summary>
    public void DeleteEmpty()
    {
        if (_current is not { } path)
            return;
        File.Delete(path);
        string[] rest = _kept.ToArray();
        _kept.Clear();
        for (int i = 0; i < rest.Length - 1; i++)
            _kept.Enqueue(rest[i]);
        _current = rest.Length > 1 ? rest[rest.Length - 2] : null;
        _number--;
        Volatile.Write(ref _count, _kept.Count);
    }

    // One that cannot be deleted is no reason to record no more.
    private void DeleteOldest()
    {
        string oldest = _kept.Dequeue();
        try
        {
            File.Delete(oldest);
            Interlocked.Increment(ref _deleted);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // It stays, and is counted as kept no more.
        }
    }
}
