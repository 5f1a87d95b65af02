using System;
using System.IO;
using System.Text;
using Rabit.Core;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Writes the progress file on the writer's thread, since a disk may take its time: a new file beside the old one,
/// flushed to the disk, then renamed over it. Whenever power or program end, one of the two is there and whole.
/// </summary>
internal sealed class ProgressFileTarget(string path) : IWriterTarget<ProgressSnapshot>
{
    private static readonly UTF8Encoding Utf8 = new(encoderShouldEmitUTF8Identifier: false);

    // Written by the writer's thread, read by the manager's; replaced as a whole.
    private volatile string? _fault;

    /// <summary>A write is short and ends by itself; there is nothing to unblock.</summary>
    public bool Blocks => false;

    /// <summary>Why the last write did not succeed; null where it did. Any thread.</summary>
    public string? Fault => _fault;

    public void Open()
    {
    }

    public void Write(in ProgressSnapshot value)
    {
        try
        {
            byte[] bytes = Utf8.GetBytes(MissionProgressFormat.Write(value));
            string next = path + ".new";
            using (var file = new FileStream(next, FileMode.Create, FileAccess.Write))
            {
                file.Write(bytes, 0, bytes.Length);
                file.Flush(flushToDisk: true);
            }

            if (File.Exists(path))
                File.Replace(next, path, destinationBackupFileName: null);
            else
                File.Move(next, path);
            _fault = null;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException)
        {
            _fault = e.Message;
        }
        finally
        {
            value.IsFree = true;
        }
    }

    public void Unblock()
    {
    }

    public void Close()
    {
    }
}
