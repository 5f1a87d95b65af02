using System;
using System.Collections.Generic;
using System.Text;

namespace Rabit.Vision;

/// <summary>Finds EXIF and XMP among the segments of a JPEG, before its pixels.</summary>
internal static class MetadataSegments
{
    private static readonly byte[] ExifName = [(byte)'E', (byte)'x', (byte)'i', (byte)'f', 0, 0];
    private static readonly byte[] ExtensionName = Encoding.ASCII.GetBytes("http://ns.adobe.com/xmp/extension/\0");
    private static readonly byte[] XmpName = Encoding.ASCII.GetBytes("http://ns.adobe.com/xap/1.0/\0");

    public static PhotoMetadata Read(byte[] file)
    {
        var photo = new PhotoMetadata();
        var faults = new List<string>();
        (bool hasExif, bool hasXmp, bool hasExtension, bool isWhole) = (false, false, false, false);
        int at = 2;
        while (TryNext(file, ref at, out int marker, out int content, out int length))
        {
            isWhole = marker == JpegMarker.Scan;
            if (isWhole)
                break;
            if (JpegMarker.IsFrame(marker) && length >= 6)
                (photo.Height, photo.Width) = (Size(file, content + 1), Size(file, content + 3));
            if (marker != JpegMarker.App1)
                continue;
            if (!hasExif && StartsWith(file, content, length, ExifName))
            {
                hasExif = true;
                new ExifReader(
                    file, content + ExifName.Length, length - ExifName.Length, photo, faults).Read();
            }
            else if (!hasXmp && StartsWith(file, content, length, XmpName))
            {
                hasXmp = true;
                XmpReader.Read(
                    Encoding.UTF8.GetString(file, content + XmpName.Length, length - XmpName.Length), photo, faults);
            }
            else if (!hasExtension && StartsWith(file, content, length, ExtensionName))
            {
                // What finds no room in a segment; of a drone that is no angle or height, but what else was added.
                hasExtension = true;
                faults.Add("XMP: its extension (ExtendedXMP) is not read");
            }
        }

        if (!isWhole)
            faults.Add("JPEG: it is cut off before its pixels");
        photo.Faults = faults;
        return photo;
    }

    private static bool TryNext(byte[] file, ref int at, out int marker, out int content, out int length)
    {
        (marker, content, length) = (0, 0, 0);
        for (; at < file.Length - 3; at++)
        {
            if (file[at] != 0xFF || file[at + 1] is 0 or 0xFF || JpegMarker.IsAlone(file[at + 1]))
                continue;
            marker = file[at + 1];
            length = ((file[at + 2] << 8) | file[at + 3]) - 2;
            content = at + 4;
            if (length < 0 || length > file.Length - content)
                return false;
            at = content + length;
            return true;
        }

        return false;
    }

    private static int? Size(byte[] file, int at) => ((file[at] << 8) | file[at + 1]) is > 0 and int size ? size : null;

    private static bool StartsWith(byte[] file, int at, int length, byte[] name)
        => length >= name.Length && file.AsSpan(at, name.Length).SequenceEqual(name);
}
