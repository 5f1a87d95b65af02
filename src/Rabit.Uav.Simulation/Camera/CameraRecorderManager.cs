using System;
using Rabit.Core;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Takes the pictures of a camera and writes them to a folder, for a reader that watches that folder (see
/// <see cref="FolderCamera"/>): the camera of a simulated vehicle that runs in a process of its own.
/// </summary>
/// <remarks>
/// A picture that cannot be written, because the disk is full for example, ends the writing; the fault is in the log,
/// and the pictures after it are counted in <see cref="PicturesDropped"/>.
/// </remarks>
/// <example>
/// <code>
/// CameraFolder folder = CameraFolder.Create("pictures", world.CameraModel, world.CameraMount);
/// reactor.Add(new CameraRecorderManager(world.CreateCamera(), new PictureFolderWriter(folder)));
/// </code>
/// </example>
public sealed class CameraRecorderManager : RabitManager
{
    /// <summary>The name of the manager.</summary>
    public const string ManagerName = "camera recorder";

    private const int PicturesWaiting = 3;

    private readonly BlockingReader<CameraFrame> _camera;
    private readonly BlockingWriter<RecordedPicture> _folder;
    private readonly PictureFolderWriter _writer;
    private long _dropped;

    /// <summary>Makes the manager.</summary>
    /// <param name="camera">The camera; it must have more buffers than three, as many as wait for the disk.</param>
    /// <param name="writer">Where the pictures go.</param>
    public CameraRecorderManager(IReaderSource<CameraFrame> camera, PictureFolderWriter writer)
        : base(ManagerName)
    {
        _writer = writer ?? throw new ArgumentNullException(nameof(writer));
        _camera = AttachReader(
            "camera", camera ?? throw new ArgumentNullException(nameof(camera)), PicturesWaiting,
            QueueFullMode.DropOldest);
        _folder = AttachWriter("folder", new PictureFolderTarget(writer), PicturesWaiting, QueueFullMode.Reject);
    }

    /// <summary>Pictures written. Any thread.</summary>
    public long PicturesWritten => _writer.Written;

    /// <summary>Pictures that were not written, because the folder was too slow or gave up. Any thread.</summary>
    public long PicturesDropped => System.Threading.Interlocked.Read(ref _dropped);

    /// <inheritdoc/>
    protected override void ExecuteUnitOfWork()
    {
        while (_camera.TryPop(out CameraFrame frame))
        {
            var picture = new RecordedPicture
            {
                Frame = frame,
                FrameStartUtc = Clock.GetUtcNow() - (Now - frame.FrameStart)
            };
            if (_folder.State is DeviceState.Faulted or DeviceState.Ended
                || _folder.Push(picture) == PushResult.Rejected)
            {
                picture.Dispose();
                System.Threading.Interlocked.Increment(ref _dropped);
            }
        }
    }
}
