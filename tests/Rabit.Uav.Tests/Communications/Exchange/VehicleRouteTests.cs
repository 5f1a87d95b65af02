using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.Communications.Exchange;

/// <summary>
/// Messages of a user between vehicles, from the queue of one to that of another, over radios of 3600 bytes a second,
/// 200 ms one way, that lose a tenth.
/// </summary>
public sealed class VehicleRouteTests(ITestOutputHelper output)
{
    [Fact]
    public void Acknowledged_OverABadRadio_IsDeliveredOnceOrReportedExpired()
    {
        for (int seed = 1; seed <= 3; seed++)
        {
            using var fleet = new Fleet(3, seed, _ => [Route()]);
            var random = new Random(seed);
            const int messages = 120;
            for (int n = 0; n < messages; n++)
            {
                int from = random.Next(3);
                int to = (from + 1 + random.Next(2)) % 3;
                fleet.Push(from, VehicleDestination.Vehicle((byte)(to + 1)), n, random.Next(4, 700));
                if (n % 30 == 20)
                    fleet.Reaches = (_, _) => false;
                if (n % 30 == 25)
                    fleet.Reaches = (_, _) => true;
                fleet.Run(random.NextDouble());
            }

            fleet.Run(30);
            Account(fleet, 3, messages, seed);
            for (int i = 0; i < 3; i++)
                Assert.InRange(fleet.Radio(i).MaxBytesInAnySecond(), 0, 3600 + 560);
        }
    }

    [Fact]
    public void TwentyFiveVehicles_ThroughTheirManagers_EveryMessageAccountedFor()
        => RunTwentyFive(seed: 5, messages: 120);

    [Fact]
    [Trait("Category", "Long")]
    public void TwentyFiveVehicles_ThroughTheirManagersForTenMinutes_EveryMessageAccountedFor()
        => RunTwentyFive(seed: 6, messages: 1200);

    private void RunTwentyFive(int seed, int messages)
    {
        const int vehicles = 25;
        using var fleet = new Fleet(vehicles, seed, _ => [Route()]);
        var random = new Random(seed);
        bool[] isAway = new bool[vehicles];
        fleet.Reaches = (a, b) => !isAway[a] && !isAway[b];
        for (int n = 0; n < messages; n++)
        {
            if (n % 40 == 10)
                isAway[random.Next(vehicles)] = true;
            if (n % 40 == 30)
                Array.Clear(isAway, 0, vehicles);
            int from = random.Next(vehicles);
            int to = (from + 1 + random.Next(vehicles - 1)) % vehicles;
            fleet.Push(from, VehicleDestination.Vehicle((byte)(to + 1)), n, random.Next(4, 500));
            fleet.Run(0.5);
        }

        fleet.Run(20);
        Account(fleet, vehicles, messages, seed);
    }

    [Fact]
    public void Relayed_OverAThirdVehicle_ArrivesAndItsReportComesBack()
    {
        // 1 - 2 - 3: the ends do not reach each other.
        using var fleet = new Fleet(3, seed: 2, _ => [Route(hopLimit: 1)]);
        fleet.Reaches = (a, b) => Math.Abs(a - b) == 1;
        fleet.Push(0, VehicleDestination.Vehicle(3), 7, 350);
        fleet.Run(20);

        Envelope<Note> note = Assert.Single(fleet.Received(2));
        Assert.Equal((7, 350), (note.Content.Number, note.Content.Length));
        Assert.Equal((1, true), (note.SourceSystemId, note.IsRelayed));
        Assert.Equal((7L, DeliveryOutcome.Delivered), Only(fleet.Reports(0)));
        Assert.True(fleet.Status(1).Counters.Relayed >= 4);
        Assert.Empty(fleet.Received(1));
    }

