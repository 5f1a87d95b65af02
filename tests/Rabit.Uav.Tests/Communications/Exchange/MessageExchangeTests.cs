using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.Communications.Exchange;

/// <summary>Messages between vehicles over bad ways: once, or reported; nothing else.</summary>
public sealed class MessageExchangeTests(ITestOutputHelper output)
{
    [Theory]
    [InlineData(0, 1)]
    [InlineData(100, 1)]
    [InlineData(101, 2)]
    [InlineData(3200, 32)]
    public void Message_OfAnyLength_ArrivesWholeAndIsReported(int length, int fragments)
    {
        var net = new ExchangeNet(2, seed: 1);
        byte[] content = Content(length, 5);
        net.Post(0, Message(VehicleDestination.Vehicle(2), content, reference: 9));
        net.Run(5);
        ReceivedExchangeMessage received = Assert.Single(net.Received[1]);
        Assert.Equal(content, received.Content);
        Assert.Equal((1, 7, 2), (received.SourceSystemId, received.Type, received.Version));
        DeliveryReport report = Assert.Single(net.Reports[0]);
        Assert.Equal((9L, DeliveryOutcome.Delivered, 1, 1), (
            report.Reference, report.Outcome, report.Receivers, report.Acknowledged));
        Assert.Equal((fragments, 0L), (net.Nodes[0].Counters.FragmentsSent, net.Nodes[0].Counters.FragmentsResent));
        Assert.InRange(net.Nodes[1].Counters.AcknowledgementsSent, 1, (fragments + 3) / 2);
    }

    [Theory]
    [InlineData(0.1, 0.0, 0)]
    [InlineData(0.2, 0.1, 300)]
    [InlineData(0.4, 0.2, 500)]
    public void AcknowledgedMessages_OverWaysThatLoseRepeatAndReorder_AreDeliveredOnceOrReportedExpired(
        double loss, double repetition, double jitterMs)
    {
        for (int seed = 1; seed <= 20; seed++)
        {
            var net = new ExchangeNet(3, seed)
            {
                Loss = loss,
                Repetition = repetition,
                JitterMs = jitterMs,
                DelayMs = 200,
            };
            var random = new Random(seed);
            net.Run(20);
            for (int n = 0; n < 60; n++)
            {
                int from = random.Next(3);
                int to = (from + 1 + random.Next(2)) % 3;
                net.Post(from, Message(
                    VehicleDestination.Vehicle((byte)(to + 1)), Content(random.Next(0, 800), n), (from * 1000) + n,
                    lifetimeSeconds: 15));
                net.Run(random.NextDouble());
            }

            net.Run(60);
            Account(net, seed, output);
        }
    }

    [Fact]
    public void AcknowledgedMessage_OverACutWay_IsReportedExpiredInTime()
    {
        var net = new ExchangeNet(2, seed: 3) { Reaches = (_, _) => false };
        net.Post(0, Message(VehicleDestination.Vehicle(2), Content(50, 1), 4, lifetimeSeconds: 3));
        net.Run(2.9);
        Assert.Empty(net.Reports[0]);
        net.Run(0.2);
        Assert.Equal(DeliveryOutcome.Expired, Assert.Single(net.Reports[0]).Outcome);
        net.Reaches = (_, _) => true;
        net.Run(20);
        Assert.Empty(net.Received[1]);
    }

    [Fact]
    public void Message_WithAHopLimit_GoesOverAThirdVehicle_AndItsAcknowledgementComesBack()
    {
        // 1 - 2 - 3: the ends do not reach each other.
        var net = new ExchangeNet(3, seed: 4) { Reaches = (a, b) => Math.Abs(a - b) == 1, Loss = 0.1 };
        net.Post(0, Message(VehicleDestination.Vehicle(3), Content(350, 1), 1, hops: 1));
        net.Post(0, Message(VehicleDestination.Vehicle(3), Content(350, 2), 2, hops: 0));
        net.Run(30);
        ReceivedExchangeMessage received = Assert.Single(net.Received[2]);
        Assert.Equal((1, true), (received.SourceSystemId, received.IsRelayed));
        Assert.Empty(net.Received[1]);
        Assert.Equal(
            [(1L, DeliveryOutcome.Delivered), (2L, DeliveryOutcome.Expired)],
            net.Reports[0].Select(r => (r.Reference, r.Outcome)).OrderBy(r => r.Reference));
        Assert.True(net.Nodes[1].Counters.Relayed > 0);
    }

