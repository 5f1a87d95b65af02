using System;
using System.Buffers.Binary;
using System.Runtime.CompilerServices;

namespace Rabit.Mavlink.Signing;

/// <summary>
/// SHA-256 (FIPS 180-4) over bytes in memory, because netstandard2.0 has none without an allocation per call, and the
/// one of .NET calls the operating system, which takes longer for the two blocks of a usual frame. Constant time: no
/// branch and no look-up depends on the bytes.
/// </summary>
internal static unsafe partial class Sha256
{
    public const int HashLength = 32;
    public const int BlockLength = 64;

    private const int Words = 8;
    private const int LengthBytes = 8;
    private const byte EndMark = 0x80;

    // FIPS 180-4, 5.3.3: fractional parts of the square roots of the first 8 primes.
    private static readonly uint[] Start =
    [
        0x6A09E667, 0xBB67AE85, 0x3C6EF372, 0xA54FF53A, 0x510E527F, 0x9B05688C, 0x1F83D9AB, 0x5BE0CD19,
    ];

    /// <summary>How much room a message needs with its padding.</summary>
    public static int PaddedLength(int length)
        => (length + 1 + LengthBytes + BlockLength - 1) / BlockLength * BlockLength;

    /// <summary>
    /// Hashes a message that lies at the start of a buffer; what is behind it is overwritten with the padding.
    /// </summary>
    /// <param name="buffer">At least <see cref="PaddedLength"/> bytes.</param>
    /// <param name="length">Length of the message.</param>
    /// <param name="hash">32 bytes.</param>
    public static void Hash(Span<byte> buffer, int length, Span<byte> hash)
    {
        uint* state = stackalloc uint[Words];
        Hash(buffer, length, state);
        for (int word = 0; word < Words; word++)
            BinaryPrimitives.WriteUInt32BigEndian(hash.Slice(word * sizeof(uint)), state[word]);
    }

    /// <summary>
    /// The same; the first 48 bits of the hash as they would lie in memory, little endian: what MAVLink signs with.
    /// </summary>
    public static ulong HashFirst48(Span<byte> buffer, int length)
    {
        uint* state = stackalloc uint[Words];
        Hash(buffer, length, state);
        return BinaryPrimitives.ReverseEndianness(state[0])
            | ((ulong)(BinaryPrimitives.ReverseEndianness(state[1]) & 0xFFFF) << 32);
    }

    private static void Hash(Span<byte> buffer, int length, uint* state)
    {
        int padded = PaddedLength(length);
        buffer.Slice(length, padded - length).Clear();
        buffer[length] = EndMark;
        BinaryPrimitives.WriteUInt64BigEndian(buffer.Slice(padded - LengthBytes), (ulong)length * 8);

        for (int word = 0; word < Words; word++)
            state[word] = Start[word];
        fixed (byte* bytes = buffer)
            CompressBlocks(state, bytes, padded);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static uint Rotate(uint value, int bits) => (value >> bits) | (value << (32 - bits));
}
