using Rabit.Vision;

namespace UavConsole;

/// <summary>What the camera saw of a target: a small piece of one picture. Immutable.</summary>
internal sealed class ImageChipPng(long lookNumber, int reportIndex, RgbPicture picture)
{
    /// <summary>Number of the picture.</summary>
    public long PictureNumber { get; } = lookNumber;

    /// <summary>Which report of that picture.</summary>
    public int ReportIndex { get; } = reportIndex;

    /// <summary>The piece.</summary>
    public RgbPicture Picture { get; } = picture;
}
