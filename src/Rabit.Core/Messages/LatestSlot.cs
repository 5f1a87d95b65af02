using System;
using System.Runtime.InteropServices;

namespace Rabit.Core.Messages;

/// <summary>
/// Which post of a message is the latest, and where it is: one word, so that both change at once. A check for news
/// reads the version alone, which is whole on 32-bit boards too.
/// </summary>
/// <remarks>
/// The word is put together and taken apart by arithmetic: a processor that has just written two halves to memory
/// waits before it can read them as one.
/// </remarks>
/// <param name="version">0: nothing was posted yet.</param>
/// <param name="index">The place of the slot in the pool.</param>
[StructLayout(LayoutKind.Explicit)]
internal struct LatestSlot(int version, int index)
{
    /// <summary>Both. Written by posters; 64-bit operations on it are whole on all boards.</summary>
    [FieldOffset(0)]
    public long Word = Join(version, index);

    /// <summary>The half that a check for news reads.</summary>
    [FieldOffset(sizeof(int))]
    public int Version;

    public static long Join(int version, int index)
        => BitConverter.IsLittleEndian ? (long)version << 32 | (uint)index : (long)index << 32 | (uint)version;

    public static int VersionOf(long word) => (int)(BitConverter.IsLittleEndian ? word >> 32 : word);

    public static int IndexOf(long word) => (int)(BitConverter.IsLittleEndian ? word : word >> 32);
}
