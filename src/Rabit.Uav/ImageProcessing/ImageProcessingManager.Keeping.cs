using System;
using Rabit.Core;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

// Pictures that are kept as files.
public sealed partial class ImageProcessingManager
{
    /// <summary>
    /// How many pictures were kept in the folder, and how many should have been; null where none are to be kept. Any
    /// thread, also after the run.
    /// </summary>
    public KeptPictureCounts? SummariseKeptPictures() => _kept?.Count();

    private KeptPictures MakeKept(KeptPictureOptions options, CameraModel camera)
    {
        var keeper = new PictureKeeper(options);
        keeper.CheckFolder(nameof(options));
        BlockingWriter<PictureToKeep> writer = AttachWriter("kept pictures", keeper, options.PicturesWaiting);
        return new KeptPictures(options, keeper, writer, camera.Width * camera.Height * 3);
    }

    private void Keep(in CameraFrame frame)
    {
        if (_kept?.Wants(_search!.Observation) != true)
            return;
        DateTimeOffset startUtc = Clock.GetUtcNow() - (Now - frame.FrameStart);
        DateTimeOffset middleUtc = startUtc + (_search.Observation.Time - frame.FrameStart);
        _kept.Add(frame, _search.CreateMetadata(_command.Value, middleUtc), startUtc);
    }
}
