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

namespace Rabit.Uav.Tests.Communications;

/// <summary>Frames from a link and to a link, as Communications and the simulation use them.</summary>
public sealed class MavlinkLinkTests
{
    // Announces 200 bytes of payload that never come: what is behind it is held back while it might be a part of it.
    private static readonly byte[] TornFrame = [0xFD, 200, 0, 0, 0, 1, 1, 0xEF, 0xCD, 0xAB];

    [Fact]
    public void Source_LinkEndsAfterATornFrame_StillDeliversTheFramesAfterIt()
    {
        var pair = new MemoryLinkPair("link", 4096);
        var source = new MavlinkLinkSource(pair.A, number: 3);
        List<LinkFrame> frames = Run(source, () =>
        {
            Write(pair.B, TornFrame);
            Write(pair.B, Frames.Heartbeat(sequence: 5));
            pair.B.Dispose();
        });

        LinkFrame frame = Assert.Single(frames);
        Assert.Equal((true, 3, (byte)5), (frame.IsChecked, frame.Link, frame.Frame.Sequence));
        Assert.Equal(TornFrame.Length, source.BytesLost);
    }

    [Fact]
    public void Source_SaysWhatTheReaderFoundOut()
    {
        var pair = new MemoryLinkPair("link", 4096);
        List<LinkFrame> frames = Run(new MavlinkLinkSource(pair.A, dialect: WinchState.Dialect), () =>
        {
            Write(pair.B, Frames.Of(Frames.Command(7, 8), 255, 190));
            Write(pair.B, Frames.Of(new WinchState { TargetSystem = 9, TargetComponent = 10 }));
            Write(pair.B, Frames.Raw(Frames.UnknownId, [1, 2]));
            pair.B.Dispose();
        });

        Assert.Equal(
            [(true, (byte)7, (byte)8), (true, (byte)9, (byte)10), (false, (byte)0, (byte)0)],
            frames.Select(f => (f.IsChecked, f.TargetSystemId, f.TargetComponentId)));
    }

    [Fact]
    public void Target_FrameByWhichTheLinkEnds_IsCountedAsLost()
    {
        var target = new MavlinkLinkTarget(
            new FaultyLink { WriteFault = new LinkException("fake:0", "the cable was pulled", linkEnded: true) });

        Assert.Throws<LinkException>(() => target.Write(Frame()));

        Assert.Equal(1, target.Lost);
    }

    [Fact]
    public void Target_FrameThatOneWriteLoses_IsCountedAndTheNextOneIsWritten()
    {
        var link = new FaultyLink { WriteFault = new LinkException("fake:0", "the way out is full", linkEnded: false) };
        var target = new MavlinkLinkTarget(link);

        target.Write(Frame());
        link.WriteFault = null;
        target.Write(Frame());

        Assert.Equal((1L, 1), (target.Lost, link.Written));
    }

    private static MavlinkFrame Frame() => MavlinkFrame.Create(new Heartbeat(), 1, 1, 0);

    private static void Write(IByteLink link, byte[] bytes) => link.Write(bytes, 0, bytes.Length);

    private static List<LinkFrame> Run(MavlinkLinkSource source, Action act)
    {
        var collector = new Collector(source);
        var reactor = new RabitReactor(
            new ReactorOptions { Time = new VirtualTime(0), StopsOnSignals = false }) { collector };
        reactor.Start();
        act();
        reactor.RunFor(TimeSpan.FromSeconds(1));
        reactor.Stop("the test is over");
        reactor.Finish();
        return collector.Taken;
    }

    private sealed class Collector : RabitManager
    {
        private readonly BlockingReader<LinkFrame> _reader;

        public Collector(MavlinkLinkSource source)
            : base("collector") => _reader = AttachReader("link", source);

        public List<LinkFrame> Taken { get; } = [];

        protected override void ExecuteUnitOfWork()
        {
            while (_reader.TryPop(out LinkFrame frame))
                Taken.Add(frame);
        }
    }
}
