using System;
using System.Runtime.InteropServices;

namespace Rabit.Diagnostics.Sockets;

/// <summary>
/// Whose a folder is, by statx(2), whose result has one layout on all processors; links are not followed.
/// </summary>
internal static class FolderOwner
{
    private const int CurrentFolder = -100;     // AT_FDCWD
    private const int NoFollow = 0x100;         // AT_SYMLINK_NOFOLLOW
    private const uint TypeAndOwner = 0x1 | 0x8;   // STATX_TYPE | STATX_UID
    private const int Length = 256;             // struct statx
    private const int UserOffset = 20;          // stx_uid
    private const int ModeOffset = 28;          // stx_mode
    private const int TypeMask = 0xF000;
    private const int Directory = 0x4000;

    /// <summary>Whether it is a folder, and no link to one, that belongs to a user.</summary>
    public static bool IsFolderOf(string path, uint user)
    {
        var result = new byte[Length];
        return Statx(CurrentFolder, path, NoFollow, TypeAndOwner, result) == 0
            && (Read16(result, ModeOffset) & TypeMask) == Directory
            && Read32(result, UserOffset) == user;
    }

    private static int Read16(byte[] from, int offset) => MemoryMarshal.Read<ushort>(from.AsSpan(offset));

    private static uint Read32(byte[] from, int offset) => MemoryMarshal.Read<uint>(from.AsSpan(offset));

    [DllImport("libc", EntryPoint = "statx")]
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    private static extern int Statx(
        int folder, [MarshalAs(UnmanagedType.LPUTF8Str)] string path, int flags, uint mask, [Out] byte[] result);
}
