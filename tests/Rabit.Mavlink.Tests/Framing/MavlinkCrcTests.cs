using System;
using System.Text;
using Xunit;

namespace Rabit.Mavlink.Tests.Framing;

public class MavlinkCrcTests
{
    [Fact]
    public void Add_CheckString_GivesThePublishedValue()
    {
        // CRC-16/MCRF4XX of "123456789", catalogue of parametrised CRC algorithms (reveng).
        ushort crc = MavlinkCrc.Add(MavlinkCrc.Initial, Encoding.ASCII.GetBytes("123456789"));

        Assert.Equal(0x6F91, crc);
    }

    [Fact]
    public void Add_EveryLengthAtOnce_GivesTheSameAsBitByBit()
    {
        var random = new Random(17);
        for (int length = 0; length <= 300; length++)
        {
            var bytes = new byte[length + 1];
            random.NextBytes(bytes);
            ushort start = (ushort)random.Next(0x10000);

            ushort expected = BitByBit(start, bytes, length);
            Assert.Equal(expected, MavlinkCrc.Add(start, bytes.AsSpan(0, length)));
            Assert.Equal(BitByBit(expected, [bytes[length]], 1), MavlinkCrc.Add(expected, bytes[length]));
            Assert.Equal(
                BitByBit(MavlinkCrc.Initial, bytes, length + 1),
                MavlinkCrc.OfFrame(bytes.AsSpan(0, length), bytes[length]));
        }
    }

    // The definition: a shift register with the polynomial 0x8408, lowest bit first.
    private static ushort BitByBit(ushort crc, byte[] bytes, int length)
    {
        int sum = crc;
        for (int bit = 0; bit < 8 * length; bit++)
        {
            int isSet = (sum ^ (bytes[bit / 8] >> (bit % 8))) & 1;
            sum = (sum >> 1) ^ (isSet * 0x8408);
        }

        return (ushort)sum;
    }

    [Fact]
    public void Add_Nothing_ChangesNothing() => Assert.Equal(0x1234, MavlinkCrc.Add(0x1234, []));
}
