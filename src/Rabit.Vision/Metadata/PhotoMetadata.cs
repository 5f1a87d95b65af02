using System;
using System.Collections.Generic;
using System.Globalization;

namespace Rabit.Vision;

/// <summary>
/// What a photo says of itself, by EXIF (CIPA DC-008) and XMP (ISO 16684, with the properties of DJI's drones): when
/// and where it was taken, with what, and how the camera was turned. Null stands for what it does not say. One thread.
/// </summary>
/// <remarks>
/// A drone's angles are against north and the horizon: the gimbal's are those of its camera, the flight's those of the
/// aircraft. Nothing here was checked against the world: a barometric altitude may be wrong by more than 10 m, and
/// programs that turn or shrink a picture often leave the rest as it was.
/// </remarks>
/// <example>
/// <code>
/// PhotoMetadata photo = PhotoMetadata.Read(File.ReadAllBytes("DJI_0018.JPG"), "DJI_0018.JPG");
/// Console.WriteLine($"{photo.Model} at {photo.LatitudeDegrees}, {photo.LongitudeDegrees}, "
///     + $"{photo.RelativeAltitudeMetres} m above its take-off, looking down by {photo.GimbalPitchDegrees}");
/// </code>
/// </example>
public sealed class PhotoMetadata
{
    // EXIF and XMP are in segments of at most 64 KB each, which stand first.
    private const int HeadBytes = 256 * 1024;

    /// <summary>Maker of the camera.</summary>
    public string? Make { get; set; }

    /// <summary>Model of the camera.</summary>
    public string? Model { get; set; }

    /// <summary>When it was taken by the camera's clock, whose zone may be unknown.</summary>
    public DateTime? TakenLocal { get; set; }

    /// <summary>
    /// Of what step <see cref="TakenLocal"/> is a multiple: a second, or less where the photo has decimals of it. What
    /// is less was cut off.
    /// </summary>
    public TimeSpan? TakenResolution { get; set; }

    /// <summary>What the camera's clock is ahead of UTC.</summary>
    public TimeSpan? UtcOffset { get; set; }

    /// <summary>When it was taken, where the zone of the camera's clock is known.</summary>
    public DateTimeOffset? Taken
        => TakenLocal is { } local && UtcOffset is { } offset ? new DateTimeOffset(local, offset) : null;

    /// <summary>How long it was exposed.</summary>
    public TimeSpan? ExposureTime { get; set; }

    /// <summary>Time of the position by satellite navigation, UTC.</summary>
    public DateTimeOffset? PositionTimeUtc { get; set; }

    /// <summary>Columns of the picture in the file.</summary>
    public int? Width { get; set; }

    /// <summary>Rows of the picture in the file.</summary>
    public int? Height { get; set; }

    /// <summary>Columns that the picture had when it was taken.</summary>
    public int? PixelWidth { get; set; }

    /// <summary>Rows that the picture had when it was taken.</summary>
    public int? PixelHeight { get; set; }

    /// <summary>How the pixels are to be turned to be seen upright, 1 (not at all) to 8, as EXIF numbers it.</summary>
    public int? Orientation { get; set; }

    /// <summary>Latitude of the camera, WGS84, north positive.</summary>
    public double? LatitudeDegrees { get; set; }

    /// <summary>Longitude of the camera, WGS84, east positive.</summary>
    public double? LongitudeDegrees { get; set; }

    /// <summary>Altitude of the camera, as EXIF has it: above mean sea level, below it negative.</summary>
    public double? AltitudeAmslMetres { get; set; }

    /// <summary>Where the camera looked, clockwise from north, as EXIF has it.</summary>
    public double? ImageDirectionDegrees { get; set; }

    /// <summary>Whether that is magnetic north.</summary>
    public bool IsImageDirectionMagnetic { get; set; }

    /// <summary>Focal length.</summary>
    public double? FocalLengthMillimetres { get; set; }

