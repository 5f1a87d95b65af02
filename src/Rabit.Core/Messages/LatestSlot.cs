using System.Runtime.InteropServices;

namespace Rabit.Core.Messages;

/// <summary>
/// Which post of a message is the latest, and where it is: one word, so that both change at once. A check for news
/// reads the version alone, which is whole on 32-bit boards too.
/// </summary>
[StructLayout(LayoutKind.Explicit)]
internal struct LatestSlot(int version, int index)
{
    /// <summary>Both. Written by posters; 64-bit operations on it are whole on all boards.</summary>
    [FieldOffset(0)]
    public long Word = 0;

    /// <summary>Its place in the pool.</summary>
    [FieldOffset(0)]
    public int Index = index;

    /// <summary>0: nothing was posted yet.</summary>
    [FieldOffset(sizeof(int))]
    public int Version = version;

    public static LatestSlot Of(long word) => new(0, 0) { Word = word };
}
