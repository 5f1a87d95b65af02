using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Vision.Tests.Jpeg;

/// <summary>The files of tests/data/jpeg, and changes of them.</summary>
internal static class JpegFiles
{
    private static readonly string Folder = Path.Combine(Repository.Root, "tests", "data", "jpeg");

    /// <summary>File name, width, height, channels and hash, as libjpeg decodes the file.</summary>
    public static IEnumerable<string[]> Expected
        => File.ReadAllLines(Path.Combine(Folder, "expected.txt")).Select(line => line.Split(' '));

    public static byte[] Read(string name) => File.ReadAllBytes(Path.Combine(Folder, name));

    /// <summary>By our own decoder, whatever is installed.</summary>
    public static RgbPicture Decode(byte[] file, string name, bool mayUseLibrary = false)
    {
        var decoder = new JpegDecoder(mayUseLibrary);
        decoder.Open(file, 0, file.Length, name);
        byte[] pixels = new byte[decoder.Width * decoder.Height * 3];
        decoder.Decode(pixels);
        return new RgbPicture(decoder.Width, decoder.Height, pixels);
    }

    /// <summary>Decodes the file cut after each of its bytes: what is not refused must have all pixels.</summary>
    /// <returns>How often it was refused.</returns>
    public static int CountRefusedCuts(byte[] file, bool mayUseLibrary)
    {
        byte[] whole = Decode(file, "x", mayUseLibrary).Pixels;
        var decoder = new JpegDecoder(mayUseLibrary);
        byte[] pixels = new byte[whole.Length];
        int refused = 0;
        for (int length = 0; length < file.Length; length++)
        {
            try
            {
                decoder.Open(file, 0, length, "x");
                decoder.Decode(pixels);
                Assert.Equal(whole, pixels);
            }
            catch (PictureException)
            {
                refused++;
            }
        }

        return refused;
    }

    /// <summary>FNV-1a of 64 bits over every sample, or over the first of three.</summary>
    public static string HashOf(byte[] pixels, int channels)
    {
        ulong hash = 0xcbf29ce484222325;
        for (int at = 0; at < pixels.Length; at += channels == 1 ? 3 : 1)
            hash = unchecked((hash ^ pixels[at]) * 0x100000001b3);
        return hash.ToString("x16", CultureInfo.InvariantCulture);
    }

    /// <summary>The file without its segments of a marker.</summary>
    public static byte[] Without(byte[] file, int marker)
    {
        var kept = new List<byte> { file[0], file[1] };
        int at = 2;
        while (file[at + 1] != 0xDA)
        {
            int length = 2 + ((file[at + 2] << 8) | file[at + 3]);
            if (file[at + 1] != marker)
                kept.AddRange(file.Skip(at).Take(length));
            at += length;
        }

        kept.AddRange(file.Skip(at));
        return kept.ToArray();
    }

    /// <summary>The file with a segment after its beginning.</summary>
    public static byte[] With(byte[] file, int marker, byte[] content)
    {
        byte[] head = [0xFF, 0xD8, 0xFF, (byte)marker, (byte)((content.Length + 2) >> 8), (byte)(content.Length + 2)];
        return head.Concat(content).Concat(file.Skip(2)).ToArray();
    }

    /// <summary>Where the content of the first segment of a marker begins.</summary>
    public static int Find(byte[] file, int marker)
    {
        int at = 2;
        while (file[at + 1] != marker)
            at += 2 + ((file[at + 2] << 8) | file[at + 3]);
        return at + 4;
    }
}
