using System;
using System.IO;
using Rabit.Geodesy;

namespace UavConsole;

/// <summary>Heights of the ground from a file.</summary>
internal static class TerrainFile
{
    /// <exception cref="ArgumentException">It cannot be read; the text says what is wrong.</exception>
    public static TerrainGrid Read(string path)
    {
        try
        {
            using var reader = new StreamReader(path);
            return AsciiGrid.Read(reader);
        }
        catch (Exception e)
            when (e is IOException or UnauthorizedAccessException or NotSupportedException or ArgumentException)
        {
            throw new ArgumentException($"--terrain {path} cannot be read: {e.Message}", nameof(path), e);
        }
        catch (FormatException e)
        {
            throw new ArgumentException($"--terrain {path}: {e.Message}", nameof(path), e);
        }
    }
}