    [Fact]
    public void Group_OfSomeVehicles_IsReachedAndReported()
    {
        using var fleet = new Fleet(
            4, seed: 3, _ => [Route()], (i, o) => o.VehicleExchange.Groups = i is 1 or 2 ? [3] : []);
        fleet.Run(10);
        Assert.Equal(3, fleet.Status(0).Vehicles);
        fleet.Push(0, VehicleDestination.Group(3), 1);
        fleet.Push(0, VehicleDestination.Group(9), 2);
        fleet.Run(15);

        Assert.Equal([0, 1, 1, 0], Enumerable.Range(0, 4).Select(i => fleet.Received(i).Count));
        Assert.Equal(VehicleDestination.Group(3), fleet.Received(1)[0].Destination);
        Assert.Equal(
            [(1L, DeliveryOutcome.Delivered, 2), (2L, DeliveryOutcome.NoReceiver, 0)],
            fleet.Reports(0).OrderBy(r => r.Reference).Select(r => (r.Reference, r.Outcome, r.Acknowledged)));
    }

    [Fact]
    public void SentTime_WithGpsOnBothSides_IsThatOfTheSender_WithoutItIsLateByTheWay()
    {
        const long utc = 1_790_000_000_000_000;
        using var fleet = new Fleet(2, seed: 4, _ => [Route()]) { Loss = 0 };
        fleet.Run(5);
        TimeSpan pushed = fleet.Now;
        fleet.Push(0, VehicleDestination.Vehicle(2), 1);
        fleet.Run(2);
        Envelope<Note> unmarked = fleet.Received(1)[0];
        Assert.Null(unmarked.TimeAccuracy);
        Assert.InRange((unmarked.SentTime - pushed).TotalMilliseconds, 200, 270);

        fleet.SetGpsTime(0, utc);
        fleet.SetGpsTime(1, utc);
        fleet.Run(1);
        Assert.InRange(fleet.Status(0).TimeAccuracy!.Value.TotalMilliseconds, 5, 60);
        pushed = fleet.Now;
        fleet.Push(0, VehicleDestination.Vehicle(2), 2);
        fleet.Run(2);
        Envelope<Note> dated = fleet.Received(1)[1];
        Assert.InRange(dated.TimeAccuracy!.Value.TotalMilliseconds, 10, 120);
        Assert.InRange((dated.SentTime - pushed).TotalMilliseconds, -1, 10);
        Assert.InRange(dated.SentUtcMicroseconds, utc + 1_000_000 - 10_000, utc + 1_000_000 + 10_000);
    }

    [Fact]
    public void GpsTime_ThatSteps_IsThatOfTheNextMessage()
    {
        const long utc = 1_790_000_000_000_000;
        const long hour = 3_600_000_000;
        using var fleet = new Fleet(2, seed: 12, _ => [Route()]) { Loss = 0 };
        fleet.SetGpsTime(0, utc - hour);   // its receiver does not know the leap seconds, or the date, yet
        fleet.SetGpsTime(1, utc);
        fleet.Run(1);
        TimeSpan pushed = fleet.Now;
        fleet.Push(0, VehicleDestination.Vehicle(2), 1);
        fleet.Run(1);
        fleet.SetGpsTime(0, utc + 2_000_000);
        fleet.Run(1);
        fleet.Push(0, VehicleDestination.Vehicle(2), 2);
        fleet.Run(2);

        // One of the two is wrong: the time by the age of the message is right all the same.
        Assert.Null(fleet.Received(1)[0].TimeAccuracy);
        Assert.InRange((fleet.Received(1)[0].SentTime - pushed).TotalMilliseconds, 200, 270);
        Assert.NotNull(fleet.Received(1)[1].TimeAccuracy);
        Assert.InRange((fleet.Received(1)[1].SentTime - pushed).TotalMilliseconds, 1990, 2020);
    }

    [Fact]
    public void Type_UnknownOrNewerOverThere_IsCountedIgnoredAndReported()
    {
        using var fleet = new Fleet(
            2, seed: 5, i => i == 0
                ? [Route(version: 3), Route(type: 1001, queue: "others out", incoming: "notes in")]
                : [Route(version: 2)]);
        fleet.Push(0, VehicleDestination.Vehicle(2), 1, length: 300);
        fleet.Push(0, VehicleDestination.Vehicle(2), 2, queue: "others out");
        fleet.Run(10);

        Assert.Empty(fleet.Received(1));
        Assert.Equal(2, fleet.Status(1).Counters.NotUnderstood);
        Assert.Equal(
            [(1L, DeliveryOutcome.NotUnderstood), (2L, DeliveryOutcome.NotUnderstood)],
            fleet.Reports(0).Select(r => (r.Reference, r.Outcome)).OrderBy(r => r.Reference));
        Assert.Equal(1, fleet.Counts(0).Undelivered);
    }

