using System;
using System.Collections.Generic;
using System.Globalization;
using System.Text;

namespace Rabit.Vision;

/// <summary>
/// Writes EXIF (CIPA DC-008-2019) as <see cref="ExifReader"/> reads it: a TIFF with one directory of the picture, one
/// of its exposure and one of its position. Numbers are big-endian. What is no number, or out of its range, is left
/// out: a reader would take it for another one.
/// </summary>
internal static class ExifWriter
{
    private const int HeaderBytes = 8;
    private const int MaxDigits = 6;

    public static byte[] Write(PhotoMetadata photo)
    {
        var picture = new ExifDirectory();
        ExifDirectory exposure = ExposureOf(photo);
        ExifDirectory position = PositionOf(photo);
        picture.AddText(0x010F, photo.Make);
        picture.AddText(0x0110, photo.Model);
        if (photo.Orientation is { } orientation and >= 1 and <= 8)
            picture.AddShort(0x0112, orientation);

        // Their lengths are known before the places of the other two are.
        int exposureAt = HeaderBytes + picture.BytesWith(moreNumbers: 2);
        int positionAt = exposureAt + exposure.BytesWith(moreNumbers: 0);
        picture.AddLong(0x8769, exposureAt);
        picture.AddLong(0x8825, positionAt);
        List<byte> all = [(byte)'M', (byte)'M', 0, 42, 0, 0, 0, HeaderBytes];
        picture.AppendTo(all);
        exposure.AppendTo(all);
        position.AppendTo(all);
        return [.. all];
    }

    private static ExifDirectory ExposureOf(PhotoMetadata photo)
    {
        var exposure = new ExifDirectory();
        if (photo.ExposureTime?.ExactSeconds is { } seconds and > 0 and <= ExifReader.MaxExposureSeconds)
            exposure.AddRationals(0x829A, seconds);
        exposure.AddUndefined(0x9000, Encoding.ASCII.GetBytes("0232"));
        if (photo.TakenLocal is { Year: > 1 and < 9999 } taken)
        {
            exposure.AddText(0x9003, taken.ToString("yyyy:MM:dd HH:mm:ss", CultureInfo.InvariantCulture));
            if (photo.UtcOffset is { } offset)
                exposure.AddText(0x9011, (offset < TimeSpan.Zero ? "-" : "+")
                    + offset.ToString("hh\\:mm", CultureInfo.InvariantCulture));
            int digits = DigitsOf(photo.TakenResolution);
            if (digits > 0)
                exposure.AddText(
                    0x9291, taken.ToString("ffffff", CultureInfo.InvariantCulture).Substring(0, digits));
        }

        if (photo.FocalLengthMillimetres is { } focal and > 0 and < ExifReader.MaxNumber)
            exposure.AddRationals(0x920A, focal);
        if (photo.PixelWidth is { } width and > 0)
            exposure.AddLong(0xA002, width);
        if (photo.PixelHeight is { } height and > 0)
            exposure.AddLong(0xA003, height);
        if (photo.FocalLength35MillimetreEquivalentMillimetres is { } equivalent and > 0 and < ExifReader.MaxNumber)
            exposure.AddShort(0xA405, (int)Math.Max(1, Math.Min(Math.Round(equivalent), ushort.MaxValue)));
        return exposure;
    }

    // Of a second.
    private static int DigitsOf(TimeSpan? resolution)
        => resolution is not { } step ? MaxDigits
            : (int)Math.Max(0, Math.Min(MaxDigits, Math.Round(-Math.Log10(Math.Max(1e-7, step.ExactSeconds)))));

    private static ExifDirectory PositionOf(PhotoMetadata photo)
    {
        var position = new ExifDirectory();
        position.AddBytes(0, 2, 3, 0, 0);
        if (photo.LatitudeDegrees is { } latitude and >= -90 and <= 90
            && photo.LongitudeDegrees is { } longitude and >= -180 and <= 180)
        {
            position.AddText(1, latitude < 0 ? "S" : "N");
            position.AddRationals(2, Sexagesimal(latitude));
            position.AddText(3, longitude < 0 ? "W" : "E");
            position.AddRationals(4, Sexagesimal(longitude));
        }

        if (photo.AltitudeAmslMetres is { } altitude and > -ExifReader.MaxMetres and < ExifReader.MaxMetres)
        {
            position.AddBytes(5, (byte)(altitude < 0 ? 1 : 0));
            position.AddRationals(6, Math.Abs(altitude));
        }

        if (photo.PositionTimeUtc is { } time)
            position.AddRationals(
                7, time.UtcDateTime.Hour, time.UtcDateTime.Minute,
                (time.UtcDateTime.TimeOfDay.ExactSeconds % 60));
        if (photo.ImageDirectionDegrees is { } direction and > -ExifReader.MaxNumber and < ExifReader.MaxNumber)
        {
            position.AddText(0x10, photo.IsImageDirectionMagnetic ? "M" : "T");
            position.AddRationals(0x11, direction - (360 * Math.Floor(direction / 360)));
        }

        if (photo.PositionTimeUtc is { } day)
            position.AddText(0x1D, day.UtcDateTime.ToString("yyyy:MM:dd", CultureInfo.InvariantCulture));
        return position;
    }

    private static double[] Sexagesimal(double degrees)
    {
        degrees = Math.Abs(degrees);
        double whole = Math.Floor(degrees);
        double minutes = Math.Floor((degrees - whole) * 60);
        return [whole, minutes, Math.Max(0, (degrees - whole - (minutes / 60)) * 3600)];
    }
}
