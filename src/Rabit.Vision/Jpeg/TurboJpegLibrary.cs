using System;
using System.Runtime.InteropServices;

namespace Rabit.Vision;

/// <summary>
/// libturbojpeg, where it is installed (Debian: libturbojpeg0), with the methods that our decoder has, so that the
/// pixels are the same. One thread.
/// </summary>
internal sealed unsafe class TurboJpegLibrary
{
    private const string Library = "libturbojpeg.so.0";
    private const int Rgb = 0;                                  // TJPF_RGB
    private const int AccurateDct = 4096;                       // TJFLAG_ACCURATEDCT
    private const int StopOnWarning = 8192;                     // TJFLAG_STOPONWARNING
    private const int LimitScans = 32_768;                      // TJFLAG_LIMITSCANS

    private static readonly Lazy<bool> Found = new(Find);

    private readonly TurboJpegHandle _handle = tjInitDecompress();

    private TurboJpegLibrary()
    {
    }

    /// <summary>Null where it is not installed.</summary>
    public static TurboJpegLibrary? TryCreate() => Found.Value ? new TurboJpegLibrary() : null;

    /// <summary>Decodes a picture whose header was read by <see cref="JpegHeader"/>.</summary>
    /// <returns>
    /// False where it finds anything wrong, or does not read such a kind; then the pixels are not to be used.
    /// </returns>
    public bool TryDecode(byte[] file, int offset, int count, int width, int height, byte[] pixels)
    {
        if (_handle.IsInvalid)
            return false;
        fixed (byte* bytes = file)
        fixed (byte* to = pixels)
        {
            byte* from = bytes + offset;
            return tjDecompressHeader3(
                    _handle, from, (UIntPtr)(uint)count, out int itsWidth, out int itsHeight, out _, out _) == 0
                && itsWidth == width && itsHeight == height
                && tjDecompress2(
                    _handle, from, (UIntPtr)(uint)count, to, width, width * 3, height, Rgb,
                    AccurateDct | StopOnWarning | LimitScans) == 0;
        }
    }

    private static bool Find()
    {
        try
        {
            using TurboJpegHandle handle = tjInitDecompress();
            return !handle.IsInvalid;
        }
        catch (Exception e) when (e is DllNotFoundException or EntryPointNotFoundException or BadImageFormatException)
        {
            return false;
        }
    }

    [DllImport(Library)]
    private static extern TurboJpegHandle tjInitDecompress();

    // unsigned long is as wide as a pointer where this library has this name.
    [DllImport(Library)]
    private static extern int tjDecompressHeader3(
        TurboJpegHandle handle, byte* file, UIntPtr length, out int width, out int height, out int subsampling,
        out int colours);

    [DllImport(Library)]
    private static extern int tjDecompress2(
        TurboJpegHandle handle, byte* file, UIntPtr length, byte* to, int width, int pitch, int height, int format,
        int flags);

    [DllImport(Library)]
    private static extern int tjDestroy(IntPtr handle);

    /// <summary>A decoder of the library, which is freed with ours.</summary>
    internal sealed class TurboJpegHandle : SafeHandle
    {
        public TurboJpegHandle()
            : base(IntPtr.Zero, ownsHandle: true)
        {
        }

        public override bool IsInvalid => handle == IntPtr.Zero;

        protected override bool ReleaseHandle() => tjDestroy(handle) == 0;
    }
}
