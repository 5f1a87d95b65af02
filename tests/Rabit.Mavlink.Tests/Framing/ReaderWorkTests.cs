using System;
using System.Collections.Generic;
using System.Linq;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Mavlink.Tests.Framing;

/// <summary>
/// The work per byte is bounded, whatever is sent: counted in bytes put through the checksum, not in time.
/// </summary>
public class ReaderWorkTests(ITestOutputHelper output)
{
    // Every place is put through the checksum once at most, so that a byte costs as many steps as claims cover it:
    // fewer than 280 by the length of a frame, and no pattern is known whose headers lie closer together than every
    // third byte.
    private const int MaxPerByte = 90;

    [Fact]
    public void ChecksumBytes_IntactFlight_AreNoMoreThanTheBytes()
    {
        byte[] flight = TestData.Bytes("ardupilot-flight.tlog");
        var reader = new MavlinkFrameReader(MavlinkDialect.All);
        FrameCollector.Read(flight, 1000, reader);

        // Between the frames are the times of the log, in which a start byte comes up now and then.
        output.WriteLine($"{reader.Counters.ChecksumBytes} of {reader.Counters.Bytes}");
        Assert.InRange(reader.Counters.ChecksumBytes, 0.8 * flight.Length, 1.05 * flight.Length);
    }

    [Theory]
    [InlineData(MavlinkInvalidFramePolicy.NextByte, MaxPerByte)]
    [InlineData(MavlinkInvalidFramePolicy.SkipFrame, 1)]
    public void ChecksumBytes_HostilePatterns_StayBounded(MavlinkInvalidFramePolicy policy, double mostPerByte)
    {
        double worst = 0;
        string pattern = "";
        foreach (byte[] bytes in Patterns())
        {
            double perByte = WorkPerByte(bytes, policy);
            if (perByte <= worst)
                continue;
            worst = perByte;
            pattern = TestData.ToHex(bytes, bytes.Length);
        }

        output.WriteLine($"worst {worst:0.0} per byte: {pattern}");
        Assert.InRange(worst, 0.9, mostPerByte);
    }

    private static double WorkPerByte(byte[] pattern, MavlinkInvalidFramePolicy policy)
    {
        byte[] bytes = Enumerable.Range(0, 4000).Select(i => pattern[i % pattern.Length]).ToArray();
        var reader = new MavlinkFrameReader(MavlinkDialect.All, policy);
        FrameCollector.Read(bytes, 1500, reader, flush: false);
        Assert.InRange(reader.PendingBytes, 0, 2 * MavlinkFrame.MaxWireLength);
        return (double)reader.Counters.ChecksumBytes / bytes.Length;
    }

    // Every start byte, length and id of MAVLink 1 in every way to come again soon; and patterns by chance of bytes
    // that mean something in a header.
    private static IEnumerable<byte[]> Patterns()
    {
        int[] ids = MavlinkDialect.All.Messages.Select(message => message.Id).Where(id => id < 256).ToArray();
        foreach (int id in ids)
        {
            yield return [0xFE, 0xFF, (byte)id];
            yield return [0xFE, (byte)id];
            MavlinkDialect.All.TryGetMessage(id, out MavlinkMessageInfo info);
            yield return [0xFE, info.MaxLength, (byte)id];
            yield return [0xFE, info.MaxLength, 0xFE, info.MaxLength, 0xFE, (byte)id];
        }

        var random = new Random(2026);
        byte[] headers = [0xFD, 0xFD, 0xFE, 0xFE, 0xFF, 0xFE, 0, 0, 1, 0x83, 0x40];
        for (int count = 0; count < 1000; count++)
            yield return Enumerable.Range(0, random.Next(1, 13)).Select(_ => random.Next(6) == 0
                ? (byte)ids[random.Next(ids.Length)]
                : headers[random.Next(headers.Length)]).ToArray();
    }
}
