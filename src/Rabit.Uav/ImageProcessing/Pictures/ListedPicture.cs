using System;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// A picture of a camera's folder: its file, and what its name, camera.json or its EXIF says of it.
/// </summary>
internal sealed class ListedPicture(string file, PictureFileName facts, TimeSpan? exifNoise = null)
{
    /// <summary>Within the folder.</summary>
    public string File { get; } = file;

    /// <summary>Whether it appeared while the folder was watched, so that it may still be being written.</summary>
    public bool IsNew { get; set; }

    public PictureFileName Facts { get; } = facts;

    /// <summary>
    /// Where the time is that of its EXIF, which has no number of the picture: how far that is rounded, one standard
    /// deviation.
    /// </summary>
    public TimeSpan? ExifNoise { get; } = exifNoise;
}