    [Fact]
    public void Message_InARing_EndsByItsHopLimit()
    {
        var net = new ExchangeNet(8, seed: 5) { Reaches = (a, b) => (a + 1) % 8 == b || (b + 1) % 8 == a };
        net.Run(10);
        long before = net.Datagrams;
        net.Post(0, Message(VehicleDestination.All, Content(20, 1), 1, hops: 7, isAcknowledged: false));
        net.Run(1.5);
        Assert.All(net.Received.Skip(1), r => Assert.Single(r));
        Assert.Empty(net.Received[0]);

        // Each of the others sends it on once at most, beside the announcements.
        Assert.InRange(net.Datagrams - before, 7, 8 + (3 * 8));
    }

    [Fact]
    public void Message_ToAGroup_GoesToItsMembersThatWereReceived()
    {
        var net = new ExchangeNet(
            4, seed: 6, i => new VehicleExchangeOptions { Groups = i is 1 or 2 ? [3] : [] })
        { Loss = 0.2 };
        net.Run(15);
        net.Post(0, Message(VehicleDestination.Group(3), Content(150, 1), 1));
        net.Post(0, Message(VehicleDestination.Group(9), Content(150, 1), 2));
        net.Post(0, Message(VehicleDestination.All, Content(150, 1), 3));
        net.Run(20);
        Assert.Equal([0, 2, 2, 1], net.Received.Select(r => r.Count));
        Assert.Equal(
            [
                (1L, DeliveryOutcome.Delivered, 2), (2L, DeliveryOutcome.NoReceiver, 0),
                (3L, DeliveryOutcome.Delivered, 3),
            ],
            net.Reports[0].OrderBy(r => r.Reference).Select(r => (r.Reference, r.Outcome, r.Acknowledged)));
    }

    [Theory]
    [InlineData(8, 1)]
    [InlineData(7, 3)]
    public void Message_OfAnUnknownTypeOrANewerVersion_IsIgnoredCountedAndReported(int type, int version)
    {
        var net = new ExchangeNet(2, seed: 7);
        net.Post(0, new ExchangeMessage
        {
            Type = (ushort)type,
            Version = (byte)version,
            Content = Content(250, 1),
            Destination = VehicleDestination.Vehicle(2),
            IsAcknowledged = true,
        });
        net.Run(5);
        Assert.Empty(net.Received[1]);
        Assert.Equal(1, net.Nodes[1].Counters.NotUnderstood);
        Assert.Equal(DeliveryOutcome.NotUnderstood, Assert.Single(net.Reports[0]).Outcome);
    }

    [Fact]
    public void State_NewerBeforeItWasSent_TakesThePlaceOfTheOlder()
    {
        var net = new ExchangeNet(2, seed: 8);
        for (int n = 0; n < 3; n++)
            net.Post(0, Message(
                VehicleDestination.Vehicle(2), Content(10, n), n, messageClass: VehicleMessageClass.State));
        net.Run(3);
        Assert.Equal(Content(10, 2), Assert.Single(net.Received[1]).Content);
        Assert.Equal(
            [DeliveryOutcome.Replaced, DeliveryOutcome.Replaced, DeliveryOutcome.Delivered],
            net.Reports[0].OrderBy(r => r.Reference).Select(r => r.Outcome));
    }

