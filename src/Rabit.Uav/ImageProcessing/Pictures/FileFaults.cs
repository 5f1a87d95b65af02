using System;
using System.IO;

namespace Rabit.Uav.ImageProcessing;

/// <summary>Which exceptions mean that a file or folder cannot be used.</summary>
internal static class FileFaults
{
    public static bool IsFileFault(Exception e)
        => e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException;
}
