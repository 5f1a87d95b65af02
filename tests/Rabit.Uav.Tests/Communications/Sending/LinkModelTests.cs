using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Communications;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.Communications.Sending;

/// <summary>
/// A radio of 3600 bytes a second behind Communications, in virtual time: from the push of a frame to its last byte.
/// </summary>
public sealed class LinkModelTests(ITestOutputHelper output)
{
    private const int Rate = 3600;
    private const int Burst = 560;
    private const int RadioLink = 1;

    [Theory]
    [InlineData(150, true, 60, 130)]
    [InlineData(280, false, 95, 180)]
    public void UrgentAndCommands_WhileBulkSaturates_AreOutInTime(
        int bulkBytes, bool isOwn, double urgentLimit, double commandLimit)
    {
        for (int seed = 1; seed <= 5; seed++)
        {
            using CommunicationsRig rig = Rig(seed);
            var random = new Random(seed);
            var radio = new Transmitter(Rate);
            var pushed = new Dictionary<(int Id, uint Number), TimeSpan>();
            byte sequence = 0;
            for (int ms = 0; ms < 60_000; ms++)
            {
                // Two and a half times as much as there is room for.
                if (isOwn && random.NextDouble() < 0.06)
                    rig.SendNow(Bulk(bulkBytes, 1, 191, sequence++));
                if (!isOwn && random.NextDouble() < 0.033)
                    rig.Put(0, Frames.Bytes(Bulk(bulkBytes, 255, 190, sequence++)));
                if (random.NextDouble() < 0.002)
                    PushUrgent(rig, pushed, (uint)ms);
                if (random.NextDouble() < 0.005)
                    PushCommand(rig, pushed, (uint)ms);
                Step(rig, radio);
            }

            double urgent = Transmitter.Percentile(Latencies(radio, pushed, Heartbeat.MavlinkId), 0.99);
            double command = Transmitter.Percentile(Latencies(radio, pushed, CommandLong.MavlinkId), 0.99);
            int most = radio.MaxBytesInAnySecond();
            output.WriteLine(FormattableString.Invariant(
                $"bulk of {bulkBytes} B, seed {seed}: P0 p99 {urgent:0} ms, P1 {command:0} ms, {most} B/s at most"));
            Assert.InRange(urgent, 0, urgentLimit);
            Assert.InRange(command, 0, commandLimit);
            Assert.InRange(most, 0.95 * Rate, Rate + Burst);
        }
    }

    [Fact]
    public void State_MoreThanThereIsRoomFor_IsNeverOlderThanTwoGrantedPeriods()
    {
        for (int seed = 1; seed <= 3; seed++)
        {
            using CommunicationsRig rig = Rig(seed);
            var random = new Random(seed);
            var radio = new Transmitter(Rate);
            byte sequence = 0;
            for (int ms = 0; ms < 60_000; ms++)
            {
                foreach ((int period, Func<uint, byte, byte[]> make) in Telemetry)
                {
                    if (ms % period == 0)
                        rig.Put(0, make((uint)ms, sequence++));
                }

                if (random.NextDouble() < 0.002)
                    rig.SendNow(new CommandLong { Command = MavCmd.RequestMessage, Param1 = ms });
                if (random.NextDouble() < 0.003)
                    rig.SendNow(new FileTransferProtocol { Payload = Content(100) });
                Step(rig, radio);
            }

            double reported = rig.LastStatus(RadioLink).Budget.GrantedShare;
            CheckAges(radio, reported, seed);
            Assert.InRange(radio.MaxBytesInAnySecond(), 0.95 * Rate, Rate + Burst);
        }
    }

    private void CheckAges(Transmitter radio, double reported, int seed)
    {
        var ages = new Dictionary<int, (double Age, double Share)>();
        foreach ((int id, int period, Func<MavlinkFrame, uint> time) in Kinds)
        {
            var kind = radio.Sent.Where(s => s.Frame.MessageId == id).ToList();
            double share = kind.Count * period / 60_000.0;
            double age = kind.Max(s => s.SentAt.TotalMilliseconds - time(s.Frame));
            ages.Add(id, (age, share));
            Assert.True(
                age <= 2 * period / share,
                FormattableString.Invariant($"seed {seed}: message {id} {age} ms old, granted {period / share} ms"));
        }

        output.WriteLine($"seed {seed}: reported share {reported:0.00}; " + string.Join(", ", ages.Select(
            a => FormattableString.Invariant($"{a.Key}: share {a.Value.Share:0.00}, age {a.Value.Age:0} ms"))));
        double least = ages.Values.Min(a => a.Share);
        Assert.InRange(reported, 0.5 * least, 1.5 * least);
        Assert.InRange(ages.Values.Max(a => a.Share) / least, 1, 1.2);
    }

