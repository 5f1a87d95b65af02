using System;
using System.Collections.Generic;
using System.Text;

namespace Rabit.Vision;

/// <summary>
/// EXIF and XMP in a PNG: the chunk eXIf (PNG, third edition, 11.3.3.6), and iTXt with the keyword that XMP has (ISO
/// 16684-3).
/// </summary>
internal static class PngMetadata
{
    public const uint Exif = 0x65584966;
    public const uint InternationalText = 0x69545874;

    private const uint Text = 0x74455874;
    private const uint CompressedText = 0x7A545874;

    private static readonly byte[] RawProfile = Encoding.ASCII.GetBytes("Raw profile type ");
    private static readonly byte[] XmpKeyword = Encoding.ASCII.GetBytes("XML:com.adobe.xmp\0");

    /// <summary>The content of the chunk that holds XMP: not compressed, without a language.</summary>
    public static byte[] XmpChunk(string xmp) => [.. XmpKeyword, 0, 0, 0, 0, .. Encoding.UTF8.GetBytes(xmp)];

    /// <summary>Reads what a PNG says of itself, up to its end; what is damaged there ends it.</summary>
    public static PhotoMetadata Read(byte[] file)
    {
        var photo = new PhotoMetadata();
        var faults = new List<string>();
        long at = PngPicture.Signature.Length;
        while (at + 12 <= file.Length)
        {
            long length = PngPicture.GetNumber(file, (int)at);
            if (at + 12 + length > file.Length)
            {
                faults.Add("PNG: it is cut off");
                break;
            }

            Take(file, PngPicture.GetNumber(file, (int)at + 4), (int)at + 8, (int)length, photo, faults);
            at += 12 + length;
        }

        photo.Faults = faults;
        return photo;
    }

    private static void Take(
        byte[] file, uint type, int content, int length, PhotoMetadata photo, List<string> faults)
    {
        switch (type)
        {
            case PngPicture.Header when length >= 8:
                photo.Width = SizeOf(PngPicture.GetNumber(file, content));
                photo.Height = SizeOf(PngPicture.GetNumber(file, content + 4));
                break;
            case Exif:
                new ExifReader(file, content, length, photo, faults).Read();
                break;
            case InternationalText:
                TakeText(file, content, length, photo, faults);
                break;
            case Text or CompressedText when IsRawProfile(file, content, length):
                faults.Add("PNG: the profile that ImageMagick made of its EXIF or XMP is not read");
                break;
        }
    }

    // "exif", "xmp" and "APP1", as text; profiles of colours ("icc") say nothing of the camera.
    private static bool IsRawProfile(byte[] file, int content, int length)
    {
        int name = content + RawProfile.Length;
        return length > RawProfile.Length + 3 && file.AsSpan(content, RawProfile.Length).SequenceEqual(RawProfile)
            && (char)file[name] is 'e' or 'x' or 'A';
    }

    // Behind the keyword: whether it is compressed, how, a language and a translated keyword, each ended by 0.
    private static void TakeText(byte[] file, int content, int length, PhotoMetadata photo, List<string> faults)
    {
        int from = XmpKeyword.Length + 2;
        if (length < from + 2 || !file.AsSpan(content, XmpKeyword.Length).SequenceEqual(XmpKeyword))
            return;
        if (file[content + XmpKeyword.Length] != 0)
        {
            faults.Add("XMP: it is compressed, which is not read");
            return;
        }

        for (int zeros = 0; zeros < 2 && from < length; from++)
            zeros += file[content + from] == 0 ? 1 : 0;
        XmpReader.Read(Encoding.UTF8.GetString(file, content + from, length - from), photo, faults);
    }

    private static int? SizeOf(uint size) => size is > 0 and <= int.MaxValue ? (int)size : null;
}
