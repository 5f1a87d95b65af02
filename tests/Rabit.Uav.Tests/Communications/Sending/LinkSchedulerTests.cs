using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Tests.Shared;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.Communications.Sending;

/// <summary>What goes out first over a link of 3600 bytes a second, how soon, and that it never sends more.</summary>
public sealed class LinkSchedulerTests(ITestOutputHelper output)
{
    private byte _sequence;

    [Theory]
    [InlineData(150, 60, 130)]
    [InlineData(280, 95, 180)]
    public void Urgent_WhileBulkSaturates_IsOutInTime(int bulkBytes, double urgentLimit, double commandLimit)
    {
        var random = new Random(7);
        var radio = new RadioModel(new SendBudget());
        radio.Run(120, _ =>
        {
            if (random.NextDouble() < 0.1)
                radio.Put(Bulk(bulkBytes), isOwn: bulkBytes < 200);
            if (random.NextDouble() < 0.002)
                radio.Put(Frame(new Heartbeat { MavlinkVersion = 3 }));
            if (random.NextDouble() < 0.005)
                radio.Put(Frame(new CommandLong { Command = MavCmd.RequestMessage, Param1 = 1 }));
        });

        double urgent = radio.LatencyMilliseconds(f => f.MessageId == Heartbeat.MavlinkId, 0.99);
        double command = radio.LatencyMilliseconds(f => f.MessageId == CommandLong.MavlinkId, 0.99);
        output.WriteLine(FormattableString.Invariant(
            $"bulk of {bulkBytes} B: heartbeats p99 {urgent:0} ms, commands p99 {command:0} ms (seed 7)"));
        Assert.InRange(urgent, 0, urgentLimit);
        Assert.InRange(command, 0, commandLimit);
    }

    [Fact]
    public void Bytes_InAnySecond_AreNeverMoreThanRateAndBurst()
    {
        var random = new Random(3);
        var budget = new SendBudget();
        var radio = new RadioModel(budget);
        radio.Run(60, _ =>
        {
            radio.Put(random.Next(4) switch
            {
                0 => Frame(new Heartbeat { MavlinkVersion = 3 }),
                1 => Frame(new CommandLong { Command = MavCmd.NavReturnToLaunch, Param1 = 1 }),
                2 => Frame(new Attitude { Yaw = 1 }),
                _ => Bulk(random.Next(20, 280)),
            });
        });

        int most = radio.MaxBytesInAnySecond();
        output.WriteLine($"at most {most} bytes in a second (seed 3)");
        Assert.InRange(most, budget.BytesPerSecond * 0.95, budget.BytesPerSecond + budget.BurstBytes);
    }

    [Fact]
    public void State_MoreThanThereIsRoomFor_IsReducedEvenlyAndNeverOld()
    {
        var radio = new RadioModel(new SendBudget());
        var kinds = new (MavlinkFrame Frame, int PeriodMs)[]
        {
            (Frame(new Attitude { Yaw = 1, Yawspeed = 1 }), 10),
            (Frame(new GlobalPositionInt { Lat = 1, Hdg = 1 }), 50),
            (Frame(new VfrHud { Airspeed = 1, Throttle = 1 }), 50),
            (Frame(new SysStatus { Load = 1, BatteryRemaining = 1 }), 100),
            (Frame(new GpsRawInt { TimeUsec = 1, SatellitesVisible = 9 }), 200),
            (Frame(new NamedValueFloat { TimeBootMs = 1, Value = 1 }), 500),
        };
        double asked = kinds.Sum(k => k.Frame.WireLength * 1000.0 / k.PeriodMs);
        Assert.InRange(asked, 4500, 9000);
        radio.Run(60, ms =>
        {
            foreach ((MavlinkFrame frame, int period) in kinds)
            {
                if (ms % period == 0)
                    radio.Put(frame.WithSequence(_sequence++, 0));
            }
        });

        double[] shares = kinds.Select(k => radio.Sent.Count(s => s.Frame.MessageId == k.Frame.MessageId)
            * k.PeriodMs / 60_000.0).ToArray();
        double share = 3600 / asked;
        string each = string.Join(" ", shares.Select(s => FormattableString.Invariant($"{s:0.00}")));
        output.WriteLine(FormattableString.Invariant($"share {share:0.00}, each: {each}"));
        Assert.All(shares, s => Assert.InRange(s, 0.9 * share, 1.1 * share));
        for (int kind = 0; kind < kinds.Length; kind++)
        {
            double granted = kinds[kind].PeriodMs / shares[kind];
            double age = radio.LatencyMilliseconds(f => f.MessageId == kinds[kind].Frame.MessageId, 1);
            Assert.InRange(age, 0, 2 * granted);
        }

        double reported = radio.Scheduler.Status(radio.Now).GrantedShare;
        Assert.InRange(reported, 0.5 * share, 1.5 * share);
    }

