using System;
using System.IO;
using System.Linq;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>The disk that a directory is on. A disk may take its time, so not on a manager's thread.</summary>
internal sealed class DataDisk(string directory)
{
    private DriveInfo? _drive;
    private bool _isSearched;

    /// <summary>Free space and size, bytes; null where they are not known.</summary>
    public (long Free, long Total)? Read()
    {
        try
        {
            if (!_isSearched)
                _drive = Find();
            _isSearched = true;
            if (_drive is null)
                return null;
            (long free, long total) = (_drive.AvailableFreeSpace, _drive.TotalSize);
            return total > 0 && free >= 0 && free <= total ? (free, total) : null;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException)
        {
            return null;
        }
    }

    // The mount with the longest path: Mono takes no other name for a drive than that.
    private DriveInfo? Find()
    {
        string path = Path.GetFullPath(directory);
        return DriveInfo.GetDrives().Where(d => IsIn(path, d.RootDirectory.FullName))
            .OrderByDescending(d => d.RootDirectory.FullName.Length).FirstOrDefault();
    }

    private static bool IsIn(string path, string root)
    {
        string separator = Path.DirectorySeparatorChar.ToString();
        string prefix = root.EndsWith(separator, StringComparison.Ordinal) ? root : root + separator;
        return (path + separator).StartsWith(prefix, StringComparison.Ordinal);
    }
}
