using System;
using System.Collections.Generic;

namespace Rabit.Mavlink;

/// <summary>
/// The files that a <see cref="MavlinkFtpServer"/> serves. Paths are relative to the root, with '/' between the names,
/// without one in front, and without "." and "..": the server has checked them. The root is "".
/// <see cref="MavlinkMemoryFiles"/> is one.
/// </summary>
public interface IMavlinkFileStore
{
    /// <summary>Looks a file up.</summary>
    /// <param name="path">Its path.</param>
    /// <param name="content">
    /// All of it. A download reads from this very memory to its end: what is changed later is another content.
    /// </param>
    /// <returns>Whether there is such a file.</returns>
    bool TryGetFile(string path, out ReadOnlyMemory<byte> content);

    /// <summary>Lists a directory.</summary>
    /// <param name="path">Its path.</param>
    /// <param name="entries">What is in it, in an order that stays while nothing changes.</param>
    /// <returns>Whether there is such a directory.</returns>
    bool TryGetDirectory(string path, out IReadOnlyList<MavlinkFileEntry> entries);
}