    /// <summary>
    /// Focal length of a camera with a film of 36 mm x 24 mm that would see as much; a whole number, so wrong by 2 %.
    /// </summary>
    public double? FocalLength35MillimetreEquivalentMillimetres { get; set; }

    /// <summary>
    /// Focal length in pixels, as a calibrated camera has it (DJI's CalibratedFocalLength); more exact than the others.
    /// </summary>
    public double? FocalLengthPixels { get; set; }

    /// <summary>
    /// Its calibrated lens (DJI's DewarpData); null where it is not known, or the picture has been corrected for it.
    /// </summary>
    public PhotoLens? Lens { get; set; }

    /// <summary>Roll of the camera about its line of sight, right side down positive.</summary>
    public double? GimbalRollDegrees { get; set; }

    /// <summary>Pitch of the camera above the horizon: -90 is straight down.</summary>
    public double? GimbalPitchDegrees { get; set; }

    /// <summary>Yaw of the camera, clockwise from north.</summary>
    public double? GimbalYawDegrees { get; set; }

    /// <summary>Roll of the aircraft.</summary>
    public double? FlightRollDegrees { get; set; }

    /// <summary>Pitch of the aircraft.</summary>
    public double? FlightPitchDegrees { get; set; }

    /// <summary>Yaw of the aircraft, clockwise from north.</summary>
    public double? FlightYawDegrees { get; set; }

    /// <summary>Altitude above the place of take-off.</summary>
    public double? RelativeAltitudeMetres { get; set; }

    /// <summary>Altitude above mean sea level, as the drone has it: mostly by its barometer.</summary>
    public double? AbsoluteAltitudeMetres { get; set; }

    /// <summary>What could not be understood and is therefore missing, one line each.</summary>
    public IReadOnlyList<string> Faults { get; internal set; } = [];

    /// <summary>Reads what a clock is ahead of UTC as EXIF writes it: "+02:00", from -14:00 to +14:00.</summary>
    /// <param name="text">The text; null is none.</param>
    /// <param name="offset">What it says; zero for none.</param>
    public static bool TryParseUtcOffset(string? text, out TimeSpan offset)
    {
        bool isOffset = text is { Length: 6 } && text[0] is '+' or '-';
        offset = default;
        if (!isOffset || !TimeSpan.TryParseExact(
            text!.Substring(1), "hh\\:mm", CultureInfo.InvariantCulture, out TimeSpan size)
            || size > TimeSpan.FromHours(14))
            return false;
        offset = text[0] == '-' ? -size : size;
        return true;
    }

    /// <summary>
    /// Reads what the file of a JPEG or PNG says of itself before its pixels: at most its first 256 KB are read.
    /// </summary>
    /// <param name="path">The file.</param>
    /// <exception cref="PictureException">
    /// There is no such file, it may not be read, or it is neither. What is wrong in the metadata is in
    /// <see cref="Faults"/>.
    /// </exception>
    public static PhotoMetadata ReadHead(string path)
    {
        if (path is null)
            throw new ArgumentNullException(nameof(path));
        return Read(PictureBytes.ReadHead(path, HeadBytes), path);
    }

    /// <summary>Reads what a JPEG or PNG says of itself; its pixels are not looked at.</summary>
    /// <param name="file">The bytes of the file.</param>
    /// <param name="name">What errors call it.</param>
    /// <exception cref="PictureException">
    /// It is neither. What is wrong in the metadata is in <see cref="Faults"/>.
    /// </exception>
    public static PhotoMetadata Read(byte[] file, string name)
    {
        if (file is null)
            throw new ArgumentNullException(nameof(file));
        if (file.AsSpan().StartsWith(PngPicture.Signature))
            return PngMetadata.Read(file);
        if (file.Length < 2 || file[0] != 0xFF || file[1] != JpegMarker.Start)
            throw new PictureException(name, file.Length == 0 ? "the file is empty" : "that is no JPEG and no PNG");
        return MetadataSegments.Read(file);
    }
}