    [Fact]
    public void Older_VersionOfAnother_IsGivenToTheCodec()
    {
        using var fleet = new Fleet(2, seed: 6, i => [Route(version: i == 0 ? 1 : 2)]);
        fleet.Push(0, VehicleDestination.Vehicle(2), 1);
        fleet.Run(10);
        Assert.Equal(1, Assert.Single(fleet.Received(1)).Content.Number);
    }

    [Fact]
    public void ValidUntil_ThatPassed_IsReportedExpiredAndNotSent()
    {
        using var fleet = new Fleet(2, seed: 7, _ => [Route()]);
        fleet.Run(2);
        fleet.Push(0, VehicleDestination.Vehicle(2), 1, validUntil: fleet.Now - TimeSpan.FromSeconds(1));
        fleet.Reaches = (_, _) => false;
        fleet.Push(0, VehicleDestination.Vehicle(2), 2, validUntil: fleet.Now + TimeSpan.FromSeconds(2));
        fleet.Run(1.8);
        Assert.Equal((1L, DeliveryOutcome.Expired), Only(fleet.Reports(0)));
        fleet.Run(0.4);
        Assert.Equal([1L, 2], fleet.Reports(0).Select(r => r.Reference));
    }

    [Fact]
    public void Bulk_OfMessages_LeavesCommandsTheirPlace()
    {
        using var fleet = new Fleet(
            2, seed: 8, _ =>
            [
                Route(messageClass: VehicleMessageClass.Bulk, lifetimeSeconds: 120),
                Route(type: 1001, queue: "others out", incoming: "notes in", messageClass: VehicleMessageClass.Command),
            ])
        { Loss = 0 };
        for (int n = 0; n < 20; n++)
            fleet.Push(0, VehicleDestination.Vehicle(2), n, 3200);
        fleet.Run(5);
        TimeSpan pushed = fleet.Now;
        fleet.Push(0, VehicleDestination.Vehicle(2), 99, 60, queue: "others out");
        fleet.SendOwn(0, new Heartbeat { MavlinkVersion = 3 });
        fleet.Run(60);

        Envelope<Note> urgent = fleet.Received(1).Single(n => n.Content.Number == 99);
        Assert.InRange((urgent.SentTime - pushed).TotalMilliseconds, 200, 330);
        (MavlinkFrame _, TimeSpan sentAt) =
            fleet.Radio(0).Sent.Single(s => s.Frame.MessageId == Heartbeat.MavlinkId);
        Assert.InRange((sentAt - pushed).TotalMilliseconds, 0, 60);
        Assert.Equal(21, fleet.Received(1).Count);
        Assert.Equal(21, fleet.Reports(0).Count(r => r.Outcome == DeliveryOutcome.Delivered));
    }

    [Fact]
    public void Unacknowledged_ThatWentOut_IsReportedSent()
    {
        using var fleet = new Fleet(2, seed: 9, _ => [Route(isAcknowledged: false)]);
        fleet.Push(0, VehicleDestination.All, 1);
        fleet.Push(0, VehicleDestination.All, 2, length: 3201);
        fleet.Run(2);
        Assert.Equal(
            [(1L, DeliveryOutcome.Sent), (2L, DeliveryOutcome.Unsendable)],
            fleet.Reports(0).Select(r => (r.Reference, r.Outcome)).OrderBy(r => r.Reference));

        // Where nothing is acknowledged no vehicle need be known.
        Assert.DoesNotContain(fleet.Radio(1).Sent, s => s.Frame.MessageId == Tunnel.MavlinkId);
    }

