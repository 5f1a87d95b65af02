using System;
using System.Linq;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Communications;
using Rabit.Geodesy;
using Rabit.Links;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>Typed messages between vehicles: target reports, over TUNNEL.</summary>
public sealed class VehicleMessageTests
{
    [Fact]
    public void Message_TwoVehicles_FallsIntoTheQueueOverThere()
    {
        using var air = new TwoVehicles();
        air.Send(from: 0, Report(picture: 7, index: 2));
        TargetReport report = Assert.Single(air.Received(1));
        Assert.Equal(
            (1, 7L, 2, DefaultTargetClasses.Orange),
            (report.SourceSystemId, report.PictureNumber, report.Index, report.Class));
        Assert.Empty(air.Received(0));
        Assert.Equal((1L, 1L, 0L), (air.Counts(0).Posted, air.Counts(0).Sent, air.Counts(0).Delivered));
        Assert.Equal((0L, 0L, 1L), (air.Counts(1).Posted, air.Counts(1).Sent, air.Counts(1).Delivered));

        air.Send(from: 1, Report(picture: 7, index: 2));
        Assert.Equal(2, Assert.Single(air.Received(0)).SourceSystemId);
    }

    [Fact]
    public void Message_ItsTime_TravelsAsAnAge()
    {
        using var air = new TwoVehicles();
        air.Run(5);
        TargetReport sent = Report(picture: 1);
        sent.Time = air.Now - TimeSpan.FromSeconds(1.5);
        air.Send(from: 0, sent);
        Assert.InRange((air.Received(1)[0].Time - sent.Time).TotalMilliseconds, 0, 5);
    }

    // A datagram of 145 bytes takes 1.5 s there.
    [Fact]
    public void Message_LinkCarriesLessThanADatagramASecond_GoesOutInItsTurnAndIsWaitedForWithoutPolling()
    {
        using var rig = new VehicleMessageRig(links: 1, settings: new LinkSettings { BytesPerSecond = 100 });
        for (int picture = 1; picture <= 4; picture++)
            rig.Send(Report(picture));
        rig.Rig.Run(TimeSpan.FromSeconds(20));
        Assert.Equal(4, rig.Rig.ReceivedFrames(0).Count(f => f.MessageId == Tunnel.MavlinkId));

        for (int picture = 5; picture <= 8; picture++)
            rig.Send(Report(picture));
        long runs = rig.Rig.Finish().Managers.Single(m => m.Name == CommunicationsManager.ManagerName).Runs;

        // Every 200 ms for all that is due anyway; every 20 ms while there is no room: another 200.
        Assert.InRange(runs, 1, 190);
    }

    // The other link has room at any time, and nothing more to send.
    [Fact]
    public void Message_SlowLinkBesideAFastOne_IsWaitedForWithoutPolling()
    {
        using var rig = new VehicleMessageRig(links: 2, settings: new LinkSettings { BytesPerSecond = 100 });
        for (int picture = 1; picture <= 6; picture++)
            rig.Send(Report(picture));
        rig.Rig.Run(TimeSpan.FromSeconds(12));
        Assert.Equal(6, rig.Rig.ReceivedFrames(1).Count(f => f.MessageId == Tunnel.MavlinkId));
        Assert.Equal(6, rig.Rig.ReceivedFrames(0).Count(f => f.MessageId == Tunnel.MavlinkId));
        long runs = rig.Rig.Finish().Managers.Single(m => m.Name == CommunicationsManager.ManagerName).Runs;
        Assert.InRange(runs, 1, 140);
    }

    // A link that opens sends within that time too.
    [Fact]
    public void Message_NoLinkIsOpen_IsWaitedForWithoutPolling()
    {
        using var rig = new VehicleMessageRig(links: 1, settings: new LinkSettings { IsReceiveOnly = true });
        for (int picture = 1; picture <= 10; picture++)
        {
            rig.Send(Report(picture));
            rig.Rig.Run(TimeSpan.FromSeconds(0.7));
        }

        long runs = rig.Rig.Finish().Managers.Single(m => m.Name == CommunicationsManager.ManagerName).Runs;
        Assert.InRange(runs, 1, 120);
    }

    [Fact]
    public void Message_SourceInTheContent_IsIgnored()
    {
        using var air = new TwoVehicles();
        TargetReport lie = Report(picture: 1);
        lie.SourceSystemId = 99;
        air.Send(from: 0, lie);
        Assert.Equal(1, air.Received(1)[0].SourceSystemId);
    }

