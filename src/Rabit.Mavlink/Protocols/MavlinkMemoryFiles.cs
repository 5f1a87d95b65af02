using System;
using System.Collections.Generic;

namespace Rabit.Mavlink;

/// <summary>Files in memory, for a <see cref="MavlinkFtpServer"/>. One thread.</summary>
/// <example>
/// <code>
/// var files = new MavlinkMemoryFiles();
/// files.Set("targets/1.jpg", new byte[] { 0xFF, 0xD8 });
/// var server = new MavlinkFtpServer(new MavlinkSender(1, 191), files);
/// </code>
/// </example>
public sealed class MavlinkMemoryFiles : IMavlinkFileStore
{
    private readonly SortedDictionary<string, ReadOnlyMemory<byte>> _files = new(StringComparer.Ordinal);

    /// <summary>How many files there are.</summary>
    public int Count => _files.Count;

    /// <summary>Adds a file, or replaces its content; the directories are those of its path.</summary>
    /// <param name="path">Names with '/' between them.</param>
    /// <param name="content">Its content, which must not be changed any more.</param>
    /// <exception cref="ArgumentException">No path that a station could ask for.</exception>
    public void Set(string path, ReadOnlyMemory<byte> content)
    {
        if (!MavlinkFtpServer.TryNormalise(path, out string normal) || normal.Length == 0)
            throw new ArgumentException($"'{path}' is no path of a file.", nameof(path));
        _files[normal] = content;
    }

    /// <summary>Takes a file away; downloads of it under way go on.</summary>
    /// <param name="path">Its path.</param>
    /// <returns>Whether it was there.</returns>
    public bool Remove(string path) => MavlinkFtpServer.TryNormalise(path, out string normal) && _files.Remove(normal);

    /// <inheritdoc/>
    public bool TryGetFile(string path, out ReadOnlyMemory<byte> content) => _files.TryGetValue(path, out content);

    /// <inheritdoc/>
    public bool TryGetDirectory(string path, out IReadOnlyList<MavlinkFileEntry> entries)
    {
        var found = new List<MavlinkFileEntry>();
        string prefix = path.Length == 0 ? "" : path + "/";
        foreach (KeyValuePair<string, ReadOnlyMemory<byte>> file in _files)
        {
            if (!file.Key.StartsWith(prefix, StringComparison.Ordinal))
                continue;
            int slash = file.Key.IndexOf('/', prefix.Length);
            string name = file.Key.Substring(
                prefix.Length, (slash < 0 ? file.Key.Length : slash) - prefix.Length);
            bool isKnown = slash >= 0 && found.Exists(entry => entry.IsDirectory && entry.Name == name);
            if (!isKnown)
                found.Add(new MavlinkFileEntry(name, slash < 0 ? file.Value.Length : 0, slash >= 0));
        }

        entries = found;
        return found.Count > 0 || path.Length == 0;
    }
}