    [Fact]
    public void Urgent_AfterBulk_ArrivesFirst()
    {
        var net = new ExchangeNet(2, seed: 9) { BytesPerSecond = 1000 };
        net.Post(0, Message(
            VehicleDestination.Vehicle(2), Content(3000, 1), 1, messageClass: VehicleMessageClass.Bulk,
            lifetimeSeconds: 60));
        net.Run(0.5);
        net.Post(0, Message(
            VehicleDestination.Vehicle(2), Content(50, 2), 2, messageClass: VehicleMessageClass.Urgent));
        net.Run(60);
        Assert.Equal([50, 3000], net.Received[1].Select(m => m.Content.Length));
        Assert.InRange((net.Received[1][0].ReceivedTime - TimeSpan.FromSeconds(0.5)).TotalMilliseconds, 0, 300);
    }

    [Fact]
    public void GpsTime_GoesWithTheMessage_AndWithoutItTheMessageIsMarked()
    {
        const long utc = 1_790_000_000_000_000;
        var net = new ExchangeNet(2, seed: 10);
        net.Run(1);
        net.Nodes[0].NoteGpsTime(utc, net.Now, TimeSpan.FromMilliseconds(10));
        net.Run(3);
        net.Post(0, Message(VehicleDestination.Vehicle(2), Content(5, 1), 1));
        net.Post(1, Message(VehicleDestination.Vehicle(1), Content(5, 1), 1));
        net.Run(2);
        ReceivedExchangeMessage dated = Assert.Single(net.Received[1]);
        Assert.Equal(utc + 3_000_000, dated.SentUtcMicroseconds);
        Assert.InRange(dated.TimeAccuracy!.Value.TotalMilliseconds, 15, 20);
        ReceivedExchangeMessage undated = Assert.Single(net.Received[0]);
        Assert.Equal((0L, null), (undated.SentUtcMicroseconds, undated.TimeAccuracy));
        Assert.NotNull(net.Nodes[1].TimeAccuracyOf(1));
        Assert.Null(net.Nodes[0].TimeAccuracyOf(2));

        // After a minute without a report the autopilot has no such time any more.
        net.Run(60);
        Assert.False(net.Nodes[0].TryGetGpsTime(net.Now, out _, out _));
    }

