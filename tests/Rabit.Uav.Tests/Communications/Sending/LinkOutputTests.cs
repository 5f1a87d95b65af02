using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications.Sending;

/// <summary>Frames that go out at once where the link takes them without a wait, and by the writer where not.</summary>
public sealed class LinkOutputTests
{
    private readonly DirectLink _link = new();

    [Fact]
    public void Frames_LinkHasRoom_GoOutAtOnce()
    {
        using CommunicationsRig rig = Rig();

        rig.Send(0, Numbered(1), Numbered(2), Numbered(3));

        Assert.Equal(["1 at once", "2 at once", "3 at once"], _link.Sent);
        Assert.Equal(3, rig.Status(1).FramesOut);
    }

    [Fact]
    public void Frames_OneHadToWait_TheNextDoNotPassIt()
    {
        using CommunicationsRig rig = Rig();
        _link.Refusals = 1;

        rig.Send(0, Numbered(1), Numbered(2), Numbered(3));
        Assert.Equal(["1", "2", "3"], _link.Sent);
        rig.Send(0, Numbered(4));

        Assert.Equal("4 at once", _link.Sent.Last());
        Assert.Equal(4, rig.Status(1).FramesOut);
    }

    [Fact]
    public void Frames_WriterHadToDropSome_GoOutAtOnceAgain()
    {
        using CommunicationsRig rig = Rig(framesWaitingOut: 2);
        _link.Refusals = 1;

        rig.Send(0, Numbered(1), Numbered(2), Numbered(3), Numbered(4), Numbered(5));
        Assert.Equal(["4", "5"], _link.Sent);
        rig.Send(0, Numbered(6));

        Assert.Equal("6 at once", _link.Sent.Last());
        rig.Run(TimeSpan.FromSeconds(1));
        Assert.Equal((3L, 3L), (rig.Status(1).FramesOut, rig.Status(1).FramesDroppedOut));
    }

    [Fact]
    public void Frames_WriterLostOne_GoOutAtOnceAgain()
    {
        using CommunicationsRig rig = Rig();
        (_link.Refusals, _link.Losses) = (1, 1);

        rig.Send(0, Numbered(1));
        rig.Send(0, Numbered(2));

        Assert.Equal(["2 at once"], _link.Sent);
        rig.Run(TimeSpan.FromSeconds(1));
        Assert.Equal((1L, 1L), (rig.Status(1).FramesOut, rig.Status(1).FramesDroppedOut));
    }

    private static byte[] Numbered(byte n) => Frames.Of(new Attitude { Yaw = n }, sequence: n);

    private CommunicationsRig Rig(int framesWaitingOut = 256) => new CommunicationsRig(links: 1, o =>
    {
        o.Links = [.. o.Links, _link];
        o.PositionRateHz = 0;
        o.FramesWaitingOut = framesWaitingOut;
    }).As(1);

    /// <summary>Takes what it gets, but refuses to do so at once so many times.</summary>
    private sealed class DirectLink : IByteLink, INonBlockingWriter
    {
        public List<string> Sent { get; } = [];

        public int Refusals { get; set; }

        public int Losses { get; set; }

        public string Url => "direct:0";

        public bool Blocks => false;

        public LinkCounters Counters => default;

        public ByteLinkState State => ByteLinkState.Open;

        public string? LastFault => null;

        public LinkRead Read(byte[] buffer, int timeoutMilliseconds = Timeout.Infinite) => LinkRead.NothingYet;

        public bool TryWrite(byte[] buffer, int offset, int count)
        {
            if (Refusals-- > 0)
                return false;
            Sent.Add(Describe(buffer, offset, count) + " at once");
            return true;
        }

        public void Write(byte[] buffer, int offset, int count)
        {
            if (Losses-- > 0)
                throw new LinkException(Url, "lost", linkEnded: false);
            Sent.Add(Describe(buffer, offset, count));
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

        private static string Describe(byte[] buffer, int offset, int count)
        {
            MavlinkFrame frame = Assert.Single(Frames.Read(buffer.Skip(offset).Take(count).ToArray()));
            return frame.TryDecode(out Attitude attitude) ? $"{attitude.Yaw}" : frame.ToString();
        }
    }
}
