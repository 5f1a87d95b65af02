using System;
using System.Buffers.Binary;
using System.Runtime.CompilerServices;

namespace Rabit.Mavlink.Signing;

// The compression function for the compilers of .NET Framework and Mono, which do better with loops than with many
// variables.
internal static unsafe partial class Sha256
{
    private const int Rounds = 64;

    // FIPS 180-4, 4.2.2: fractional parts of the cube roots of the first 64 primes.
    private static readonly uint[] RoundConstants =
    [
        0x428A2F98, 0x71374491, 0xB5C0FBCF, 0xE9B5DBA5, 0x3956C25B, 0x59F111F1, 0x923F82A4, 0xAB1C5ED5,
        0xD807AA98, 0x12835B01, 0x243185BE, 0x550C7DC3, 0x72BE5D74, 0x80DEB1FE, 0x9BDC06A7, 0xC19BF174,
        0xE49B69C1, 0xEFBE4786, 0x0FC19DC6, 0x240CA1CC, 0x2DE92C6F, 0x4A7484AA, 0x5CB0A9DC, 0x76F988DA,
        0x983E5152, 0xA831C66D, 0xB00327C8, 0xBF597FC7, 0xC6E00BF3, 0xD5A79147, 0x06CA6351, 0x14292967,
        0x27B70A85, 0x2E1B2138, 0x4D2C6DFC, 0x53380D13, 0x650A7354, 0x766A0ABB, 0x81C2C92E, 0x92722C85,
        0xA2BFE8A1, 0xA81A664B, 0xC24B8B70, 0xC76C51A3, 0xD192E819, 0xD6990624, 0xF40E3585, 0x106AA070,
        0x19A4C116, 0x1E376C08, 0x2748774C, 0x34B0BCB5, 0x391C0CB3, 0x4ED8AA4A, 0x5B9CCA4F, 0x682E6FF3,
        0x748F82EE, 0x78A5636F, 0x84C87814, 0x8CC70208, 0x90BEFFFA, 0xA4506CEB, 0xBEF9A3F7, 0xC67178F2,
    ];

    private static void CompressBlocks(uint* state, byte* bytes, int length)
    {
        uint* schedule = stackalloc uint[Rounds];
        fixed (uint* constants = RoundConstants)
        {
            for (int block = 0; block < length; block += BlockLength)
                Compress(state, bytes + block, schedule, constants);
        }
    }

    // FIPS 180-4, 6.2.2. Eight rounds at a time: then the working variables change their names instead of being moved.
    private static void Compress(uint* state, byte* block, uint* schedule, uint* constants)
    {
        Expand(block, schedule, constants);
        uint a = state[0], b = state[1], c = state[2], d = state[3], e = state[4], f = state[5], g = state[6],
            h = state[7];
        for (int round = 0; round < Rounds; round += 8)
        {
            uint* w = schedule + round;
            Round(a, b, c, ref d, e, f, g, ref h, w[0]);
            Round(h, a, b, ref c, d, e, f, ref g, w[1]);
            Round(g, h, a, ref b, c, d, e, ref f, w[2]);
            Round(f, g, h, ref a, b, c, d, ref e, w[3]);
            Round(e, f, g, ref h, a, b, c, ref d, w[4]);
            Round(d, e, f, ref g, h, a, b, ref c, w[5]);
            Round(c, d, e, ref f, g, h, a, ref b, w[6]);
            Round(b, c, d, ref e, f, g, h, ref a, w[7]);
        }

        state[0] += a;
        state[1] += b;
        state[2] += c;
        state[3] += d;
        state[4] += e;
        state[5] += f;
        state[6] += g;
        state[7] += h;
    }

    // The message schedule; the round constants are added at the end, where nothing waits for them.
    private static void Expand(byte* block, uint* schedule, uint* constants)
    {
        for (int word = 0; word < 16; word++)
        {
            uint value = Unsafe.ReadUnaligned<uint>(block + (word * sizeof(uint)));
            schedule[word] = BitConverter.IsLittleEndian ? BinaryPrimitives.ReverseEndianness(value) : value;
        }

        for (int word = 16; word < Rounds; word++)
        {
            uint w15 = schedule[word - 15];
            uint w2 = schedule[word - 2];
            uint s0 = Rotate(w15, 7) ^ Rotate(w15, 18) ^ (w15 >> 3);
            uint s1 = Rotate(w2, 17) ^ Rotate(w2, 19) ^ (w2 >> 10);
            schedule[word] = schedule[word - 16] + s0 + schedule[word - 7] + s1;
        }

        for (int word = 0; word < Rounds; word++)
            schedule[word] += constants[word];
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Round(uint a, uint b, uint c, ref uint d, uint e, uint f, uint g, ref uint h, uint input)
    {
        uint sum = h + (Rotate(e, 6) ^ Rotate(e, 11) ^ Rotate(e, 25)) + (g ^ (e & (f ^ g))) + input;
        d += sum;
        h = sum + (Rotate(a, 2) ^ Rotate(a, 13) ^ Rotate(a, 22)) + ((a & b) | (c & (a | b)));
    }
}
