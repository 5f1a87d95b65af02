using System;
using System.Runtime.InteropServices;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// The pixels of a picture as an array: that of the camera as it is, a copy of other memory. Keeps one buffer, as
/// large as the largest copy so far; for one thread.
/// </summary>
internal sealed class PixelArray
{
    private byte[] _copy = [];

    /// <summary>From the first pixel on; may be longer. Valid until the next call.</summary>
    public byte[] Of(ReadOnlyMemory<byte> pixels)
    {
        if (MemoryMarshal.TryGetArray(pixels, out ArraySegment<byte> segment) && segment.Offset == 0)
            return segment.Array!;
        if (_copy.Length < pixels.Length)
            _copy = new byte[pixels.Length];
        pixels.Span.CopyTo(_copy);
        return _copy;
    }
}
