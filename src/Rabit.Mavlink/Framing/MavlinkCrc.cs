using System;

namespace Rabit.Mavlink;

/// <summary>
/// The checksum of MAVLink: CRC-16/MCRF4XX, that is X.25 without the final inversion: polynomial 0x1021 reflected
/// (0x8408), start value 0xFFFF (MAVLink guide, "Checksum"; ITU-T X.25, 2.2.7.4). Safe from any thread.
/// </summary>
public static class MavlinkCrc
{
    private const int ReflectedPolynomial = 0x8408;

    private static readonly ushort[] Table = MakeTable();

    /// <summary>What a checksum starts from.</summary>
    public const ushort Initial = 0xFFFF;

    /// <summary>Takes one more byte into a checksum.</summary>
    /// <param name="crc">The checksum so far; <see cref="Initial"/> at first.</param>
    /// <param name="value">The next byte.</param>
    /// <returns>The checksum with the byte.</returns>
    public static ushort Add(ushort crc, byte value) => (ushort)((crc >> 8) ^ Table[(byte)(crc ^ value)]);

    /// <summary>Takes more bytes into a checksum.</summary>
    /// <param name="crc">The checksum so far; <see cref="Initial"/> at first.</param>
    /// <param name="bytes">The next bytes, in wire order.</param>
    /// <returns>The checksum with the bytes.</returns>
    public static ushort Add(ushort crc, ReadOnlySpan<byte> bytes)
    {
        ushort[] table = Table;
        int sum = crc;
        for (int i = 0; i < bytes.Length; i++)
            sum = (sum >> 8) ^ table[(byte)(sum ^ bytes[i])];
        return (ushort)sum;
    }

    private static ushort[] MakeTable()
    {
        var table = new ushort[256];
        for (int index = 0; index < table.Length; index++)
        {
            int value = index;
            for (int bit = 0; bit < 8; bit++)
                value = (value & 1) != 0 ? (value >> 1) ^ ReflectedPolynomial : value >> 1;
            table[index] = (ushort)value;
        }
        return table;
    }
}
