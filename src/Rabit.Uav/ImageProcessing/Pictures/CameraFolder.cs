using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Files;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// A folder of a camera: "camera.json" says what the camera is like and how it is mounted, and the pictures lie beside
/// it, or come from the source that it names (<see cref="CreateCamera"/>). Immutable.
/// </summary>
/// <remarks>
/// A picture is called "f000123_1732190000123456_e2000.png": number, start of the exposure in microseconds since 1970
/// UTC, exposure in microseconds. Pictures of other names may be listed in camera.json, as "frames" of "file",
/// "frameStartMicroseconds" and "exposureMicroseconds"; of others, the time is that of their EXIF. The form of
/// camera.json is in docs/camera-folder.md.
/// </remarks>
public sealed class CameraFolder
{
    /// <summary>Name of the file that describes the camera.</summary>
    public const string DescriptionFile = "camera.json";

    internal static readonly TimeSpan DefaultTimeNoise = TimeSpan.FromMilliseconds(5);

    internal CameraFolder(string path, CameraModel camera, CameraMount mount, IReadOnlyList<ListedPicture> listed)
    {
        (Path, Camera, Mount, Listed) = (path, camera, mount, listed);
    }

    /// <summary>The folder.</summary>
    public string Path { get; }

    /// <summary>Pinhole and lens.</summary>
    public CameraModel Camera { get; }

    /// <summary>How the camera sits on the vehicle: fixed, or on a gimbal where camera.json says so.</summary>
    public CameraMount Mount { get; }

    /// <summary>
    /// How wrong the times in the names of the pictures, or in camera.json, may be, one standard deviation: it goes
    /// into the error budget of what is seen. "timeNoiseMicroseconds" of camera.json.
    /// </summary>
    /// <value>
    /// The default is 5 ms, assumed, not measured: what writes a picture's name takes the time beside the exposure.
    /// </value>
    public TimeSpan TimeNoise { get; internal init; } = DefaultTimeNoise;

    /// <summary>
    /// What the clock of the camera is ahead of UTC, for pictures whose time only their EXIF says, where that does not
    /// say it. "exifUtcOffset" of camera.json.
    /// </summary>
    public TimeSpan? ExifUtcOffset { get; internal init; }

    /// <summary>Pictures that camera.json lists, by the start of their exposure.</summary>
    internal IReadOnlyList<ListedPicture> Listed { get; }

    /// <summary>Where the pictures come from; null where they lie in the folder.</summary>
    internal CameraSource? Source { get; init; }

    /// <summary>
    /// Makes the camera that is described: the source, where camera.json has one, and else the pictures of the folder.
    /// Nothing is opened before the run begins.
    /// </summary>
    public ICamera CreateCamera() => Source?.CreateCamera() ?? new FolderCamera(this);

    /// <summary>Reads the description of a folder's camera.</summary>
    /// <param name="path">The folder, or the file of the description, whatever its name is.</param>
    /// <exception cref="PictureException">
    /// There is no such folder, no description in it, or a wrong one; the text names all that is wrong.
    /// </exception>
    public static CameraFolder Open(string path)
    {
        if (path is null)
            throw new ArgumentNullException(nameof(path));
        if (File.Exists(path))
            return OpenFile(path);
        if (!Directory.Exists(path))
            throw new PictureException(path, "no such folder");
        string file = System.IO.Path.Combine(path, DescriptionFile);
        if (!File.Exists(file))
            throw new PictureException(
                path, $"there is no {DescriptionFile} in it, which says what the camera is like");
        return OpenFile(file, path);
    }

    /// <summary>Reads the description of a camera from a file of any name; its folder is that of the camera.</summary>
    /// <param name="file">The file, in the form of camera.json.</param>
    /// <exception cref="PictureException">
    /// There is no such file, or a wrong one; the text names all that is wrong.
    /// </exception>
    public static CameraFolder OpenFile(string file)
    {
        if (file is null)
            throw new ArgumentNullException(nameof(file));
        if (!File.Exists(file))
            throw new PictureException(file, "no such file");

        // A device may have no end.
        if (file.StartsWith("/dev/", StringComparison.Ordinal))
            throw new PictureException(
                file,
                $"that is a device; a folder with {DescriptionFile} is wanted, or such a file, with the device in its "
                    + "source");
        return OpenFile(file, System.IO.Path.GetDirectoryName(System.IO.Path.GetFullPath(file))!);
    }

    /// <summary>
    /// Makes a folder, if there is none, and writes the description of its camera, replacing one that is there.
    /// </summary>
    /// <param name="path">The folder.</param>
    /// <param name="camera">Pinhole and lens.</param>
    /// <param name="mount">How it sits on the vehicle.</param>
    /// <param name="gimbalPitch">
    /// Where its gimbal points, if it has one, and stays: up positive; null is straight down.
    /// </param>
    /// <param name="gimbalYaw">The same, right positive.</param>
    /// <exception cref="PictureException">The numbers describe no camera, or the folder cannot be written.</exception>
    public static CameraFolder Create(
        string path, CameraModel camera, CameraMount mount, Angle? gimbalPitch = null, Angle gimbalYaw = default)
    {
        if (path is null)
            throw new ArgumentNullException(nameof(path));
        if (camera is null)
            throw new ArgumentNullException(nameof(camera));
        if (mount is null)
            throw new ArgumentNullException(nameof(mount));
        string file = System.IO.Path.Combine(path, DescriptionFile);
        List<string> faults = camera.FindFaults().Concat(mount.FindFaults()).ToList();
        if (RgbPicture.FindSizeFault(camera.Width, camera.Height) is { } fault)
            faults.Add(fault);
        if (faults.Count > 0)
            throw new PictureException(file, string.Join("; ", faults));

        CameraExtrinsics placement = mount.At(gimbalPitch ?? Angle.FromDegrees(-90), gimbalYaw);
        try
        {
            Directory.CreateDirectory(path);
            File.WriteAllBytes(file, CameraDescription.Write(camera, placement));
        }
        catch (Exception e) when (FileFaults.IsFileFault(e))
        {
            throw new PictureException(file, "it cannot be written: " + e.Message, e);
        }

        var fixedMount = new CameraMount
        {
            FixedBodyFromCamera = placement.BodyFromCamera,
            GimbalLeverArmMetres = placement.PositionMetres
        };
        return new CameraFolder(path, camera, fixedMount, []);
    }

    private static CameraFolder OpenFile(string file, string folder)
    {
        // Who opens a pipe waits for its writer.
        if (SpecialFile.FindKind(file) is { } kind)
            throw new PictureException(file, $"it is {kind}, not a file");
        try
        {
            return CameraDescription.Parse(File.ReadAllBytes(file), file, folder);
        }
        catch (Exception e) when (FileFaults.IsFileFault(e))
        {
            throw new PictureException(file, "it cannot be read: " + e.Message, e);
        }
    }
}