    // Together about twice as much as there is room for.
    private static readonly (int Period, Func<uint, byte, byte[]> Make)[] Telemetry =
    [
        (10, (ms, n) => Frames.Of(new Attitude { TimeBootMs = ms, Yawspeed = 1 }, 1, 1, n)),
        (50, (ms, n) => Frames.Of(new GlobalPositionInt { TimeBootMs = ms, Hdg = 1 }, 1, 1, n)),
        (100, (ms, n) => Frames.Of(new NavControllerOutput { WpDist = (ushort)ms, TargetBearing = 1 }, 1, 1, n)),
        (200, (ms, n) => Frames.Of(new RcChannels { TimeBootMs = ms, Rssi = 1 }, 1, 1, n)),
    ];

    private static readonly (int Id, int Period, Func<MavlinkFrame, uint> Time)[] Kinds =
    [
        (Attitude.MavlinkId, 10, f => Decoded<Attitude>(f).TimeBootMs),
        (GlobalPositionInt.MavlinkId, 50, f => Decoded<GlobalPositionInt>(f).TimeBootMs),
        (NavControllerOutput.MavlinkId, 100, f => Decoded<NavControllerOutput>(f).WpDist),
        (RcChannels.MavlinkId, 200, f => Decoded<RcChannels>(f).TimeBootMs),
    ];

    private static T Decoded<T>(in MavlinkFrame frame)
        where T : struct, IMavlinkMessage
    {
        Assert.True(frame.TryDecode(out T message));
        return message;
    }

    private static IEnumerable<double> Latencies(
        Transmitter radio, Dictionary<(int Id, uint Number), TimeSpan> pushed, int id)
    {
        foreach ((MavlinkFrame frame, TimeSpan sentAt) in radio.Sent)
        {
            if (frame.MessageId != id)
                continue;
            uint number = id == Heartbeat.MavlinkId
                ? Decoded<Heartbeat>(frame).CustomMode
                : (uint)Decoded<CommandLong>(frame).Param1;
            yield return (sentAt - pushed[(id, number)]).TotalMilliseconds;
        }
    }

    private static void PushUrgent(
        CommunicationsRig rig, Dictionary<(int Id, uint Number), TimeSpan> pushed, uint number)
    {
        pushed[(Heartbeat.MavlinkId, number)] = rig.Reactor.Now;
        rig.SendNow(new Heartbeat { CustomMode = number, MavlinkVersion = 3 });
    }

    private static void PushCommand(
        CommunicationsRig rig, Dictionary<(int Id, uint Number), TimeSpan> pushed, uint number)
    {
        pushed[(CommandLong.MavlinkId, number)] = rig.Reactor.Now;
        rig.SendNow(new CommandLong { Command = MavCmd.RequestMessage, Param1 = number });
    }

    private static void Step(CommunicationsRig rig, Transmitter radio)
    {
        TimeSpan now = rig.Reactor.Now;
        rig.Run();
        radio.Take(rig.Received(RadioLink), now);
        rig.Run(TimeSpan.FromMilliseconds(1));
        radio.Take(rig.Received(RadioLink), rig.Reactor.Now);
    }

    private static CommunicationsRig Rig(int seed)
        => new CommunicationsRig(
            links: 2,
            o => (o.SendBudgets, o.PositionRateHz) =
                (new Dictionary<int, SendBudget> { [RadioLink] = new SendBudget { BytesPerSecond = Rate } }, 0),
            new FakeAutopilot(1024) { Keeps = false },
            seed).As(1);

    private static MavlinkFrame Bulk(int wireBytes, byte system, byte component, byte sequence)
        => MavlinkFrame.Create(
            new FileTransferProtocol { Payload = Content(wireBytes - 15) }, system, component, sequence);

    private static ByteArray251 Content(int length)
    {
        var bytes = new byte[251];
        bytes[Math.Min(length, 251) - 1] = 1;
        return new ByteArray251(bytes);
    }
}
