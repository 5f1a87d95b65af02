using System.Collections.Generic;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Where pictures of a flight are kept: as PNG, each of which says by EXIF and XMP where it was taken and how its
/// camera was turned, so that <c>rabit geolocate</c> and programs of photogrammetry can use it alone.
/// </summary>
/// <example>
/// <code>
/// options.Imaging.KeptPictures = new KeptPictureOptions { Folder = "/home/pi/pictures" };
/// </code>
/// </example>
public sealed class KeptPictureOptions
{
    // A program that asks for more has made a mistake.
    private const int MaxWaiting = 100;

    /// <summary>The folder, which is made where it is not there.</summary>
    /// <value>The default is "pictures", in the current folder.</value>
    public string Folder { get; set; } = "pictures";

    /// <summary>
    /// Whether every picture that was searched is kept; else those in which something was reported.
    /// </summary>
    /// <value>The default is false.</value>
    public bool KeepsAll { get; set; }

    /// <summary>How many bytes they may have together; those that come after are counted.</summary>
    /// <value>The default is 4 GB: some 8000 pictures of 640 x 480, 120 of 12 megapixels.</value>
    public long MaxBytes { get; set; } = 4_000_000_000;

    /// <summary>
    /// How many pictures may wait for the disk, 1 to 100; those for which there is no room are counted. So many buffers
    /// of the size of a picture are held for them.
    /// </summary>
    /// <value>The default is 3.</value>
    public int PicturesWaiting { get; set; } = 3;

    internal KeptPictureOptions Copy() => (KeptPictureOptions)MemberwiseClone();

    internal IEnumerable<string> FindFaults()
    {
        if (string.IsNullOrWhiteSpace(Folder))
            yield return "the folder of the kept pictures is empty; \".\" is the current one";
        if (MaxBytes < 1)
            yield return $"{nameof(MaxBytes)} of the kept pictures is {MaxBytes}; it must be at least 1";
        if (PicturesWaiting is < 1 or > MaxWaiting)
            yield return $"{nameof(PicturesWaiting)} is {PicturesWaiting}; it must be 1 to {MaxWaiting}";
    }
}