    [Fact]
    public void Message_Addressed_GoesThereAloneOnceItIsSeenAndToNoUnknownAddress()
    {
        using var air = new TwoVehicles();
        air.Send(from: 0, Report(picture: 1), to: 2);   // not seen yet
        Assert.Empty(air.Received(1));
        air.Send(from: 1, Report(picture: 1));          // now it is
        Assert.Equal(1, Assert.Single(air.Received(1)).PictureNumber);
        air.Send(from: 0, Report(picture: 2), to: 2);
        air.Send(from: 0, Report(picture: 3), to: 77);
        air.Run(11);
        Assert.Equal([1L, 2], air.Received(1).Select(r => r.PictureNumber));
        Assert.Equal((3L, 2L, 1L), (air.Counts(0).Posted, air.Counts(0).Sent, air.Counts(0).Undelivered));
    }

    [Fact]
    public void Message_ThatComesIn_IsForwardedToOtherLinksButNotBackAndNotToTheAutopilot()
    {
        using var rig = new VehicleMessageRig(links: 3);
        byte[] frame = FrameOf(Report(picture: 1), system: 5);
        rig.Rig.Send(0, frame);
        Assert.Equal(5, Assert.Single(rig.Reports).SourceSystemId);
        Assert.Empty(rig.Rig.Received(0));
        Assert.Equal(frame, rig.Rig.Received(1));
        Assert.Equal(frame, rig.Rig.Received(2));
        Assert.Empty(rig.Rig.Autopilot.Taken);
    }

    [Fact]
    public void Message_OfTypesWithoutARoute_GoesTheWayOfAllFrames()
    {
        using var rig = new VehicleMessageRig(links: 1);
        rig.Rig.Send(
            0, Frames.Of(new Tunnel { PayloadType = (MavTunnelPayloadType)50_000, PayloadLength = 3 }, system: 5));
        Assert.Single(rig.Rig.Autopilot.Taken);
        Assert.Equal(0, rig.Exchange.Malformed);
    }

    [Fact]
    public void Message_ForAnotherVehicle_IsNotOurs()
    {
        using var rig = new VehicleMessageRig(links: 1);
        rig.Rig.Send(0, FrameOf(Report(picture: 1), system: 5, target: 9));
        Assert.Empty(rig.Reports);
        rig.Rig.Send(0, FrameOf(Report(picture: 1), system: 5, target: 1));
        Assert.Single(rig.Reports);
    }

    [Fact]
    public void Message_OfOurOwnSystem_IsAnEcho()
    {
        using var rig = new VehicleMessageRig(links: 1);
        rig.Rig.Send(0, FrameOf(Report(picture: 1), system: 1, component: 192));
        rig.Rig.Send(0, FrameOf(Report(picture: 1), system: 1, component: 191));   // the router counts this one
        Assert.Empty(rig.Reports);
        Assert.Equal(1, rig.Exchange.Echoes);
    }

    [Fact]
    public void Message_ThatComesTwice_CountsOnce()
    {
        using var rig = new VehicleMessageRig(links: 2);
        rig.Rig.Send(
            0, FrameOf(Report(picture: 1), system: 5, number: 1), FrameOf(Report(picture: 1), system: 5, number: 2));
        rig.Rig.Send(
            1, FrameOf(Report(picture: 1), system: 5, number: 1, sequence: 7),
            FrameOf(Report(picture: 1), system: 6, number: 1));
        Assert.Equal((3, 1L), (rig.Reports.Count, rig.Exchange.Duplicates));
        rig.Rig.Send(0, FrameOf(Report(picture: 1), system: 5, number: 0x30001));   // it has restarted
        Assert.Equal(4, rig.Reports.Count);
    }

    [Fact]
    public void Message_MoreThanTheRateLimit_WaitsAndExpiresAndIsCounted()
    {
        using var air = new TwoVehicles();
        for (int second = 0; second < 5; second++)
        {
            for (int i = 0; i < 50; i++)
                air.Push(0, Report(picture: second, index: i));
            air.Run(1);
        }

        // header, checksum, what TUNNEL says of its content, header of the fragment
        int frame = 12 + 5 + 28 + 58 + DefaultTargetClasses.Red.Length;
        Assert.InRange(air.Received(1).Count * frame, 4 * 1000, 6 * 1000);
        air.Run(11);
        VehicleMessageCounters counts = air.Counts(0);
        Assert.Equal((250L, 250L), (counts.Posted, counts.Sent + counts.Undelivered));
        Assert.InRange(air.Received(1).Count * frame, 14 * 1000, 17 * 1000);
        Assert.Equal(counts.Sent, air.Received(1).Count);
        Assert.Equal(0, air.Lost(1));
    }

