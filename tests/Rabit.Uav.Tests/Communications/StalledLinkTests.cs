using System;
using System.Diagnostics;
using System.Threading;
using Rabit.Core;
using Rabit.Links;
using Rabit.Tests.Shared;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>A link whose writes and reads hang keeps no other link and no manager waiting. In real time.</summary>
public sealed class StalledLinkTests
{
    [Fact]
    public void Link_WhoseWritesHang_DelaysNeitherAnotherNorTheManager()
    {
        using var stalled = new StalledLink();
        var from = new MemoryLinkPair("from");
        var to = new MemoryLinkPair("to");
        var manager = new CommunicationsManager(new CommunicationsOptions { Links = [stalled, from.A, to.A] });
        var autopilot = new FakeAutopilot(1024);
        var reactor = new RabitReactor(new ReactorOptions { StopsOnSignals = false }) { manager, autopilot };
        MessageSubscriber<LinkStatus> status =
            reactor.Workspace.Subscribe<LinkStatus>(MessageNames.LinkStatus(0));
        reactor.Workspace.Publish(MessageNames.OwnAddress, new OwnAddress { ComponentId = 191 });
        reactor.Workspace.Publish<VehicleState>(MessageNames.VehicleState);
        reactor.Workspace.Send<OutgoingFrame>(MessageNames.OutgoingFrames);
        reactor.Start();

        byte[] buffer = new byte[4096];
        TimeSpan shortest = TimeSpan.MaxValue;
        TimeSpan longest = TimeSpan.Zero;
        for (int i = 0; i < 600; i++)
        {
            byte[] frame = Frames.Heartbeat(sequence: (byte)i);
            var watch = Stopwatch.StartNew();
            from.B.Write(frame, 0, frame.Length);
            int received = 0;
            while (received < frame.Length)
            {
                Assert.InRange(watch.Elapsed, TimeSpan.Zero, TestTimeout.Limit);
                received += to.B.Read(buffer).Count;
            }

            if (watch.Elapsed < shortest) shortest = watch.Elapsed;
            if (watch.Elapsed > longest) longest = watch.Elapsed;
        }

        Assert.True(stalled.IsHanging);
        stalled.Unblock();
        reactor.Stop("the test is over");
        reactor.Finish();
        status.Fetch();

        // A busy machine makes single frames late, but a wait for the link would be there in every one.
        Assert.InRange(shortest, TimeSpan.Zero, TimeSpan.FromMilliseconds(50));
        Assert.InRange(longest, TimeSpan.Zero, TimeSpan.FromSeconds(5));
        Assert.InRange(status.Value.FramesDroppedOut, 600 - 256 - 2, 600);
    }

    /// <summary>Every read and write waits for the end.</summary>
    private sealed class StalledLink : IByteLink
    {
        private readonly ManualResetEvent _end = new(false);
        private int _isHanging;

        public bool IsHanging => Volatile.Read(ref _isHanging) != 0;

        public string Url => "stalled:0";

        public bool Blocks => true;

        public LinkCounters Counters => default;

        public ByteLinkState State => ByteLinkState.Open;

        public string? LastFault => null;

        public LinkRead Read(byte[] buffer, int timeoutMilliseconds = -1)
        {
            _end.WaitOne();
            return LinkRead.Ended("the test is over");
        }

        public void Write(byte[] buffer, int offset, int count)
        {
            Volatile.Write(ref _isHanging, 1);
            _end.WaitOne();
            throw new LinkException(Url, "the test is over", linkEnded: true);
        }

        public void Unblock() => _end.Set();

        public void SetReadableCallback(Action? callback)
        {
        }

        public void Dispose()
        {
            _end.Set();
            _end.Dispose();
        }
    }
}
