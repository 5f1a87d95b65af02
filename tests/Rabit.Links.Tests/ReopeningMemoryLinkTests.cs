using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Xunit;

namespace Rabit.Links.Tests;

/// <summary>Links that do not block, and so run in virtual time.</summary>
public sealed class ReopeningMemoryLinkTests : ReopeningLinkContract
{
    protected override string PeerGoneReason => "the other end was closed";

    protected override ReopeningBed OpenBed(LinkOptions options) => new MemoryBed(options);

    [Fact]
    public void Read_NothingThereInVirtualTime_TriesAgainAfterDelaysUpTo2Seconds()
    {
        var time = new VirtualTime(0);
        var tries = new List<double>();
        var pair = new MemoryLinkPair("device");
        RabitReactor? reactor = null;
        var link = new ReopeningLink(
            "memory:device", () =>
            {
                tries.Add(reactor!.Now.TotalMilliseconds);
                return tries.Count <= 8 ? throw new LinkException("memory:device", "it is not there", true) : pair.A;
            },
            blocks: false, new LinkOptions(clock: time.Clock));
        var manager = new Reader(link);
        reactor = new RabitReactor(new ReactorOptions { Time = time, StopsOnSignals = false }) { manager };
        reactor.Start();

        reactor.RunFor(TimeSpan.FromSeconds(12));
        pair.B.Write(new byte[] { 1, 2, 3 }, 0, 3);
        reactor.RunFor(TimeSpan.FromSeconds(1));
        reactor.Stop("the test is over");
        reactor.Finish();

        Assert.Equal(
            [100, 200, 400, 800, 1600, 2000, 2000, 2000],
            tries.Skip(1).Zip(tries, (later, earlier) => Math.Round(later - earlier)));
        Assert.Equal(3, manager.Received);
    }

    private sealed class Reader : RabitManager
    {
        private readonly BlockingReader<int> _counts;

        public Reader(IByteLink link)
            : base("reader") => _counts = AttachReader("bytes", new Source(link));

        public int Received { get; private set; }

        protected override void ExecuteUnitOfWork()
        {
            while (_counts.TryPop(out int count)) Received += count;
        }
    }

    private sealed class Source(IByteLink link) : IReaderSource<int>
    {
        private readonly byte[] _buffer = new byte[100];
        private ReaderContext? _context;

        public bool Blocks => link.Blocks;

        public void Open(ReaderContext context)
        {
            _context = context;
            link.SetReadableCallback(context.Signal);
        }

        public ReaderStep Read(out int value)
        {
            LinkRead read = link.Read(_buffer);
            value = read.Count;
            return read.Kind == LinkReadKind.Bytes ? ReaderStep.Value
                : read.Kind == LinkReadKind.Ended ? ReaderStep.Ended
                : read.RetryAfter is { } delay ? ReaderStep.WaitUntil(_context!.Now + delay)
                : ReaderStep.WaitForSignal;
        }

        public void Unblock() => link.Unblock();

        public void Close() => link.SetReadableCallback(null);
    }

    private sealed class MemoryBed : ReopeningBed
    {
        private MemoryLinkPair? _pair;
        private LinkCollector? _peerReads;
        private volatile bool _isUp;

        public MemoryBed(LinkOptions options)
        {
            Link = new ReopeningLink("memory:device", Connect, blocks: false, options);
            Assert.Equal(LinkReadKind.NothingYet, Link.Read(new byte[1]).Kind);
        }

        public override IByteLink Link { get; }

        public override void ComeUp()
        {
            _pair = new MemoryLinkPair("device");
            _peerReads = new LinkCollector(_pair.B);
            _isUp = true;
        }

        public override void AwaitPeer()
        {
            Await(() => Link.State == ByteLinkState.Open);
        }

        public override void PeerSends(params byte[] bytes) => _pair!.B.Write(bytes, 0, bytes.Length);

        public override byte[] PeerReceives(int count) => _peerReads!.Take(count);

        public override void PeerGoes()
        {
            _isUp = false;
            _pair?.B.Dispose();
        }

        private IByteLink Connect()
            => _isUp ? _pair!.A : throw new LinkException("memory:device", "it is not there", linkEnded: true);
    }
}
