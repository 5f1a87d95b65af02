using System;
using System.IO;
using System.Threading;
using Rabit.Core;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Writes pictures into a folder, on the writer's thread. It never throws: what the disk does not take is counted, and
/// the next one is tried again. Any thread may read the figures.
/// </summary>
internal sealed class PictureKeeper(KeptPictureOptions options) : IWriterTarget<PictureToKeep>
{
    public const string Full = "the kept pictures have as many bytes as they may have";

    private long _bytes;
    private long _kept;
    private long _lost;
    private volatile string? _fault;

    public bool Blocks => false;

    /// <summary>Pictures that are in the folder.</summary>
    public long Kept => Interlocked.Read(ref _kept);

    /// <summary>Pictures that could not be written.</summary>
    public long Lost => Interlocked.Read(ref _lost);

    /// <summary>Why the last one could not; null while all goes well.</summary>
    public string? Fault => _fault;

    /// <summary>Finds out before the run whether the folder can be written.</summary>
    /// <exception cref="ArgumentException">It cannot.</exception>
    public void CheckFolder(string parameter)
    {
        try
        {
            Directory.CreateDirectory(options.Folder);
            string probe = Path.Combine(options.Folder, $".{Guid.NewGuid():N}{PartialFile.Ending}");
            File.WriteAllBytes(probe, new byte[1]);
            File.Delete(probe);
        }
        catch (Exception e) when (FileFaults.IsFileFault(e))
        {
            throw new ArgumentException(
                $"the folder of the kept pictures, {options.Folder}, cannot be written: {e.Message.TrimEnd('.')}",
                parameter, e);
        }
    }

    public void Open()
    {
    }

    public void Write(in PictureToKeep value)
    {
        try
        {
            Write(value, PngPicture.Encode(
                new RgbPicture(value.Width, value.Height, value.Pixels.Array), value.Metadata));
        }
        finally
        {
            value.Dispose();
        }
    }

    public void Unblock()
    {
    }

    public void Close()
    {
    }

    private void Write(in PictureToKeep value, byte[] file)
    {
        string path = Path.Combine(options.Folder, value.Name.ToFileName());
        try
        {
            if (_bytes + file.Length > options.MaxBytes)
                throw new IOException(Full);
            Directory.CreateDirectory(options.Folder);
            File.WriteAllBytes(PartialFile.PathOf(path), file);
            PartialFile.Complete(path);
            _bytes += file.Length;
            Interlocked.Increment(ref _kept);
            _fault = null;
        }
        catch (Exception e) when (FileFaults.IsFileFault(e))
        {
            Interlocked.Increment(ref _lost);
            _fault = e.Message;
            TryDelete(PartialFile.PathOf(path));
        }
    }

    // Half a picture is none, and takes room.
    private static void TryDelete(string path)
    {
        try
        {
            File.Delete(path);
        }
        catch (Exception e) when (FileFaults.IsFileFault(e))
        {
            // What led here is reported.
        }
    }
}