    [Fact]
    public void Bulk_WhileStateAndCommandsSaturate_GetsFivePercent()
    {
        var radio = new RadioModel(new SendBudget());
        radio.Run(60, ms =>
        {
            if (ms % 5 == 0)
                radio.Put(Frame(new Attitude { Yaw = 1, Yawspeed = 1 }));
            if (ms % 8 == 0)
                radio.Put(Frame(new CommandLong { Command = MavCmd.RequestMessage, Param7 = 1 }));
            if (ms % 50 == 0)
                radio.Put(Bulk(120));
        });

        double bulk = radio.Sent.Where(s => s.Frame.MessageId == FileTransferProtocol.MavlinkId)
            .Sum(s => s.Frame.WireLength) / (60.0 * 3600);
        Assert.InRange(bulk, 0.045, 0.10);
    }

    [Fact]
    public void Heartbeats_Flood_LeavesTheOthersTheirPart()
    {
        var radio = new RadioModel(new SendBudget());
        radio.Run(30, ms =>
        {
            radio.Put(Frame(new Heartbeat { MavlinkVersion = 3 }), isOwn: false);
            if (ms % 100 == 0)
                radio.Put(Frame(new CommandLong { Command = MavCmd.RequestMessage, Param7 = 1 }));
        });

        Assert.InRange(radio.Sent.Count(s => s.Frame.MessageId == CommandLong.MavlinkId), 290, 300);
        Assert.True(radio.Scheduler.Status(radio.Now).Urgent.Full > 0);
    }

    [Fact]
    public void Frame_ThatWaitedTooLong_IsDroppedAndCounted()
    {
        var radio = new RadioModel(new SendBudget { BytesPerSecond = 100 });
        for (int n = 0; n < 20; n++)
            radio.Put(Frame(new CommandLong { Command = MavCmd.RequestMessage, Param7 = n + 1 }));
        radio.Put(Frame(new Statustext { Severity = MavSeverity.Info }), validUntil: TimeSpan.FromMilliseconds(100));
        radio.Run(5);

        LinkBudgetStatus status = radio.Scheduler.Status(radio.Now);
        Assert.Equal(20, status.Commands.Sent + status.Commands.Expired);
        Assert.InRange(status.Commands.Sent, 3, 7);
        Assert.Equal(1, status.Coordination.Expired);
        Assert.Equal(status.Commands.Expired + 1, radio.Scheduler.Dropped);
        Assert.Equal(0, status.Waiting);
    }

    [Fact]
    public void State_NewerValue_TakesThePlaceOfTheOlderOne()
    {
        var radio = new RadioModel(new SendBudget());
        radio.Put(Bulk(280));
        radio.Run(0.001);
        for (int n = 1; n <= 3; n++)
            radio.Put(Frame(new Attitude { Yaw = n }));
        radio.Put(Frame(new BatteryStatus { Id = 1, Voltages = default }));
        radio.Put(Frame(new BatteryStatus { Id = 2, Voltages = default }));
        radio.Run(1);

        Assert.Equal(2, radio.Scheduler.Status(radio.Now).State.Replaced);
        radio.Sent.Single(s => s.Frame.MessageId == Attitude.MavlinkId).Frame.TryDecode(out Attitude last);
        Assert.Equal(3, last.Yaw);
        Assert.Equal(2, radio.Sent.Count(s => s.Frame.MessageId == BatteryStatus.MavlinkId));
    }

    [Fact]
    public void SignedFramesOfOthers_KeepTheirOrder()
    {
        byte[] secret = Enumerable.Range(1, MavlinkSigningKey.Length).Select(i => (byte)i).ToArray();
        using var key = new MavlinkSigningKey(secret);
        var clock = new MavlinkSigningClock();
        clock.Advance(new DateTime(2026, 1, 1, 0, 0, 0, DateTimeKind.Utc), TimeSpan.FromSeconds(1));
        var signer = new MavlinkSigner(key, 1, clock);
        var radio = new RadioModel(new SendBudget());
        var sent = new List<MavlinkFrame>();
        radio.Put(Bulk(280));
        radio.Run(0.001);
        for (int n = 0; n < 10; n++)
        {
            MavlinkFrame frame = n % 2 == 0
                ? Frame(new Attitude { Yaw = n + 1 })
                : Frame(new CommandLong { Command = MavCmd.RequestMessage, Param7 = n });
            frame = signer.Sign(frame, n % 2 == 0 ? (byte)39 : (byte)152);
            sent.Add(frame);
            radio.Put(frame, isOwn: false);
        }

        radio.Run(3);

        Assert.Equal(sent.Select(f => f.Sequence), radio.Sent.Skip(1).Select(s => s.Frame.Sequence));
    }

