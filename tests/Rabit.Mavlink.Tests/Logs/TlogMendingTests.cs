using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Tests.Framing;
using Xunit;

namespace Rabit.Mavlink.Tests.Logs;

/// <summary>
/// Whole records whose checksum is wrong: frames stored without their trailing zeros, and other messages.
/// </summary>
public sealed class TlogMendingTests
{
    [Theory]
    [InlineData(39)]
    [InlineData(14)]
    [InlineData(30)]
    public void TryRead_FrameStoredWithoutItsZeros_IsAsItWasSent(int sentLength)
    {
        byte[] sent = Untrimmed(sentLength);
        TlogReader log = new LogBuilder().Record(LogBuilder.Start).Record(LogBuilder.Start + 1, Trimmed(sent))
            .Record(LogBuilder.Start + 2).Read(out List<ReadRecord> records);

        Assert.Equal([false, true, false], records.Select(r => r.Record.IsMended));
        Assert.Equal(sent, records[1].Wire);
        Assert.Equal((3L, 1L, 0L, 0L), (log.Records, log.MendedRecords, log.RefusedRecords, log.LostBytes));
        Assert.True(records[1].Record.IsChecked);
    }

    [Fact]
    public void TryRead_FrameStoredWithoutItsZerosAtTheEndOfTheFile_IsMendedToo()
    {
        new LogBuilder().Record(LogBuilder.Start).Record(LogBuilder.Start + 1, Trimmed(Untrimmed(39)))
            .Read(out List<ReadRecord> records);
        Assert.Equal([false, true], records.Select(r => r.Record.IsMended));
    }

    [Fact]
    public void TryRead_AnotherMessageUnderAKnownId_IsRefusedByItsId()
    {
        // As an old ground station sent it: MAVLink 1, id 142, five bytes.
        byte[] foreign = [0xFE, 5, 0, 255, 0, 142, 1, 2, 3, 4, 5, 0x12, 0x34];
        var builder = new LogBuilder();
        for (int n = 0; n < 10; n++)
            builder.Record(LogBuilder.Start + (n * 10)).Record(LogBuilder.Start + (n * 10) + 5, foreign);
        TlogReader log = builder.Read(out List<ReadRecord> records);

        Assert.Equal(10, records.Count);
        Assert.Equal(10, log.RefusedRecords);
        Assert.Equal((142, 10L), (log.RefusedRecordsById.Single().Key, log.RefusedRecordsById.Single().Value));
        Assert.Equal(10 * (8 + foreign.Length), log.LostBytes);
    }

    [Fact]
    public void TryRead_DamageWithoutBorders_IsNeitherMendedNorRefused()
    {
        byte[] frame = Trimmed(Untrimmed(39));
        TlogReader log = new LogBuilder().Record(LogBuilder.Start).Record(LogBuilder.Start + 1, frame)
            .Raw(1, 2, 3).Record(LogBuilder.Start + 2).Read(out List<ReadRecord> records);
        Assert.Equal(2, records.Count);
        Assert.Equal((0L, 0L), (log.MendedRecords, log.RefusedRecords));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void TryRead_DamagedRecordsWithBorders_AreHardlyEverMended(int seed)
    {
        const int count = 20_000;
        var random = new Random(seed);
        var builder = new LogBuilder();
        for (int n = 0; n < count; n++)
        {
            byte[] damaged = Trimmed(Untrimmed(39));
            damaged[10 + random.Next(9)] ^= (byte)random.Next(1, 256);
            builder.Record(LogBuilder.Start + n, damaged);
        }

        TlogReader log = builder.Record(LogBuilder.Start + count).Read(out _);

        // 30 lengths are tried, each right by chance once in 65536: 9 of 20000, and 25 hardly ever.
        Assert.InRange(log.MendedRecords, 0, 25);
        Assert.True(log.MendedRecords + log.RefusedRecords >= count - 200, $"seed {seed}: {log.RefusedRecords}");
    }

    // A sender that keeps the zeros, as some do.
    private static byte[] Untrimmed(int length)
    {
        byte[] trimmed = Wire.Of(
            new DistanceSensor { TimeBootMs = 0x01020304, CurrentDistance = 7, MaxDistance = 400 }, 77);
        var bytes = new byte[12 + length];
        Array.Copy(trimmed, bytes, Math.Min(trimmed.Length - 2, bytes.Length - 2));
        bytes[1] = (byte)length;
        MavlinkDialect.All.TryGetMessage(DistanceSensor.MavlinkId, out MavlinkMessageInfo message);
        ushort crc = MavlinkCrc.Add(
            MavlinkCrc.Add(MavlinkCrc.Initial, bytes.AsSpan(1, bytes.Length - 3)), message.CrcExtra);
        bytes[bytes.Length - 2] = (byte)crc;
        bytes[bytes.Length - 1] = (byte)(crc >> 8);
        return bytes;
    }

    // What QGroundControl makes of it: the zeros are gone, the checksum is as it was.
    private static byte[] Trimmed(byte[] sent)
    {
        int end = sent.Length - 2;
        while (end > 11 && sent[end - 1] == 0)
            end--;
        byte[] stored = [.. sent.Take(end), sent[sent.Length - 2], sent[sent.Length - 1]];
        stored[1] = (byte)(end - 10);
        return stored;
    }
}
