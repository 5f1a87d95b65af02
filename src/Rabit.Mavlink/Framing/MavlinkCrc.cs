using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Rabit.Mavlink;

/// <summary>
/// The checksum of MAVLink, without its last byte CRC_EXTRA: CRC-16/MCRF4XX, that is X.25 without the final inversion:
/// polynomial 0x1021 reflected (0x8408), start value 0xFFFF (MAVLink guide, "Checksum"; ITU-T X.25, 2.2.7.4). Safe from
/// any thread.
/// </summary>
public static class MavlinkCrc
{
    private const int ReflectedPolynomial = 0x8408;

    // Bytes added at once ("slicing by 8"): a checksum is linear, so that the contribution of each byte of a block is
    // looked up separately, and the look-ups do not wait for one another as they do byte by byte.
    private const int Block = 8;
    private const int TableLength = 256;

    // [256 n + b]: the contribution of byte b when n bytes follow it in its block.
    private static readonly ushort[] Tables = MakeTables();

    // The byte whose table entry has this upper byte; the upper bytes are all different.
    private static readonly byte[] ByteOfUpperByte = InvertTable();

    /// <summary>What a checksum starts from.</summary>
    public const ushort Initial = 0xFFFF;

    /// <summary>Adds a byte to a checksum.</summary>
    /// <param name="crc">The checksum so far; <see cref="Initial"/> at first.</param>
    /// <param name="value">The next byte.</param>
    /// <returns>The checksum with the byte.</returns>
    public static ushort Add(ushort crc, byte value) => (ushort)((crc >> 8) ^ Tables[(byte)(crc ^ value)]);

    /// <summary>Adds bytes to a checksum.</summary>
    /// <param name="crc">The checksum so far; <see cref="Initial"/> at first.</param>
    /// <param name="bytes">The next bytes, in wire order.</param>
    /// <returns>The checksum with the bytes.</returns>
    public static ushort Add(ushort crc, ReadOnlySpan<byte> bytes)
    {
        if (bytes.Length < Block || !BitConverter.IsLittleEndian)
            return AddByByte(crc, bytes);
        ref byte start = ref MemoryMarshal.GetReference(bytes);
        uint sum = crc;
        int position = AddBlocks(ref start, bytes.Length, ref sum);
        return position == bytes.Length
            ? (ushort)sum
            : AddLast(sum, LastOf(ref start, bytes.Length, position), 8 * (bytes.Length - position));
    }

    /// <summary>
    /// The checksum of a frame: its bytes without the start byte, then CRC_EXTRA, the byte that is computed from the
    /// fields of its message.
    /// </summary>
    /// <param name="bytes">From the payload length to the end of the payload.</param>
    /// <param name="crcExtra">See <see cref="IMavlinkMessage.CrcExtra"/>.</param>
    internal static ushort OfFrame(ReadOnlySpan<byte> bytes, byte crcExtra)
    {
        if (bytes.Length < Block || !BitConverter.IsLittleEndian)
            return Add(AddByByte(Initial, bytes), crcExtra);
        ref byte start = ref MemoryMarshal.GetReference(bytes);
        uint sum = Initial;
        int position = AddBlocks(ref start, bytes.Length, ref sum);

        // The extra byte goes through together with what is left.
        int left = 8 * (bytes.Length - position);
        return AddLast(sum, LastOf(ref start, bytes.Length, position) | ((ulong)crcExtra << left), left + 8);
    }

    /// <summary>Finds CRC_EXTRA, the last byte that gave a checksum.</summary>
    /// <param name="before">The checksum without it.</param>
    /// <param name="checksum">The checksum with it.</param>
    /// <param name="crcExtra">The byte.</param>
    /// <returns>False where no byte gives that checksum.</returns>
    internal static bool TryFindExtra(ushort before, ushort checksum, out byte crcExtra)
    {
        int entry = checksum ^ (before >> 8);
        byte index = ByteOfUpperByte[entry >> 8];
        crcExtra = (byte)(index ^ before);
        return Tables[index] == entry;
    }

    private static byte[] InvertTable()
    {
        var inverse = new byte[TableLength];
        for (int value = 0; value < TableLength; value++)
            inverse[Tables[value] >> 8] = (byte)value;
        return inverse;
    }

    private static ushort AddByByte(ushort crc, ReadOnlySpan<byte> bytes)
    {
        foreach (byte value in bytes)
            crc = Add(crc, value);
        return crc;
    }

    // Adds whole blocks, and returns the position behind them.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int AddBlocks(ref byte start, int length, ref uint sum)
    {
        ref ushort tables = ref Tables[0];
        uint value = sum;
        int position = 0;
        for (; position <= length - Block; position += Block)
            value = LookUp(ref tables, Unsafe.ReadUnaligned<ulong>(ref Unsafe.Add(ref start, position)) ^ value);
        sum = value;
        return position;
    }

    // The 0 to 7 bytes behind the last whole block, as a number: read together with those before them, which are
    // shifted out.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static ulong LastOf(ref byte start, int length, int position) =>
        (Unsafe.ReadUnaligned<ulong>(ref Unsafe.Add(ref start, length - Block)) >> 1)
            >> (63 - (8 * (length - position)));

    // Adds 1 to 8 bytes: moved to the end of a block, since zeros before them contribute nothing.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static ushort AddLast(uint sum, ulong last, int bits)
    {
        ulong block = (last ^ sum) << (64 - bits);
        uint rest = (uint)(((ulong)sum >> 8) >> (bits - 8));
        return (ushort)(LookUp(ref Tables[0], block) ^ rest);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static uint LookUp(ref ushort tables, ulong block)
    {
        uint early = (uint)block;
        uint late = (uint)(block >> 32);
        return (uint)(Unsafe.Add(ref tables, (7 * TableLength) + (int)(byte)early)
            ^ Unsafe.Add(ref tables, (6 * TableLength) + (int)(byte)(early >> 8))
            ^ Unsafe.Add(ref tables, (5 * TableLength) + (int)(byte)(early >> 16))
            ^ Unsafe.Add(ref tables, (4 * TableLength) + (int)(early >> 24))
            ^ Unsafe.Add(ref tables, (3 * TableLength) + (int)(byte)late)
            ^ Unsafe.Add(ref tables, (2 * TableLength) + (int)(byte)(late >> 8))
            ^ Unsafe.Add(ref tables, TableLength + (int)(byte)(late >> 16))
            ^ Unsafe.Add(ref tables, (int)(late >> 24)));
    }

    private static ushort[] MakeTables()
    {
        var tables = new ushort[Block * TableLength];
        for (int index = 0; index < TableLength; index++)
        {
            int value = index;
            for (int bit = 0; bit < 8; bit++)
                value = (value & 1) != 0 ? (value >> 1) ^ ReflectedPolynomial : value >> 1;
            tables[index] = (ushort)value;
        }

        // One more byte behind it: the same step that a zero byte makes.
        for (int index = TableLength; index < tables.Length; index++)
        {
            int before = tables[index - TableLength];
            tables[index] = (ushort)((before >> 8) ^ tables[before & 0xFF]);
        }

        return tables;
    }
}
