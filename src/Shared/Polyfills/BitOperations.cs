#if NETSTANDARD2_0
namespace System.Numerics;

/// <summary>What of it is used, for netstandard2.0.</summary>
internal static class BitOperations
{
    /// <summary>How many bits are set.</summary>
    public static int PopCount(ulong value)
    {
        value -= (value >> 1) & 0x5555_5555_5555_5555;
        value = (value & 0x3333_3333_3333_3333) + ((value >> 2) & 0x3333_3333_3333_3333);
        value = (value + (value >> 4)) & 0x0F0F_0F0F_0F0F_0F0F;
        return (int)((value * 0x0101_0101_0101_0101) >> 56);
    }

    /// <summary>How many zeros are below the lowest bit that is set; 64 if none is.</summary>
    public static int TrailingZeroCount(ulong value) => PopCount(~value & (value - 1));
}
#endif
