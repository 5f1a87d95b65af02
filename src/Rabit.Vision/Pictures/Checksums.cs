namespace Rabit.Vision;

/// <summary>
/// The two checksums of a PNG: CRC-32 over each chunk (PNG specification, annex D) and Adler-32 over the pixels (RFC
/// 1950, 8.2).
/// </summary>
internal static class Checksums
{
    private const uint CrcPolynomial = 0xEDB88320;
    private const uint AdlerModulus = 65_521;

    // So many bytes fit before the sums of Adler-32 have to be reduced.
    private const int AdlerBlock = 3_800;

    private static readonly uint[] CrcTable = MakeCrcTable();

    public static uint Crc32(byte[] data, int offset, int count)
    {
        uint crc = 0xFFFFFFFF;
        for (int at = offset; at < offset + count; at++)
            crc = CrcTable[(crc ^ data[at]) & 0xFF] ^ (crc >> 8);
        return ~crc;
    }

    /// <summary>Goes on with a sum that begins with 1.</summary>
    public static uint Adler32(uint sum, byte[] data, int offset, int count)
    {
        uint low = sum & 0xFFFF;
        uint high = sum >> 16;
        while (count > 0)
        {
            int block = count < AdlerBlock ? count : AdlerBlock;
            for (int end = offset + block; offset < end; offset++)
            {
                low += data[offset];
                high += low;
            }

            low %= AdlerModulus;
            high %= AdlerModulus;
            count -= block;
        }

        return (high << 16) | low;
    }

    private static uint[] MakeCrcTable()
    {
        uint[] table = new uint[256];
        for (uint value = 0; value < 256; value++)
        {
            uint crc = value;
            for (int bit = 0; bit < 8; bit++)
                crc = (crc & 1) != 0 ? (crc >> 1) ^ CrcPolynomial : crc >> 1;
            table[value] = crc;
        }

        return table;
    }
}
