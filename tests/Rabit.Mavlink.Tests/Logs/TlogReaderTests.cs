using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Tests.Framing;
using Xunit;

namespace Rabit.Mavlink.Tests.Logs;

public class TlogReaderTests
{
    private const long Start = LogBuilder.Start;
    private const long Second = 1_000_000;
    private const long Day = 86_400 * Second;

    // A heartbeat of zeros: 8 bytes of time and 13 of frame.
    private const int RecordLength = 21;

    private static readonly byte[] Unknown = Wire.V2(Wire.UnknownId, [1, 2, 3]);

    private readonly LogBuilder _log = new();

    [Fact]
    public void TryRead_Empty_EndsAsEmpty()
    {
        TlogReader log = _log.Read(out List<ReadRecord> records);

        Assert.Empty(records);
        Assert.Equal((TlogEnd.Empty, 0, null), (log.End, log.LostBytes, log.FirstDamageOffset));
    }

    [Fact]
    public void TryRead_NoLogAtAll_EndsAsNoRecord()
    {
        var noise = new byte[200_000];
        new Random(1).NextBytes(noise);

        TlogReader log = LogBuilder.Read(noise, out List<ReadRecord> records);

        Assert.Empty(records);
        Assert.Equal((TlogEnd.NoRecord, noise.Length, 0), (log.End, log.LostBytes, log.FirstDamageOffset));
    }

    [Fact]
    public void End_BeforeTheLastRecord_IsNotReached()
    {
        var log = new TlogReader(new MemoryStream(_log.Record(Start).ToArray()), MavlinkDialect.All);

        Assert.True(log.TryRead(out _, out _));
        Assert.Equal(TlogEnd.NotReached, log.End);
        Assert.False(log.TryRead(out _, out _));
        Assert.Equal(TlogEnd.Complete, log.End);
    }

    [Fact]
    public void TryRead_Record_GivesIndexOffsetAndTime()
    {
        _log.Record(Start).Record(Start + 1).Read(out List<ReadRecord> records);

        TlogRecord second = records[1].Record;
        Assert.Equal(
            (1, RecordLength, Start + 1, true),
            (second.Index, second.Offset, second.TimeMicroseconds, second.IsChecked));
        Assert.Equal(new DateTime(2026, 9, 21, 14, 13, 20, DateTimeKind.Utc).AddTicks(10), second.TimeUtc);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(8)]
    [InlineData(9)]
    [InlineData(20)]
    public void TryRead_CutInTheLastRecord_DeliversTheOthersAndNamesThePlace(int left)
    {
        byte[] whole = _log.Record(Start).Record(Start + 1, Unknown).Record(Start + 2).ToArray();
        int last = whole.Length - RecordLength;

        TlogReader log = LogBuilder.Read(whole.Take(last + left).ToArray(), out List<ReadRecord> records);

        Assert.Equal(2, records.Count);
        Assert.Equal((TlogEnd.Complete, left, last), (log.End, log.LostBytes, log.FirstDamageOffset));
    }

    [Fact]
    public void TryRead_EveryByteDamagedInTurn_LosesNoOtherRecord()
    {
        byte[] whole = new LogBuilder().Record(Start).Record(Start + 10).Record(Start + 20)
            .Record(Start + 30).ToArray();
        LogBuilder.Read(whole, out List<ReadRecord> intact);
        for (int offset = RecordLength; offset < 2 * RecordLength; offset++)
        {
            byte[] damaged = (byte[])whole.Clone();
            damaged[offset] ^= 0x80;
            TlogReader log = LogBuilder.Read(damaged, out List<ReadRecord> records);

            Assert.Equal(
                new[] { intact[0], intact[2], intact[3] }.Select(record => record.ToString()),
                records.Where(record => record.Record.IsChecked && record.Record.Offset != RecordLength)
                    .Select(record => record.ToString()),
                StringComparer.Ordinal);
            // A small error in a time cannot be detected, nor that an unknown id was another one.
            if (records.Count == 3)
                Assert.Equal((RecordLength, RecordLength), (log.LostBytes, log.FirstDamageOffset));
        }
    }

