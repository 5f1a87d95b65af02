using System;
using System.IO;
using System.Text;

namespace Rabit.Geodesy;

/// <summary>
/// Reads the file WW15MGH.DAC of the National Geospatial-Intelligence Agency: the geoid EGM96 at posts 15 minutes of
/// arc apart, in centimetres. Between posts it is interpolated bilinearly: within 1.2 m, 4 cm RMS, of the model.
/// </summary>
/// <remarks>
/// Format: 721 rows from 90 degrees north, in each 1440 posts from Greenwich to the east, big-endian signed numbers of
/// 16 bits.
/// </remarks>
public static class Egm96Dac
{
    private const int Rows = 721;
    private const int Columns = 1440;
    private const double MetresPerUnit = 0.01;

    /// <summary>Reads it to its end.</summary>
    /// <param name="stream">The file; stays open.</param>
    /// <exception cref="FormatException">It is too short or too long.</exception>
    public static GeoidGrid Read(Stream stream)
    {
        if (stream is null)
            throw new ArgumentNullException(nameof(stream));
        using var reader = new BinaryReader(stream, Encoding.ASCII, leaveOpen: true);
        ushort[] posts = GeoidPosts.Read(reader, Rows, Columns);

        // Signed numbers become those above the least one, as the other format has them.
        for (int i = 0; i < posts.Length; i++)
            posts[i] ^= 0x8000;
        return new GeoidGrid(posts, Rows, Columns, short.MinValue * MetresPerUnit, MetresPerUnit);
    }
}
