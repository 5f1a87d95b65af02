using System;
using System.Diagnostics;
using System.Net;
using System.Threading;
using Xunit;

namespace Rabit.Links.Tests;

/// <summary>A name service that does not answer keeps no stop waiting.</summary>
public sealed class NameLookUpTests
{
    private static readonly TimeSpan Limit = TimeSpan.FromMilliseconds(100);

    [Fact]
    public void Stop_WhileANameIsLookedUp_EndsTheOpeningWithin100Milliseconds()
    {
        TimeSpan best = TimeSpan.MaxValue; // of five, so that a busy machine does not matter
        for (int attempt = 0; attempt < 5; attempt++)
        {
            var service = new SilentNameService();
            var stop = new LinkStop();
            Exception? fault = null;
            var opening = new Thread(() => fault = Record.Exception(
                () => TcpAddresses(service, stop)));
            opening.Start();
            Assert.True(service.Asked.Wait(LinkTestBed.TestTimeout));

            var watch = Stopwatch.StartNew();
            stop.Request();
            Assert.True(opening.Join(LinkTestBed.TestTimeout));

            if (watch.Elapsed < best) best = watch.Elapsed;
            Assert.Equal("link tcp:gcs:5760: it was closed on this side", Assert.IsType<LinkException>(fault).Message);
        }

        Assert.True(best < Limit, $"the best of five took {best.TotalMilliseconds} ms");
    }

    [Fact]
    public void Unblock_WhileANameIsLookedUpAgain_EndsTheReadWithin100Milliseconds()
    {
        TimeSpan best = TimeSpan.MaxValue;
        for (int attempt = 0; attempt < 5; attempt++)
        {
            var service = new SilentNameService();
            bool isOpening = true;
            var clock = new UdpPeersTests.ManualClock();
            using UdpSendLink link = UdpSendLink.Open(
                "gcs", 14550, new LinkOptions(clock: clock), new LinkStop(),
                s => isOpening ? IPAddress.Loopback : HostAddresses.Find("udpout:gcs:14550", "gcs", s, service.Ask)[0]);
            isOpening = false;
            clock.Advance(TimeSpan.FromSeconds(31));
            var collector = new LinkCollector(link);
            Assert.True(service.Asked.Wait(LinkTestBed.TestTimeout));

            var watch = Stopwatch.StartNew();
            link.Unblock();
            LinkRead end = collector.WaitForEnd();

            if (watch.Elapsed < best) best = watch.Elapsed;
            Assert.Equal("it was closed on this side", end.Reason);
        }

        Assert.True(best < Limit, $"the best of five took {best.TotalMilliseconds} ms");
    }

    private static IPAddress[] TcpAddresses(SilentNameService service, LinkStop stop)
        => HostAddresses.Find("tcp:gcs:5760", "gcs", stop, service.Ask);

    /// <summary>Takes questions and never answers.</summary>
    private sealed class SilentNameService : IAsyncResult
    {
        private readonly ManualResetEvent _answer = new(false);

        public ManualResetEventSlim Asked { get; } = new();

        public object? AsyncState => null;

        public WaitHandle AsyncWaitHandle => _answer;

        public bool CompletedSynchronously => false;

        public bool IsCompleted => false;

        public SilentNameService Ask(string host)
        {
            Asked.Set();
            return this;
        }
    }
}