    [Fact]
    public void Frames_OfTheExchange_AreAddressedToTheComputerOnBoard()
    {
        using var fleet = new Fleet(2, seed: 10, _ => [Route()]);
        fleet.Push(0, VehicleDestination.Vehicle(2), 1);
        fleet.Run(5);
        List<Tunnel> tunnels = fleet.Radio(0).Sent.Where(s => s.Frame.MessageId == Tunnel.MavlinkId).Select(s =>
        {
            Assert.True(s.Frame.TryDecode(out Tunnel tunnel));
            return tunnel;
        }).ToList();
        Assert.Contains(tunnels, t => t.TargetSystem == 2);
        Assert.All(tunnels, t => Assert.Equal((191, 42002), (t.TargetComponent, (int)t.PayloadType)));
    }

    [Fact]
    public void End_WithMessagesOnTheirWay_IsCountedForEach()
    {
        var fleet = new Fleet(2, seed: 11, _ => [Route()]);
        fleet.Reaches = (_, _) => false;
        for (int n = 0; n < 5; n++)
            fleet.Push(0, VehicleDestination.Vehicle(2), n);
        fleet.Run(1);
        fleet.Finish();
        Assert.Equal((5L, 5L), (fleet.Counts(0).Posted, fleet.Counts(0).Undelivered));
    }

    [Theory]
    [InlineData(0, 0, "Lifetime is 00:00:00")]
    [InlineData(601, 0, "Lifetime is 00:10:01")]
    [InlineData(1, 8, "HopLimit is 8; it must be 0 to 7")]
    public void Route_ThatCannotBe_IsNamed(double lifetimeSeconds, int hops, string expected)
    {
        var fault = Assert.Throws<ArgumentException>(
            () => new Fleet(1, 1, _ => [Route(hopLimit: hops, lifetimeSeconds: lifetimeSeconds)]));
        Assert.Contains("VehicleMessageRoutes, type 1000: " + expected, fault.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Groups_ThatCannotBe_AreNamed()
    {
        var fault = Assert.Throws<ArgumentException>(
            () => new Fleet(1, 1, _ => [Route()], (_, o) => o.VehicleExchange.Groups = [32]));
        Assert.Contains("VehicleExchange.Groups has 32", fault.Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(
            () => new VehicleMessageRoute<Note>(new NoteCodec(65536), "a", "b"));
        Assert.Throws<ArgumentException>(
            () => new VehicleMessageRoute<Note>(new NoteCodec(1, 256), "a", "b"));
    }

    private void Account(Fleet fleet, int vehicles, int messages, int seed)
    {
        List<DeliveryReport> reports = Enumerable.Range(0, vehicles).SelectMany(fleet.Reports).ToList();
        List<int> received = Enumerable.Range(0, vehicles).SelectMany(fleet.Received)
            .Select(n => n.Content.Number).ToList();
        int delivered = reports.Count(r => r.Outcome == DeliveryOutcome.Delivered);
        int expired = reports.Count(r => r.Outcome == DeliveryOutcome.Expired);
        output.WriteLine(
            $"seed {seed}: {messages} pushed, {delivered} delivered, {expired} expired, {received.Count} received");
        Assert.Equal(messages, delivered + expired);
        Assert.Equal(
            Enumerable.Range(0, messages).Select(n => (long)n), reports.Select(r => r.Reference).OrderBy(r => r));
        Assert.Equal(received.Distinct().Count(), received.Count);
        Assert.InRange(received.Count, delivered, messages);
        Assert.InRange(delivered, messages * 8 / 10, messages);
    }

    private static (long Reference, DeliveryOutcome Outcome) Only(IReadOnlyList<DeliveryReport> reports)
    {
        DeliveryReport report = Assert.Single(reports);
        return (report.Reference, report.Outcome);
    }

    private static VehicleMessageRoute<Note> Route(
        int type = 1000, int version = 1, string queue = "notes out", string incoming = "notes in", int hopLimit = 0,
        double lifetimeSeconds = 10, bool isAcknowledged = true,
        VehicleMessageClass messageClass = VehicleMessageClass.Coordination)
        => new(new NoteCodec(type, version), queue, incoming)
        {
            ReportQueue = "reports",
            Class = messageClass,
            HopLimit = hopLimit,
            IsAcknowledged = isAcknowledged,
            Lifetime = TimeSpan.FromTicks((long)(lifetimeSeconds * TimeSpan.TicksPerSecond)),
        };
}
