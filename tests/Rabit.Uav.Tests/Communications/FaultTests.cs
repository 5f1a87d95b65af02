using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.Communications;

/// <summary>
/// What links and peers do wrong, in virtual time: no fault, no growth, and telemetry is back within 3 s.
/// </summary>
[Collection(AloneCollection.Name)]
public sealed class FaultTests(ITestOutputHelper output)
{
    private int _attitudes;
    private int _ofSystem9;

    [Fact]
    public void Link_ThatFlapsEach100MsForAMinute_IsBackWithin3Seconds()
    {
        using var flapping = new FlappingLink();
        using CommunicationsRig rig = Rig(1, o => o.Links = [.. o.Links, flapping.Link], flapping);
        byte sequence = 0;
        long before = 0;
        for (int ms = 0; ms < 60_000; ms += 10)
        {
            if (ms % 100 == 0)
                flapping.Flap();
            rig.Send(0, Frames.Heartbeat(sequence: sequence++));
            flapping.Drain();
            rig.Run(TimeSpan.FromMilliseconds(10));
            if (ms == 10_000)
                before = Memory();
        }

        long grown = Memory() - before;
        flapping.ComeUp();
        TimeSpan back = rig.Reactor.Now;
        flapping.Drain();
        while (flapping.Received == 0)
        {
            rig.Send(0, Frames.Heartbeat(sequence: sequence++));
            rig.Run(TimeSpan.FromMilliseconds(10));
            flapping.Drain();
            Assert.InRange(rig.Reactor.Now - back, TimeSpan.Zero, TimeSpan.FromSeconds(3));
        }

        output.WriteLine(
            $"{flapping.Openings} openings, back after {(rig.Reactor.Now - back).TotalMilliseconds} ms, "
            + $"{grown / 1024} kB more after 50 s");
        Assert.InRange(grown, long.MinValue, 300_000);
        Assert.Equal(LinkState.Receiving, rig.LastStatus(0).State);
        Assert.All(rig.Log, l => Assert.Null(l.Exception));
        Assert.Null(rig.Finish().Failure);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void Garbage_AtFullRate_HoldsNoFrameForLongAndGrowsNothing(int seed)
    {
        using CommunicationsRig rig = Rig(2);
        var random = new Random(seed);
        var garbage = new byte[1152];   // of 10 ms at 921600 baud
        long before = 0;
        int sent = 0;
        for (int step = 0; step < 3000; step++)
        {
            random.NextBytes(garbage);
            rig.Put(0, garbage);
            if (step % 10 == 0)
            {
                rig.Put(0, Frames.Of(new Attitude { Yaw = 1, TimeBootMs = (uint)step }, 7, 1, (byte)sent++));
                rig.Put(1, Frames.Heartbeat(system: 9, sequence: (byte)sent));
            }

            rig.Run(TimeSpan.FromMilliseconds(10));
            rig.Received(0);
            rig.Received(1);
            if (step == 500)
                before = Memory();
        }

        long grown = Memory() - before;
        rig.Run(TimeSpan.FromSeconds(1));
        LinkStatus status = rig.LastStatus(0);
        output.WriteLine(
            $"seed {seed}: {_attitudes} of {sent} frames read, {status.BytesLost} bytes lost, {grown / 1024} kB more");
        Assert.Equal((sent, sent), (_attitudes, _ofSystem9));
        Assert.InRange(status.BytesLost, 2_500_000, 3_456_000);
        Assert.InRange(grown, long.MinValue, 500_000);
        Assert.Null(rig.Finish().Failure);
    }

    [Fact]
    public void Peer_ThatNeverReads_KeepsNoOtherWaitingAndGrowsNothing()
    {
        using CommunicationsRig rig = Rig(3, linkCapacity: 4096);
        long before = 0;
        int forwarded = 0;
        for (int step = 0; step < 6000; step++)
        {
            rig.Send(0, Frames.Heartbeat(sequence: (byte)step));
            rig.Run(TimeSpan.FromMilliseconds(10));
            forwarded += rig.ReceivedFrames(1).Count;
            if (step == 500)
                before = Memory();
        }

        long grown = Memory() - before;
        Assert.InRange(grown, long.MinValue, 300_000);
        LinkStatus status = rig.Status(2);
        output.WriteLine($"{status.FramesDroppedOut} dropped, {grown / 1024} kB more");
        Assert.Equal(6000, forwarded);
        Assert.Equal(6000, status.FramesDroppedOut + status.FramesOut);
        Assert.InRange(status.FramesDroppedOut, 5000, 6000);

        // It reads again.
        rig.Received(2);
        rig.Send(0, Frames.Heartbeat(sequence: 200));
        rig.Run(TimeSpan.FromMilliseconds(10));
        Assert.Contains(rig.ReceivedFrames(2), f => f.Sequence == 200);
    }

    [Fact]
    public void GroundStation_ThatDisappearsAndComesBack_IsSilentAndServedAtOnce()
    {
        using CommunicationsRig rig = Rig(2);
        for (int n = 0; n < 5; n++)
            RunASecond(rig, (byte)n, hasGroundStation: true);
        Assert.Equal(LinkState.Receiving, rig.LastStatus(1).State);
        for (int n = 5; n < 65; n++)
            RunASecond(rig, (byte)n, hasGroundStation: false);
        Assert.Equal((LinkState.Receiving, LinkState.Silent), (rig.LastStatus(0).State, rig.LastStatus(1).State));
        rig.Received(1);

        RunASecond(rig, 65, hasGroundStation: true);
        Assert.Equal(LinkState.Receiving, rig.LastStatus(1).State);
        Assert.Contains(rig.ReceivedFrames(1), f => f.SystemId == 1);

        // And it is answered: what is for it goes there.
        rig.SendOwn(new CommandAck { TargetSystem = 255, TargetComponent = 190 });
        Assert.Contains(rig.ReceivedFrames(1), f => f.MessageId == CommandAck.MavlinkId);
    }

    [Fact]
    public void Senders_AThousandOnOneLink_AreForwardedAndRememberedWithinLimits()
    {
        using CommunicationsRig rig = Rig(2);
        long before = 0;
        int forwarded = 0;
        for (int round = 0; round < 8; round++)
        {
            for (int sender = 0; sender < 1000; sender++)
            {
                (byte system, byte component) = ((byte)(1 + (sender % 250)), (byte)(1 + (sender / 250)));
                rig.Send(0, Frames.Heartbeat(system, component, (byte)round));
                forwarded += rig.ReceivedFrames(1).Count;
                rig.Run(TimeSpan.FromMilliseconds(1));
            }

            if (round == 1)
                before = Memory();
        }

        long grown = Memory() - before;
        output.WriteLine($"{forwarded} forwarded, {grown / 1024} kB more after the second round");
        Assert.Equal(8000, forwarded);
        Assert.InRange(grown, long.MinValue, 1_000_000);
        Assert.Null(rig.Finish().Failure);
    }

    private static void RunASecond(CommunicationsRig rig, byte sequence, bool hasGroundStation)
    {
        rig.Send(0, Frames.Heartbeat(system: 1, sequence: sequence));
        if (hasGroundStation)
            rig.Send(1, Frames.Of(
                new Heartbeat { Type = MavType.Gcs, Autopilot = MavAutopilot.Invalid, MavlinkVersion = 3 }, 255, 190,
                sequence));
        rig.Run(TimeSpan.FromSeconds(1));
    }

    private CommunicationsRig Rig(
        int links, Action<CommunicationsOptions>? configure = null, FlappingLink? flapping = null,
        int linkCapacity = 64 * 1024)
    {
        var rig = new CommunicationsRig(
            links,
            o =>
            {
                o.PositionRateHz = 0;
                configure?.Invoke(o);
            },
            new FakeAutopilot(1024, Count) { Keeps = false },
            linkCapacity: linkCapacity,
            beforeStart: r => flapping?.Start(r));
        return rig.As(1);
    }

    private void Count(LinkFrame frame)
    {
        if (frame.IsChecked && frame.Frame.MessageId == Attitude.MavlinkId)
            _attitudes++;
        if (frame.IsChecked && frame.Frame.SystemId == 9)
            _ofSystem9++;
    }

    private static long Memory()
    {
        GC.Collect();
        GC.WaitForPendingFinalizers();
        return GC.GetTotalMemory(forceFullCollection: true);
    }

    /// <summary>A link in memory whose other end comes and goes.</summary>
    private sealed class FlappingLink : IDisposable
    {
        private readonly byte[] _buffer = new byte[64 * 1024];
        private MemoryLinkPair? _pair;
        private RabitReactor? _reactor;

        public FlappingLink() => Link = new ReopeningLink(
            "memory:flapping", Open, blocks: false, new LinkOptions(clock: new ReactorClock(() => _reactor)));

        public ReopeningLink Link { get; }

        public int Openings { get; private set; }

        public int Received { get; private set; }

        public void Start(RabitReactor reactor) => _reactor = reactor;

        /// <summary>Up for 100 ms, away for 100 ms.</summary>
        public void Flap()
        {
            if (_pair is null)
                ComeUp();
            else
                Go();
        }

        public void ComeUp() => _pair ??= new MemoryLinkPair("flapping");

        public void Drain()
        {
            if (_pair is { } pair)
                Received = pair.B.Read(_buffer).Count;
        }

        public void Dispose()
        {
            Go();
            Link.Dispose();
        }

        private void Go()
        {
            _pair?.B.Dispose();
            (_pair, Received) = (null, 0);
        }

        private IByteLink Open()
        {
            if (_pair is null)
                throw new LinkException("memory:flapping", "it is not there", linkEnded: true, mayPass: true);
            Openings++;
            return _pair.A;
        }
    }

    /// <summary>The clock of a reactor that is not there yet when the link is made.</summary>
    private sealed class ReactorClock(Func<RabitReactor?> reactor) : TimeProvider
    {
        public override long TimestampFrequency => TimeSpan.TicksPerSecond;

        public override long GetTimestamp() => reactor()?.Now.Ticks ?? 0;
    }
}
