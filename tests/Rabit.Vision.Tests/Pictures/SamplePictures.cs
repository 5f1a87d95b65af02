using System;
using System.IO;
using System.Runtime.InteropServices;
using System.Text;

namespace Rabit.Vision.Tests.Pictures;

/// <summary>
/// The same picture of 4 x 5 pixels in several files, made by Python's zlib, and pictures of any size.
/// </summary>
internal static class SamplePictures
{
    public const int Width = 4;
    public const int Height = 5;

    /// <summary>
    /// RGB with filters 4, 3, 2, 1, 0, its pixels in three chunks, one of them empty, and a text chunk.
    /// </summary>
    public const string Rgb =
        "iVBORw0KGgoAAAANSUhEUgAAAAQAAAAFCAIAAADtz9qMAAAAA3RFWHRhAGLcSaI7AAAAA0lEQVR42mMMRGo9AAAAAElEQVQ1rwYeAAAARklEQVRhPfFLlZddVZ1d1ZGdmW9/rcSWhRIH9SX87JgUoxkUo2UVo60Uo8MZM24ClcWpqsepOsYxbDX5dcux9H/GB5WV2QBMiRUHnOnddQAAAABJRU5ErkJggg==";

    /// <summary>RGBA with filters 1, 2, 3, 4, 4.</summary>
    public const string Rgba =
        "iVBORw0KGgoAAAANSUhEUgAAAAQAAAAFCAYAAABirU3bAAAATUlEQVR42mNkPfGLQZWX3UZVHYgd2W2YuKMZGLijZYHYCojDGZg1c2sZlE3Wyyk72skp+/nIsZgDVajyyjKoqlsxqDqGM7D4wgSiIQIAhgYOLRPI1MMAAAAASUVORK5CYII=";

    /// <summary>Grey (the red channel) with filters 0 to 4.</summary>
    public const string Grey =
        "iVBORw0KGgoAAAANSUhEUgAAAAQAAAAFCAAAAABHxhIHAAAAHklEQVR42mNg1fIvYRRQVVVlUgQC5gA9PT0WXyAXACyyA5ZvSL/HAAAAAElFTkSuQmCC";

    /// <summary>Grey with alpha, filters 3, 3, 1, 4, 2.</summary>
    public const string GreyAlpha =
        "iVBORw0KGgoAAAANSUhEUgAAAAQAAAAFCAQAAADIpIVQAAAAJ0lEQVR42mNm5dRgtWL1ZWXmY5VgAEFGQ05VBhBkMWeAMJh8GSAQAEtKA7hlIPYYAAAAAElFTkSuQmCC";

    /// <summary>Palette.</summary>
    public const string Palette =
        "iVBORw0KGgoAAAANSUhEUgAAAAQAAAAFCAMAAABVc73pAAAAPFBMVEUFyPoQI/okqWsq1QExfvo1MB5P/AhWiztaV0Jo2fp0PQ97snx/mGaN5lig872yDba1NPrXThTaQXX/aPD3UaCoAAAAIUlEQVR42mNgYGbjYmBk5eBhYGHn5mPg5OUXZBAQEmYCAAdAAL8A/C/3AAAAAElFTkSuQmCC";

    /// <summary>16 bits per channel.</summary>
    public const string SixteenBits =
        "iVBORw0KGgoAAAANSUhEUgAAAAQAAAAFEAIAAAC9XwbPAAAAc0lEQVR42g3KMQqBARiA4cegLGIwW5hMFJMMHIANOYCUlekXB5DdaLUqNrsLSBzArGxSfOv7vNIuPiquUnq+MmZacuSVAhqqikYGOla2xtQsA/rWmhIHCztvZybuARtPw8hZJzddBY7qAQ9tc7/YXsr2pv6afx1v77ItuwAAAABJRU5ErkJggg==";

    /// <summary>Interlaced.</summary>
    public const string Interlaced =
        "iVBORw0KGgoAAAANSUhEUgAAAAQAAAAFCAIAAAGayOoaAAAATElEQVR42gFBAL7/AAXI+irVAU/8CHQ9DwAQI/o1MB5aV0J/mGYAMX76Vos7e7J8oPO9AGjZ+o3mWLINttdOFAC1NPraQXX/aPAkqWtnPh1van9ucAAAAABJRU5ErkJggg==";

    /// <summary>Makes a named pipe, which blocks who opens it. Linux only.</summary>
    public static void MakePipe(string path)
    {
        if (MakePipe(Encoding.UTF8.GetBytes(path + "\0"), 0x180) != 0)
            throw new IOException($"{path} cannot be made.");
    }

    /// <summary>What is in all of them.</summary>
    public static byte[] Pixels(bool isGrey = false)
    {
        byte[] pixels = new byte[Width * Height * 3];
        for (int y = 0; y < Height; y++)
        {
            for (int x = 0; x < Width; x++)
            {
                int at = ((y * Width) + x) * 3;
                pixels[at] = (byte)((37 * x) + (11 * y * y) + 5);
                pixels[at + 1] = isGrey ? pixels[at] : (byte)((91 * y) + (13 * x * x) + 200);
                pixels[at + 2] = isGrey ? pixels[at] : (byte)((x * y * 29) + (7 * x) + 250);
            }
        }

        return pixels;
    }

    public static RgbPicture Random(int width, int height, int seed)
    {
        byte[] pixels = new byte[width * height * 3];
        new Random(seed).NextBytes(pixels);
        return new RgbPicture(width, height, pixels);
    }

    [DllImport("libc", EntryPoint = "mkfifo")]
    private static extern int MakePipe(byte[] path, uint mode);

    /// <summary>A new folder that is deleted with this.</summary>
    internal sealed class TemporaryFolder : IDisposable
    {
        public TemporaryFolder()
        {
            Path = System.IO.Path.Combine(System.IO.Path.GetTempPath(), "rabit-" + Guid.NewGuid().ToString("N"));
            Directory.CreateDirectory(Path);
        }

        public string Path { get; }

        public string File(string name) => System.IO.Path.Combine(Path, name);

        public void Dispose() => Directory.Delete(Path, recursive: true);
    }
}
