using System;
using System.IO;
using System.Threading;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Writes a camera's pictures into its folder, under the names that <see cref="FolderCamera"/> reads. Each is written
/// under another name and then renamed, so that a reader of the folder never sees half a picture. One thread writes.
/// </summary>
public sealed class PictureFolderWriter
{
    private readonly string _folder;
    private long _written;

    /// <summary>Makes the writer.</summary>
    /// <param name="folder">Where to; see <see cref="CameraFolder.Create"/>.</param>
    public PictureFolderWriter(CameraFolder folder)
    {
        _folder = (folder ?? throw new ArgumentNullException(nameof(folder))).Path;
    }

    /// <summary>Pictures written. Any thread.</summary>
    public long Written => Interlocked.Read(ref _written);

    /// <summary>Writes one picture. It stays the caller's.</summary>
    /// <param name="frame">The picture.</param>
    /// <param name="frameStartUtc">When its exposure began, by the wall clock.</param>
    /// <returns>Name of the file, without the folder.</returns>
    /// <exception cref="PictureException">It cannot be written.</exception>
    public string Write(in CameraFrame frame, DateTimeOffset frameStartUtc)
    {
        if (frame.Format != PixelFormat.Rgb24)
            throw new PictureException(_folder, "pictures of a thermal camera are not written");
        var facts = new PictureFileName(
            frame.Number, ToMicroseconds(frameStartUtc), frame.Exposure.Ticks / TicksPerMicrosecond);
        string name = facts.ToFileName();
        string path = Path.Combine(_folder, name);
        PictureFile.Save(PartialFile.PathOf(path), new RgbPicture(frame.Width, frame.Height, frame.Pixels.Array));
        try
        {
            PartialFile.Complete(path);
        }
        catch (Exception e) when (FileFaults.IsFileFault(e))
        {
            throw new PictureException(path, "it cannot be written: " + e.Message, e);
        }

        Interlocked.Increment(ref _written);
        return name;
    }

    internal const long TicksPerMicrosecond = TimeSpan.TicksPerMillisecond / 1000;

    internal static readonly DateTimeOffset Epoch = new(1970, 1, 1, 0, 0, 0, TimeSpan.Zero);

    internal static long ToMicroseconds(DateTimeOffset time) => (time - Epoch).Ticks / TicksPerMicrosecond;
}
