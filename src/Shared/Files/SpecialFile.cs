using System;
using System.Runtime.InteropServices;
using System.Text;

namespace Rabit.Files;

/// <summary>
/// Names in the file system that are no files: who opens a named pipe waits for its writer, and a device may have no
/// end. By statx(2), whose result has one layout on all processors. Linux only; elsewhere all pass.
/// </summary>
internal static class SpecialFile
{
    private const int CurrentFolder = -100;   // AT_FDCWD
    private const uint TypeOnly = 0x1;        // STATX_TYPE
    private const int Length = 256;           // struct statx
    private const int ModeOffset = 28;        // stx_mode, 16 bits
    private const int TypeMask = 0xF000;

    /// <summary>What a path leads to, through links too, where that is no file and no folder; else null.</summary>
    public static string? FindKind(string path)
    {
        if (!OperatingSystem.IsLinux())
            return null;
        byte[] result = new byte[Length];
        try
        {
            // What cannot be looked at cannot be opened either, which says why.
            if (Statx(CurrentFolder, Encoding.UTF8.GetBytes(path + "\0"), 0, TypeOnly, result) != 0)
                return null;
        }
        catch (EntryPointNotFoundException)
        {
            return null;   // a C library from before 2018
        }

        return (BitConverter.ToUInt16(result, ModeOffset) & TypeMask) switch
        {
            0x1000 => "a pipe",
            0x2000 or 0x6000 => "a device",
            0xC000 => "a socket",
            _ => null,
        };
    }

    [DllImport("libc", EntryPoint = "statx")]
    private static extern int Statx(int folder, byte[] path, int flags, uint mask, [Out] byte[] result);
}
