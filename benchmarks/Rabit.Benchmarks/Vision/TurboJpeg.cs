using System;
using System.Runtime.InteropServices;

namespace Rabit.Benchmarks.Vision;

/// <summary>libturbojpeg, where it is installed (Debian: libturbojpeg0), with the method that Rabit has.</summary>
internal sealed class TurboJpeg : IDisposable
{
    private const string Library = "libturbojpeg.so.0";
    private const int Rgb = 0;
    private const int AccurateDct = 4096;

    private readonly IntPtr _decoder;

    public TurboJpeg()
    {
        _decoder = InitDecompress();
    }

    public static bool IsInstalled { get; } = Find();

    public void Decode(byte[] file, byte[] pixels, int width, int height)
    {
        if (Decompress(_decoder, file, (ulong)file.Length, pixels, width, width * 3, height, Rgb, AccurateDct) != 0)
            throw new InvalidOperationException("libturbojpeg refuses the picture.");
    }

    // Mono has no NativeLibrary, so it is tried.
    private static bool Find()
    {
        try
        {
            new TurboJpeg().Dispose();
            return true;
        }
        catch (DllNotFoundException)
        {
            return false;
        }
    }

    public void Dispose() => _ = Destroy(_decoder);

    [DllImport(Library, EntryPoint = "tjInitDecompress")]
    private static extern IntPtr InitDecompress();

    [DllImport(Library, EntryPoint = "tjDecompress2")]
    private static extern int Decompress(
        IntPtr handle, byte[] file, ulong length, byte[] to, int width, int pitch, int height, int format, int flags);

    [DllImport(Library, EntryPoint = "tjDestroy")]
    private static extern int Destroy(IntPtr handle);
}
