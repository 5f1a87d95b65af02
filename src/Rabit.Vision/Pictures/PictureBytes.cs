using System;
using System.IO;
using Rabit.Files;

namespace Rabit.Vision;

/// <summary>Reads the bytes of a picture's file; errors name it.</summary>
internal static class PictureBytes
{
    // Larger than any picture that is read here: nothing is gained by packing pixels into more bytes than they have.
    private const long MaxFileBytes = 256L * 1024 * 1024;

    /// <summary>Reads all of a file.</summary>
    /// <param name="path">The file.</param>
    /// <param name="buffer">Takes it; a larger one where it has no room.</param>
    /// <returns>How many bytes it has.</returns>
    /// <exception cref="PictureException">It cannot be read, is none, or is too large.</exception>
    public static int ReadAll(string path, ref byte[] buffer)
    {
        try
        {
            using FileStream file = Open(path);
            if (file.Length > MaxFileBytes)
                throw new PictureException(path, $"it has {file.Length} bytes; at most {MaxFileBytes} are read");
            int length = (int)file.Length;
            if (buffer.Length < length)
                buffer = new byte[length];
            return Fill(file, buffer, length);
        }
        catch (Exception e) when (PictureFile.IsFileFault(e))
        {
            throw FaultOf(path, e);
        }
    }

    /// <summary>Reads the first bytes of a file, or all of a shorter one.</summary>
    /// <param name="path">The file.</param>
    /// <param name="bytes">At most so many.</param>
    /// <exception cref="PictureException">It cannot be read, or is none.</exception>
    public static byte[] ReadHead(string path, int bytes)
    {
        try
        {
            using FileStream file = Open(path);
            byte[] head = new byte[(int)Math.Min(file.Length, bytes)];
            int length = Fill(file, head, head.Length);
            return length == head.Length ? head : head.AsSpan(0, length).ToArray();
        }
        catch (Exception e) when (PictureFile.IsFileFault(e))
        {
            throw FaultOf(path, e);
        }
    }

    // Without a buffer of its own: the file goes into ours at once.
    private static FileStream Open(string path)
        => SpecialFile.FindKind(path) is { } kind
            ? throw new PictureException(path, $"it is {kind}, not a file")
            : new FileStream(
                path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete, bufferSize: 1);

    private static int Fill(FileStream file, byte[] buffer, int length)
    {
        int filled = 0;
        while (filled < length)
        {
            int read = file.Read(buffer, filled, length - filled);
            if (read <= 0)
                break;
            filled += read;
        }

        return filled;
    }

    private static PictureException FaultOf(string path, Exception e)
    {
        string reason = e switch
        {
            FileNotFoundException or DirectoryNotFoundException => "no such file",
            UnauthorizedAccessException => Directory.Exists(path) ? "that is a folder" : "no permission to read it",
            _ => "it cannot be read: " + e.Message,
        };
        return new PictureException(path, reason, e);
    }
}
