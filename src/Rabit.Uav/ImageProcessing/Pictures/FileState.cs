using System;
using System.IO;

namespace Rabit.Uav.ImageProcessing;

/// <summary>By what it is seen that a file was written to: its size and its time. A plain value.</summary>
internal readonly record struct FileState(long Bytes, DateTime Written)
{
    /// <summary>How a file is now; of one that is not there, or not to be seen, always the same.</summary>
    public static FileState Of(string path)
    {
        try
        {
            var file = new FileInfo(path);
            return file.Exists ? new FileState(file.Length, file.LastWriteTimeUtc) : default;
        }
        catch (Exception e) when (FileFaults.IsFileFault(e))
        {
            return default;
        }
    }
}
