using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Uav.Tests.Communications.Sending;

/// <summary>Small frames that go out in one write: within a hold time, and never an urgent one later.</summary>
public sealed class LinkHoldTests
{
    private readonly WriteCounter _link = new();

    [Fact]
    public void Frames_WithinTheHoldTime_GoOutInOneWriteAtItsEnd()
    {
        using CommunicationsRig rig = Rig();
        for (byte n = 0; n < 5; n++)
        {
            rig.Send(0, Frames.Of(new Attitude { Yaw = n + 1 }, sequence: n));
            rig.Run(TimeSpan.FromMilliseconds(3));
        }

        Assert.Empty(_link.Writes);
        rig.Run(TimeSpan.FromMilliseconds(6));
        Assert.Equal(5, Frames.Read(Assert.Single(_link.Writes)).Count);
        rig.Run(TimeSpan.FromMilliseconds(100));
        Assert.Single(_link.Writes);
        Assert.Equal(5, rig.Status(1).FramesOut);
    }

    [Fact]
    public void UrgentFramesAndCommands_TakeAlongWhatWaitsAtOnce()
    {
        using CommunicationsRig rig = Rig();
        rig.Send(0, Frames.Of(new Attitude { Yaw = 1 }));
        rig.Send(0, Frames.Heartbeat(sequence: 1));
        Assert.Equal(
            [Attitude.MavlinkId, Heartbeat.MavlinkId],
            Frames.Read(Assert.Single(_link.Writes)).Select(f => f.MessageId));
        rig.Send(0, Frames.Of(new CommandLong { Command = MavCmd.RequestMessage, Param1 = 1 }, sequence: 2));
        Assert.Equal(2, _link.Writes.Count);
    }

    [Fact]
    public void Frames_MoreThanADatagramHolds_GoOutInSeveralWrites()
    {
        using CommunicationsRig rig = Rig();
        byte[][] frames = Enumerable.Range(0, 100)
            .Select(n => Frames.Of(new Attitude { Yaw = n + 1, Yawspeed = 1 }, sequence: (byte)n)).ToArray();
        rig.Send(0, frames);
        rig.Run(TimeSpan.FromMilliseconds(21));

        Assert.All(_link.Writes, w => Assert.InRange(w.Length, 1, 1400));
        Assert.InRange(_link.Writes.Count, 3, 4);
        Assert.Equal(Frames.Join(frames), Frames.Join(_link.Writes));
    }

    [Fact]
    public void Write_ThatIsLost_CountsAllItsFrames()
    {
        using CommunicationsRig rig = Rig();
        _link.Fault = new LinkException("count:0", "no route", linkEnded: false);
        for (byte n = 0; n < 3; n++)
            rig.Send(0, Frames.Of(new Attitude { Yaw = n + 1 }, sequence: n));
        rig.Run(TimeSpan.FromMilliseconds(21));
        Assert.Equal((0L, 3L), (rig.Status(1).FramesOut, rig.LastStatus(1).FramesDroppedOut));
    }

    [Fact]
    public void End_WithFramesThatWait_WritesThem()
    {
        CommunicationsRig rig = Rig();
        rig.Send(0, Frames.Of(new Attitude { Yaw = 1 }));
        rig.Finish();
        Assert.Single(_link.Writes);
    }

    [Fact]
    public void Frames_ThroughTheHold_AllocateNothing()
    {
        using CommunicationsRig rig = Rig(keeps: false);
        _link.Keeps = false;
        byte[][] frames = Enumerable.Range(0, 256)
            .Select(n => Frames.Of(new Attitude { Yaw = n + 1, Yawspeed = 1 }, sequence: (byte)n)).ToArray();
        Forward();
        Assert.Equal(0, Allocated.By(Forward));

        void Forward()
        {
            foreach (byte[] frame in frames)
            {
                rig.Far(0).Write(frame, 0, frame.Length);
                rig.Run(TimeSpan.FromMilliseconds(5));
            }
        }
    }

    private CommunicationsRig Rig(bool keeps = true) => new CommunicationsRig(
        links: 1,
        o =>
        {
            o.Links = [.. o.Links, _link];
            o.PositionRateHz = 0;
            o.LinkSettings = new Dictionary<int, LinkSettings>
            {
                [1] = new LinkSettings { HoldTime = TimeSpan.FromMilliseconds(20) },
            };
        },
        new FakeAutopilot(1024) { Keeps = keeps }).As(1);

    /// <summary>Keeps what it is to write.</summary>
    private sealed class WriteCounter : IByteLink
    {
        public List<byte[]> Writes { get; } = [];

        public bool Keeps { get; set; } = true;

        public Exception? Fault { get; set; }

        public string Url => "count:0";

        public bool Blocks => false;

        public LinkCounters Counters => default;

        public ByteLinkState State => ByteLinkState.Open;

        public string? LastFault => null;

        public LinkRead Read(byte[] buffer, int timeoutMilliseconds = Timeout.Infinite) => LinkRead.NothingYet;

        public void Write(byte[] buffer, int offset, int count)
        {
            if (Fault is not null)
                throw Fault;
            if (Keeps)
                Writes.Add(buffer.Skip(offset).Take(count).ToArray());
        }

        public void Unblock()
        {
        }

        public void SetReadableCallback(Action? callback)
        {
        }

        public void Dispose()
        {
        }
    }
}
