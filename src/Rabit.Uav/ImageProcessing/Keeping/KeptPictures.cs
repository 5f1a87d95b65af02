using System;
using System.Threading;
using Rabit.Core;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Hands copies of pictures to the writer of the folder, so that the camera has its buffers back at once. For the
/// thread of the manager.
/// </summary>
internal sealed class KeptPictures(
    KeptPictureOptions options, PictureKeeper keeper, BlockingWriter<PictureToKeep> writer, int bufferBytes)
{
    public const string NoRoom = "the folder of the kept pictures is too slow: no room for another one";

    private readonly BufferPool _pool = new("kept pictures", options.PicturesWaiting, bufferBytes);
    private long _withoutRoom;
    private string? _logged;

    /// <summary>Whether a picture is one of those that are kept.</summary>
    public bool Wants(in CameraObservation observation) => options.KeepsAll || observation.Reports.Length > 0;

    /// <summary>Keeps a picture. It stays the caller's.</summary>
    /// <param name="frame">The picture.</param>
    /// <param name="metadata">What it is to say of itself.</param>
    /// <param name="frameStartUtc">When its exposure began.</param>
    public void Add(in CameraFrame frame, PhotoMetadata metadata, DateTimeOffset frameStartUtc)
    {
        if (!_pool.TryRent(ImageProcessingManager.ManagerName, out BufferLease pixels))
        {
            Interlocked.Increment(ref _withoutRoom);
            return;
        }

        Buffer.BlockCopy(frame.Pixels.Array, 0, pixels.Array, 0, frame.Width * frame.Height * 3);
        var picture = new PictureToKeep
        {
            Pixels = pixels,
            Width = frame.Width,
            Height = frame.Height,
            Metadata = metadata,
            Name = new PictureFileName(
                frame.Number, PictureFolderWriter.ToMicroseconds(frameStartUtc),
                frame.Exposure.Ticks / PictureFolderWriter.TicksPerMicrosecond),
        };
        if (writer.Push(picture) != PushResult.Rejected)
            return;
        picture.Dispose();
        Interlocked.Increment(ref _withoutRoom);
    }

    /// <summary>What became of them. Any thread.</summary>
    public KeptPictureCounts Count()
    {
        long withoutRoom = Interlocked.Read(ref _withoutRoom);
        return new KeptPictureCounts(
            keeper.Kept, keeper.Lost + withoutRoom + writer.Discarded,
            keeper.Fault ?? (withoutRoom > 0 ? NoRoom : null));
    }

    /// <summary>Logs the first that is not kept, and each new reason.</summary>
    public void LogFault(Action<string> log)
    {
        if (Count().LastFault is not { } fault || fault == _logged)
            return;
        _logged = fault;
        log($"a picture is not kept: {fault}");
    }
}
