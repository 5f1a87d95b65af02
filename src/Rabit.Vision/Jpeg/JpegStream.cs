using System;

namespace Rabit.Vision;

/// <summary>Finds whole JPEG pictures in a stream of them (MJPEG), as camera programs write it. Any thread.</summary>
/// <example>
/// <code>
/// var decoder = new JpegDecoder();
/// byte[] stream = File.ReadAllBytes("video.mjpeg");
/// byte[] pixels = new byte[640 * 480 * 3];
/// int from = 0;
/// while (JpegStream.TryFind(stream, from, stream.Length - from, out int start, out int length))
/// {
///     decoder.Open(stream, start, length, "camera");
///     decoder.Decode(pixels);
///     from = start + length;
/// }
/// </code>
/// </example>
public static class JpegStream
{
    // Bytes may be gone over so often in search of the end of what is no whole picture. Then what it hides is left out.
    private const long MaxPasses = 64;

    /// <summary>
    /// Finds the first picture. A thumbnail inside of it is part of it, not a picture of its own.
    /// </summary>
    /// <param name="data">The bytes.</param>
    /// <param name="offset">Where to begin.</param>
    /// <param name="count">How many bytes there are from there.</param>
    /// <param name="start">
    /// Where the picture begins; without a whole one, the first byte that is still needed when more have come.
    /// </param>
    /// <param name="length">Its bytes; 0 without one.</param>
    /// <returns>Whether there is a whole one.</returns>
    public static bool TryFind(byte[] data, int offset, int count, out int start, out int length)
    {
        if (data is null)
            throw new ArgumentNullException(nameof(data));
        if (offset < 0 || count < 0 || offset > data.Length - count)
            throw new ArgumentOutOfRangeException(nameof(count), "These bytes are not in the array.");
        length = 0;
        int end = offset + count;
        long passed = 0;
        for (start = offset; start < end; start++)
        {
            if (data[start] != 0xFF || (start + 1 < end && data[start + 1] != JpegMarker.Start))
                continue;
            if (start + 2 >= end)
                return false;
            if (data[start + 2] != 0xFF)
                continue;
            int behind = FindEnd(data, start + 2, end);
            if (behind == 0)
                return false;
            if (behind < 0)
            {
                // It may hide the begin of a whole one.
                passed += ~behind - start;
                if (passed > MaxPasses * count)
                    start = ~behind - 1;
                continue;
            }

            length = behind - start;
            return true;
        }

        return false;
    }

    // The place behind the end; 0 if it has not come yet, and the complement of its place if there is another picture
    // before.
    private static int FindEnd(byte[] data, int at, int end)
    {
        while (true)
        {
            int next = at >= end ? -1 : data.AsSpan(at, end - at).IndexOf((byte)0xFF);
            if (next < 0 || at + next + 1 >= end)
                return 0;
            at += next + 1;
            int marker = data[at];
            if (marker is 0 or 0xFF || (JpegMarker.IsAlone(marker) && marker < JpegMarker.Start))
                continue;
            if (marker == JpegMarker.End)
                return at + 1;
            if (marker == JpegMarker.Start)
                return ~(at - 1);
            if (end - at < 3)
                return 0;
            at += 1 + Math.Max((data[at + 1] << 8) | data[at + 2], 2);
        }
    }
}
