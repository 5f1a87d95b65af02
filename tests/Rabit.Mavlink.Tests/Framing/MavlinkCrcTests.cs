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
    public void Add_ByteByByte_GivesTheSameAsAllAtOnce()
    {
        byte[] bytes = Encoding.ASCII.GetBytes("any bytes");
        ushort crc = MavlinkCrc.Initial;
        foreach (byte value in bytes)
            crc = MavlinkCrc.Add(crc, value);

        Assert.Equal(MavlinkCrc.Add(MavlinkCrc.Initial, bytes), crc);
    }

    [Fact]
    public void Add_Nothing_ChangesNothing() => Assert.Equal(0x1234, MavlinkCrc.Add(0x1234, []));
}
