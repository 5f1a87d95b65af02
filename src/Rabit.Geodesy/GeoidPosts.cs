using System;
using System.IO;

namespace Rabit.Geodesy;

/// <summary>Reads the posts of geoid grids: big-endian numbers of 16 bits.</summary>
internal static class GeoidPosts
{
    public static ushort[] Read(BinaryReader reader, int rows, int columns)
    {
        var posts = new ushort[rows * columns];
        for (int row = 0; row < rows; row++)
        {
            byte[] bytes = reader.ReadBytes(2 * columns);
            if (bytes.Length < 2 * columns)
                throw new FormatException($"The geoid grid ends in row {row + 1} of {rows}.");
            for (int column = 0; column < columns; column++)
                posts[(row * columns) + column] = (ushort)((bytes[2 * column] << 8) | bytes[(2 * column) + 1]);
        }

        if (reader.Read() >= 0)
            throw new FormatException($"The geoid grid goes on after its {rows} x {columns} posts.");
        return posts;
    }
}