    [Fact]
    public void Message_AddressNotKnown_IsNotSent()
    {
        using var rig = new VehicleMessageRig(links: 1, knowsAddress: false);
        rig.Send(Report(picture: 1));
        Assert.Empty(rig.Rig.Received(0));
        Assert.Equal(1, rig.Counts.Unsendable);
    }

    [Fact]
    public void Message_Garbage_IsCountedAndNeverThrows()
    {
        using var rig = new VehicleMessageRig(links: 1);
        var random = new Random(11);
        int sent = 0;
        for (int i = 0; i < 300; i++)
        {
            var payload = new byte[128];
            random.NextBytes(payload);
            rig.Rig.Send(0, Frames.Of(
                new Tunnel
                {
                    PayloadType = (MavTunnelPayloadType)ExchangeWire.PayloadType,
                    PayloadLength = (byte)random.Next(256),
                    Payload = new ByteArray128(payload),
                },
                system: 5));
            sent++;
        }

        Assert.Equal(sent, rig.Exchange.Malformed);
        Assert.Empty(rig.Reports);

        // A whole message with a content that is none.
        rig.Rig.Send(0, Frame(new byte[60], system: 5, component: 191, target: 0, sequence: 0, number: 1));
        Assert.Equal(1, rig.Counts.Malformed);
        Assert.Equal(LinkState.Receiving, rig.Rig.Status(0).State);
    }

    [Fact]
    public void Options_BadOnes_AreReportedTogether()
    {
        var route = new VehicleMessageRoute<TargetReport>(new TargetReportCodec(), "out", "in");
        var pair = new MemoryLinkPair("a", 100);
        string text = Assert.Throws<ArgumentException>(() => new CommunicationsManager(new CommunicationsOptions
        {
            Links = [pair.A],
            VehicleMessageRoutes = [route, route],
            VehicleMessageBytesPerSecond = 10,
            PositionRateHz = double.NaN,
        })).Message;
        foreach (string part
            in new[] { "has type 1 more than once", "VehicleMessageBytesPerSecond is 10", "PositionRateHz is NaN" })
            Assert.Contains(part, text, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(
            () => new VehicleMessageRoute<TargetReport>(new TargetReportCodec(), string.Empty, "in"));
        Assert.Throws<ArgumentNullException>(() => new VehicleMessageRoute<TargetReport>(null!, "out", "in"));
    }

    internal static TargetReport Report(long picture, int index = 0) => new()
    {
        PictureNumber = picture,
        Index = index,
        Position = GeodeticPosition.FromRadians(0.7, 0.1, 101.25),
        Covariance = new HorizontalCovariance(1.5, 0.25, 2),
        SystematicCovariance = new HorizontalCovariance(1, 0, 1),
        Class = DefaultTargetClasses.Orange,
        Score = 0.8,
        SizeMetres = 1.02,
        CentreX = 320.5,
        CentreY = 17.25,
    };

    internal static byte[] FrameOf(
        in TargetReport report, byte system, byte component = 191, byte target = 0, byte sequence = 0, uint number = 1)
    {
        var buffer = new byte[VehicleMessageRoute.MaxLength];
        Assert.True(new TargetReportCodec().TryEncode(report, report.Time, buffer, out int length));
        return Frame(buffer.AsSpan(0, length).ToArray(), system, component, target, sequence, number);
    }

    private static byte[] Frame(
        byte[] content, byte system, byte component, byte target, byte sequence, uint number)
    {
        var datagram = new byte[ExchangeWire.MaxLength];
        var header = new ExchangeFragment
        {
            Source = system,
            Destination = target == 0 ? VehicleDestination.All : VehicleDestination.Vehicle(target),
            Id = number,
            Type = 1,
            TypeVersion = 2,
            Class = VehicleMessageClass.Coordination,
            Count = 1,
            LifetimeMs = 5000,
        };
        int length = ExchangeWire.Write(datagram, header, content);
        return Frames.Of(
            new Tunnel
            {
                TargetSystem = target,
                TargetComponent = target == 0 ? (byte)0 : (byte)191,
                PayloadType = (MavTunnelPayloadType)ExchangeWire.PayloadType,
                PayloadLength = (byte)length,
                Payload = new ByteArray128(datagram.AsSpan(0, length)),
            },
            system,
            component,
            sequence);
    }
}