    [Fact]
    public void TryRead_GarbageBeforeBetweenAndAfter_CountsItAndNamesTheFirst()
    {
        var garbage = new byte[1000];
        new Random(2).NextBytes(garbage);
        TlogReader log = _log.Record(Start).Raw(garbage).Record(Start + 1).Raw(0xFD, 0, 0xFE)
            .Read(out List<ReadRecord> records);

        Assert.Equal(2, records.Count);
        Assert.Equal((1003, RecordLength), (log.LostBytes, log.FirstDamageOffset));
        Assert.Equal(1, records[1].Record.Index);
    }

    [Fact]
    public void TryRead_FrameInsideADamagedRecord_IsNotTakenForARecord()
    {
        MavlinkMessageInfo tunnel = Wire.Info<Tunnel>();
        byte[] outer = Wire.V2(tunnel.Id, Wire.Join(new byte[20], Wire.Of(default(Heartbeat)), [1]), tunnel.CrcExtra);
        outer[4] ^= 1;

        _log.Record(Start).Record(Start + 1, outer).Record(Start + 2).Read(out List<ReadRecord> records);

        Assert.Equal([Start, Start + 2], records.Select(record => record.Record.TimeMicroseconds));
    }

    [Fact]
    public void TryRead_UnknownIds_DeliversThemUncheckedWhereRecordsFollow()
    {
        TlogReader log = _log.Record(Start, Unknown).Record(Start + 1, Unknown).Record(Start + 2)
            .Record(Start + 3, Unknown).Read(out List<ReadRecord> records);

        Assert.Equal([false, false, true, false], records.Select(record => record.Record.IsChecked));
        Assert.Equal(0, log.LostBytes);
    }

    [Fact]
    public void TryRead_UnknownIdWithDamagedLength_LosesOnlyThatRecord()
    {
        byte[] longer = (byte[])Unknown.Clone();
        longer[1] = 200;
        TlogReader log = _log.Record(Start).Record(Start + 1, longer).Record(Start + 2).Record(Start + 3)
            .Read(out List<ReadRecord> records);

        Assert.Equal([Start, Start + 2, Start + 3], records.Select(record => record.Record.TimeMicroseconds));
        Assert.Equal(8 + longer.Length, log.LostBytes);
    }

    [Fact]
    public void TryRead_UnknownIncompatibilityFlag_PassesTheRecordOverAndCountsIt()
    {
        byte[] incompatible = Wire.V2(0, [1], Wire.Info<Heartbeat>().CrcExtra, incompatibilityFlags: 2);
        TlogReader log = _log.Record(Start, incompatible).Record(Start + 1).Read(out List<ReadRecord> records);

        Assert.Equal(1, Assert.Single(records).Record.Index);
        Assert.Equal((1, 1, 0), (log.Records, log.IncompatibleRecords, log.LostBytes));
    }

    [Theory]
    [InlineData(Day)]
    [InlineData(-Day)]
    public void TryRead_ClockSetWhileRecording_AcceptsIt(long step)
    {
        TlogReader log = _log.Record(Start).Record(Start + 1).Record(Start + step).Record(Start + step + 1)
            .Read(out List<ReadRecord> records);

        Assert.Equal((4, 0), (records.Count, log.LostBytes));
    }

    [Fact]
    public void TryRead_OneRecordADay_AcceptsThemAllButALastOneThatNothingConfirms()
    {
        TlogReader log = _log.Record(Start).Record(Start + Day).Record(Start + (2 * Day))
            .Read(out List<ReadRecord> records);

        Assert.Equal((2, RecordLength), (records.Count, log.LostBytes));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(2)]
    [InlineData(3)]
    public void TryRead_TimeOfARecordDamaged_LosesThatRecord(int damagedByte)
    {
        byte[] bytes = _log.Record(Start).Record(Start + 1).Record(Start + 2).ToArray();
        bytes[RecordLength + damagedByte] ^= 0x55;
        TlogReader log = LogBuilder.Read(bytes, out List<ReadRecord> records);

        Assert.Equal([Start, Start + 2], records.Select(record => record.Record.TimeMicroseconds));
        Assert.Equal((RecordLength, RecordLength), (log.LostBytes, log.FirstDamageOffset));
    }

    [Fact]
    public void Constructor_Nothing_NamesWhatIsMissing()
    {
        Assert.Throws<ArgumentNullException>("stream", () => new TlogReader(null!, MavlinkDialect.All));
        Assert.Throws<ArgumentNullException>("dialect", () => new TlogReader(Stream.Null, null!));
    }
}
