using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Links;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>A false header holds frames back for a short silence only, and no frame is cut by that.</summary>
public sealed class FlushAfterSilenceTests
{
    // States 255 bytes of payload that never come.
    private static readonly byte[] FalseHeader = [0xFD, 0xFF, 0, 0, 0, 1, 1, 0, 0, 0];

    [Theory]
    [InlineData("memory:stream", 100)]
    [InlineData("udpin:0.0.0.0:14550", 20)]
    [InlineData("udpout:10.0.0.1:14550", 20)]
    [InlineData("tcp:10.0.0.1:5760", 100)]
    public void Source_FalseHeaderEachSecond_HoldsAHeartbeatBackForOneSilence(string url, int silence)
    {
        var rig = new Rig(url);
        for (int second = 0; second < 60; second++)
        {
            rig.Give(FalseHeader);
            rig.Give(Frames.Heartbeat(sequence: (byte)second));
            rig.RunFor(1000);
        }

        Assert.Equal(Enumerable.Range(0, 60).Select(s => (byte)s), rig.Taken.Select(f => f.Frame.Frame.Sequence));
        Assert.All(
            rig.Taken.Select((f, i) => f.TakenAt.TotalMilliseconds - (1000 * i)),
            late => Assert.InRange(late, silence, silence + 1));
        Assert.Equal(60 * FalseHeader.Length, rig.Source.BytesLost);
    }

    [Theory]
    [InlineData("memory:stream", 1)]
    [InlineData("memory:stream", 50)]
    [InlineData("memory:stream", 99)]
    [InlineData("udpin:0.0.0.0:14550", 1)]
    [InlineData("udpin:0.0.0.0:14550", 19)]
    public void Source_FrameCutAnywhereByAShorterGap_IsRead(string url, int gap)
    {
        var rig = new Rig(url);
        byte[] frame = Frames.Heartbeat(sequence: 5);
        for (int cut = 1; cut < frame.Length; cut++)
        {
            rig.Give(frame.Take(cut).ToArray());
            rig.RunFor(gap);
            rig.Give(frame.Skip(cut).ToArray());
            rig.RunFor(gap);
        }

        Assert.Equal(frame.Length - 1, rig.Taken.Count);
        Assert.Equal(0, rig.Source.BytesLost);
    }

    [Fact]
    public void Source_OneByteEvery99Milliseconds_IsReadAsAWhole()
    {
        var rig = new Rig("memory:stream");
        foreach (byte b in Frames.Heartbeat(sequence: 5))
        {
            rig.Give([b]);
            rig.RunFor(99);
        }

        Assert.Single(rig.Taken);
    }

    [Fact]
    public void Source_OtherSilenceAskedFor_IsThatOne()
    {
        var rig = new Rig("memory:stream", TimeSpan.FromMilliseconds(500));
        rig.Give(FalseHeader);
        rig.Give(Frames.Heartbeat(sequence: 5));

        rig.RunFor(499);
        Assert.Empty(rig.Taken);
        rig.RunFor(2);
        Assert.Single(rig.Taken);
    }

    [Fact]
    public void Source_PeersThatCutTheirFrames_AreNotMixed()
    {
        var rig = new Rig("tcpin:0.0.0.0:5760");
        byte[] first = Frames.Heartbeat(sequence: 1);
        byte[] second = Frames.Heartbeat(sequence: 2);
        rig.Give(first.Take(9).ToArray(), peer: 0);
        rig.Give(second.Take(5).ToArray(), peer: 3);
        rig.Give(FalseHeader, peer: 1);
        rig.Give(first.Skip(9).ToArray(), peer: 0);
        rig.Give(second.Skip(5).ToArray(), peer: 3);
        rig.RunFor(1);

        Assert.Equal([1, 2], rig.Taken.Select(f => (int)f.Frame.Frame.Sequence));
        Assert.Equal(0, rig.Source.BytesLost);
    }

    [Fact]
    public void Source_SilenceOfZero_IsRefused()
        => Assert.Throws<ArgumentOutOfRangeException>(
            () => new MavlinkLinkSource(new GivingLink("memory:stream"), flushAfter: TimeSpan.Zero));

    private sealed class Rig
    {
        private readonly GivingLink _link;
        private readonly RabitReactor _reactor;

        public Rig(string url, TimeSpan? flushAfter = null)
        {
            _link = new GivingLink(url);
            Source = new MavlinkLinkSource(_link, flushAfter: flushAfter);
            var collector = new Collector(Source);
            Taken = collector.Taken;
            _reactor = new RabitReactor(new ReactorOptions { Time = new VirtualTime(0), StopsOnSignals = false })
            {
                collector,
            };
            _reactor.Start();
        }

        public MavlinkLinkSource Source { get; }

        public List<(LinkFrame Frame, TimeSpan TakenAt)> Taken { get; }

        public void Give(byte[] bytes, int peer = 0) => _link.Give(bytes, peer);

        public void RunFor(int milliseconds) => _reactor.RunFor(TimeSpan.FromMilliseconds(milliseconds));
    }

    private sealed class Collector : RabitManager
    {
        private readonly BlockingReader<LinkFrame> _reader;

        public Collector(MavlinkLinkSource source)
            : base("collector") => _reader = AttachReader("link", source);

        public List<(LinkFrame Frame, TimeSpan TakenAt)> Taken { get; } = [];

        protected override void ExecuteUnitOfWork()
        {
            while (_reader.TryPop(out LinkFrame frame))
                Taken.Add((frame, Now));
        }
    }

    /// <summary>Hands out what it is given, chunk by chunk, each of a peer.</summary>
    private sealed class GivingLink(string url) : IByteLink
    {
        private readonly Queue<(byte[] Bytes, int Peer)> _chunks = new();
        private Action? _readable;

        public string Url => url;

        public bool Blocks => false;

        public LinkCounters Counters => default;

        public ByteLinkState State => ByteLinkState.Open;

        public string? LastFault => null;

        public void Give(byte[] bytes, int peer)
        {
            _chunks.Enqueue((bytes, peer));
            _readable?.Invoke();
        }

        public LinkRead Read(byte[] buffer, int timeoutMilliseconds = -1)
        {
            if (_chunks.Count == 0)
                return LinkRead.NothingYet;
            (byte[] bytes, int peer) = _chunks.Dequeue();
            bytes.CopyTo(buffer, 0);
            return LinkRead.Bytes(bytes.Length, peer);
        }

        public void Write(byte[] buffer, int offset, int count)
        {
        }

        public void Unblock()
        {
        }

        public void SetReadableCallback(Action? callback) => _readable = callback;

        public void Dispose()
        {
        }
    }
}