    [Fact]
    public void Sender_StartedAgain_IsUnderstoodThoughItsNumbersComeAgain()
    {
        var net = new ExchangeNet(2, seed: 11);
        net.Post(0, Message(VehicleDestination.Vehicle(2), Content(5, 1), 1));
        net.Run(2);
        net.Restart(0, seed: 999);
        net.Post(0, Message(VehicleDestination.Vehicle(2), Content(5, 2), 1));
        net.Run(2);
        Assert.Equal(2, net.Received[1].Count);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void Take_AnyBytes_ThrowsNothingAndStaysBounded(int seed)
    {
        var net = new ExchangeNet(1, seed);
        var random = new Random(seed);
        for (int n = 0; n < 200_000; n++)
        {
            var bytes = new byte[random.Next(0, ExchangeWire.MaxLength + 1)];
            random.NextBytes(bytes);
            if (bytes.Length >= 28 && n % 2 == 0)
                MakeNearlyAFragment(bytes, random);
            net.Put(0, (byte)(bytes.Length > 1 ? bytes[1] : 1), bytes);
            if (n % 1000 == 0)
                net.Run(1);
        }

        VehicleExchangeCounters counters = net.Nodes[0].Counters;
        output.WriteLine($"seed {seed}: {counters.Malformed} malformed, {counters.NotUnderstood} not understood");
        Assert.InRange(counters.Malformed, 100_000, 199_000);
        Assert.InRange(counters.NotUnderstood + counters.Delivered, 1_000, 100_000);
        net.Run(700);
        net.Post(0, Message(VehicleDestination.Vehicle(2), [], 1));
    }

    [Fact]
    public void Post_ThatCannotBe_IsRefusedByName()
    {
        var net = new ExchangeNet(1, seed: 12);
        Assert.Contains("3200 bytes", Assert.Throws<ArgumentException>(
            () => net.Post(0, Message(VehicleDestination.All, new byte[3201], 1))).Message);
        Assert.Contains("lifetime", Assert.Throws<ArgumentException>(
            () => net.Post(0, Message(VehicleDestination.All, [], 1, lifetimeSeconds: 601))).Message);
        Assert.Contains("hop limit", Assert.Throws<ArgumentException>(
            () => net.Post(0, Message(VehicleDestination.All, [], 1, hops: 8))).Message);
    }

    [Fact]
    public void TwentyFiveVehicles_TenMinutesOnSlowRadios_EveryMessageAccountedFor()
    {
        const int seed = 13;
        const int vehicles = 25;
        var net = new ExchangeNet(vehicles, seed) { Loss = 0.1, DelayMs = 200, JitterMs = 50, BytesPerSecond = 3600 };
        var random = new Random(seed);
        bool[] isAway = new bool[vehicles];
        net.Reaches = (a, b) => !isAway[a] && !isAway[b];
        net.Run(10);
        for (int second = 0; second < 600; second++)
        {
            if (second % 60 == 30)
                isAway[random.Next(vehicles)] = true;
            if (second % 60 == 59)
                Array.Clear(isAway, 0, vehicles);
            int from = random.Next(vehicles);
            int to = (from + 1 + random.Next(vehicles - 1)) % vehicles;
            net.Post(from, Message(
                VehicleDestination.Vehicle((byte)(to + 1)), Content(random.Next(1, 500), second),
                (from * 1000) + second, lifetimeSeconds: 20));
            net.Run(1);
        }

        net.Run(60);
        Account(net, seed, output);
        output.WriteLine($"seed {seed}: {net.Datagrams} datagrams, {net.Bytes / 670.0 / vehicles:0} B/s each");
    }

    // Each posted message has one report; a delivered one was received once by its receiver, and none
    // twice.
    private static void Account(ExchangeNet net, int seed, ITestOutputHelper output)
    {
        List<DeliveryReport> reports = net.Reports.SelectMany(r => r).ToList();
        long posted = net.Nodes.Sum(n => n.Counters.Posted);
        int received = net.Received.Sum(r => r.Count);
        int delivered = reports.Count(r => r.Outcome == DeliveryOutcome.Delivered);
        int expired = reports.Count(r => r.Outcome == DeliveryOutcome.Expired);
        output.WriteLine(
            $"seed {seed}: {posted} posted, {delivered} delivered, {expired} expired, {received} received, "
            + $"{net.Nodes.Sum(n => n.Counters.FragmentsResent)} of "
            + $"{net.Nodes.Sum(n => n.Counters.FragmentsSent)} fragments sent again");
        Assert.True(posted == reports.Count, $"seed {seed}: {posted} posted, {reports.Count} reported");
        Assert.Equal(posted, delivered + expired);
        Assert.Equal(reports.Count, reports.Select(r => r.Reference).Distinct().Count());
        Assert.All(
            net.Received.SelectMany((r, i) => r.Select(m => (Vehicle: i, m.SourceSystemId, m.Id)))
                .GroupBy(m => m),
            g => Assert.Single(g));
        Assert.InRange(received, delivered, posted);
    }

    private static ExchangeMessage Message(
        VehicleDestination destination, byte[] content, long reference, double lifetimeSeconds = 10, int hops = 0,
        bool isAcknowledged = true, VehicleMessageClass messageClass = VehicleMessageClass.Coordination)
        => new()
        {
            Type = 7,
            Version = 2,
            Content = content,
            Destination = destination,
            Class = messageClass,
            Lifetime = TimeSpan.FromTicks((long)(lifetimeSeconds * TimeSpan.TicksPerSecond)),
            HopLimit = hops,
            IsAcknowledged = isAcknowledged,
            Reference = reference,
        };

    private static void MakeNearlyAFragment(byte[] bytes, Random random)
    {
        Array.Clear(bytes, 12, 16);
        (bytes[0], bytes[2], bytes[3]) = (0x11, 1, 1);
        (bytes[8], bytes[9], bytes[10], bytes[11]) = ((byte)random.Next(6, 9), 0, 2, (byte)random.Next(13));
        (bytes[14], bytes[17]) = ((byte)random.Next(1, 3), 1);
    }

    private static byte[] Content(int length, int seed)
    {
        var content = new byte[length];
        new Random(seed).NextBytes(content);
        return content;
    }
}