    [Theory]
    [InlineData(10, 20, 180)]
    [InlineData(10, 3, 1843)]
    [InlineData(30, 20, 2169)]
    [InlineData(40, 20, 3600)]
    public void RadioBuffer_Filling_ReducesTheRateByPx4sLaw(byte free, int reports, int expected)
    {
        var scheduler = new LinkScheduler(new SendBudget(), 0);
        for (int n = 0; n < reports; n++)
            scheduler.NoteRadioBuffer(free, TimeSpan.FromSeconds(n));
        Assert.InRange(scheduler.BytesPerSecond, expected - 1, expected + 1);

        for (int n = 0; n < 200; n++)
            scheduler.NoteRadioBuffer(90, TimeSpan.FromSeconds(reports + n));
        Assert.Equal(3600, scheduler.BytesPerSecond);
    }

    [Theory]
    [InlineData(10, 10, 1058)]
    [InlineData(30, 10, 2000)]
    [InlineData(10, 100, 393)]
    [InlineData(60, 10, 3600)]
    public void RadioBuffer_Filling_ReducesTheRateByArduPilotsLaw(byte free, int reports, int expected)
    {
        var scheduler = new LinkScheduler(new SendBudget { RadioBufferLaw = RadioBufferLaw.ArduPilot }, 0);
        for (int n = 0; n < reports; n++)
            scheduler.NoteRadioBuffer(free, TimeSpan.FromSeconds(n));
        Assert.InRange(scheduler.BytesPerSecond, expected - 1, expected + 1);

        // Back by 40 ms down to 200 ms, then by 20 ms.
        for (int n = 0; n < 60; n++)
            scheduler.NoteRadioBuffer(100, TimeSpan.FromSeconds(reports + n));
        Assert.Equal(3600, scheduler.BytesPerSecond);
    }

    [Fact]
    public void RadioBuffer_NoReportForFiveSeconds_IsTakenForFreeAsByPx4()
    {
        var scheduler = new LinkScheduler(new SendBudget(), 0);
        scheduler.NoteRadioBuffer(10, TimeSpan.FromSeconds(1));
        scheduler.TryTake(TimeSpan.FromSeconds(6), out _);
        Assert.Equal(2880, scheduler.BytesPerSecond);
        scheduler.TryTake(TimeSpan.FromSeconds(6.1), out _);
        Assert.Equal(3600, scheduler.BytesPerSecond);
    }

    [Fact]
    public void RadioBuffer_NotFollowed_ChangesNothing()
    {
        var scheduler = new LinkScheduler(new SendBudget { FollowsRadioBuffer = false }, 0);
        scheduler.NoteRadioBuffer(0, TimeSpan.FromSeconds(1));
        Assert.Equal(3600, scheduler.BytesPerSecond);
    }

    [Fact]
    public void Frames_ThroughTheScheduler_AllocateNothing()
    {
        MavlinkFrame[] frames =
        [
            Frame(new Heartbeat { MavlinkVersion = 3 }), Frame(new Attitude { Yaw = 1 }), Bulk(100),
            Frame(new CommandLong { Param1 = 1 }),
        ];
        var scheduler = new LinkScheduler(new SendBudget(), 13);
        TimeSpan now = TimeSpan.Zero;
        Send();
        Assert.Equal(0, Allocated.By(Send));

        void Send()
        {
            for (int n = 0; n < 1000; n++)
            {
                now += TimeSpan.FromMilliseconds(10);
                scheduler.Put(
                    new FrameToSend { Frame = frames[n % 4], IsOwn = true }, SendClasses.Of(frames[n % 4]), now);
                while (scheduler.TryTake(now, out _))
                {
                }
            }
        }
    }

    private MavlinkFrame Frame<T>(T message)
        where T : struct, IMavlinkMessage
        => MavlinkFrame.Create(message, 1, 191, _sequence++);

    // FILE_TRANSFER_PROTOCOL carries 251 bytes; zeros at its end are cut.
    private MavlinkFrame Bulk(int wireBytes)
    {
        int payload = Math.Min(wireBytes - 12, 254);
        var bytes = new byte[251];
        bytes[payload - 4] = 1;
        return Frame(new FileTransferProtocol { Payload = new ByteArray251(bytes) });
    }
}
