using System;
using System.Collections.Generic;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>Notes which paths get to the files.</summary>
internal sealed class RecordingFileStore(IMavlinkFileStore files, List<string> asked) : IMavlinkFileStore
{
    public bool TryGetFile(string path, out ReadOnlyMemory<byte> content)
    {
        asked.Add(path);
        return files.TryGetFile(path, out content);
    }

    public bool TryGetDirectory(string path, out IReadOnlyList<MavlinkFileEntry> entries)
        => files.TryGetDirectory(path, out entries);
}
