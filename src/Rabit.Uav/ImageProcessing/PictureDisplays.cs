using System.Collections.Generic;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>What of the pictures is kept for displays. Image Processing adds; any thread reads.</summary>
internal sealed class PictureDisplays(ImageProcessingOptions options)
{
    private readonly ImageChipBuffer _chips = new(options.MaxImageChips, options.ImageChipSide);
    private readonly PictureOverviewBuffer _overviews = new(options.MaxPictureOverviews, options.PictureOverviewWidth);

    public IReadOnlyList<ImageChip> Chips => _chips.Kept;

    public PictureOverview? FindOverview(long pictureNumber) => _overviews.Find(pictureNumber);

    /// <summary>Keeps what a picture shows of its reports.</summary>
    public void Add(in CameraObservation observation, in CameraFrame frame)
    {
        foreach (TargetReport report in observation.Reports)
            _chips.Add(report.PictureNumber, report.Index, frame, report.CentreX, report.CentreY);
        _overviews.Add(observation, frame.Pixels.Array, frame.Width, frame.Height, frame.Format);
    }
}
