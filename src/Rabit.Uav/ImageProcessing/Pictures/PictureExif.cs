using System;
using System.IO;
using System.Linq;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>When a picture was taken by its EXIF: of a file whose name does not say it.</summary>
internal static class PictureExif
{
    private const string NoTimeInName =
        "its name does not say when it was taken, as f000123_1732190000123456_e2000.png does";

    // As other sources take it to be that do not say it.
    private static readonly TimeSpan UsualExposure = TimeSpan.FromMilliseconds(5);

    /// <summary>Reads it.</summary>
    /// <param name="folder">Of the camera.</param>
    /// <param name="name">Of the file in it.</param>
    /// <returns>The picture, with a time in the middle of what the decimals of its EXIF leave open.</returns>
    /// <exception cref="PictureException">It says no time, or not of which zone.</exception>
    public static ListedPicture Read(CameraFolder folder, string name)
    {
        string path = Path.Combine(folder.Path, name);
        PhotoMetadata photo = ReadHead(path);
        if (photo.TakenLocal is not { } taken)
            throw new PictureException(path, NoTimeInName + ", nor does its EXIF"
                + photo.Faults.Where(f => f.StartsWith("EXIF", StringComparison.Ordinal)).Select(f => " (" + f + ")")
                    .FirstOrDefault());
        if ((photo.UtcOffset ?? folder.ExifUtcOffset) is not { } offset)
            throw new PictureException(
                path, "its EXIF says when it was taken, but not in which zone: "
                    + $"camera.json may have it, as \"{CameraDescription.ExifUtcOffset}\": \"+02:00\"");
        TimeSpan step = photo.TakenResolution ?? TimeSpan.FromSeconds(1);
        long start = (taken - offset - PictureFolderWriter.Epoch.UtcDateTime + TimeSpan.FromTicks(step.Ticks / 2)).Ticks
            / PictureFolderWriter.TicksPerMicrosecond;
        long exposure = (photo.ExposureTime ?? UsualExposure).Ticks / PictureFolderWriter.TicksPerMicrosecond;
        if (!PictureFileName.IsPossible(start, exposure))
            throw new PictureException(path, "the time in its EXIF is before 1970");
        return new ListedPicture(
            name, new PictureFileName(0, start, exposure),
            TimeSpan.FromTicks((long)(step.Ticks / Math.Sqrt(12))));
    }

    private static PhotoMetadata ReadHead(string path)
    {
        try
        {
            return PhotoMetadata.ReadHead(path);
        }
        catch (PictureException e)
        {
            throw new PictureException(path, NoTimeInName + ", and its EXIF cannot be read: " + e.Reason, e);
        }
    }
}
