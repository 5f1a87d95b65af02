using System;
using System.IO;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Tests.Signing;
using Rabit.Tests.Shared;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Mavlink.Tests.Framing;

/// <summary>Nothing is allocated per frame, on .NET and on Mono.</summary>
[Collection(AloneCollection.Name)]
public class AllocationTests(ITestOutputHelper output)
{
    [Fact]
    public void ReadDecodeRouteWriteCreate_WholeFlight_AllocatesNothing()
    {
        byte[] flight = TestData.Bytes("ardupilot-flight.tlog");
        var reader = new MavlinkFrameReader(MavlinkDialect.All);
        var sequences = new MavlinkSequenceTracker();
        var router = new MavlinkRouter(1, 191);
        router.SetLink(0, MavlinkLinkRules.Live);
        router.SetLink(1, MavlinkLinkRules.Live);
        var wire = new byte[MavlinkFrame.MaxWireLength];
        long written = 0;

        AssertAllocatesNothing(() =>
        {
            ReadOnlySpan<byte> rest = flight;
            while (reader.TryRead(ref rest, out MavlinkFrame frame, out MavlinkFrameInfo info))
            {
                sequences.Track(frame);
                if (router.Route(0, frame, info).GoesTo(1))
                    written += frame.WriteTo(wire);
                if (frame.TryDecode(out Attitude attitude))
                    written += MavlinkFrame.Create(attitude, 1, 191, 0).WriteTo(wire);
            }
        });
        Assert.True(written > flight.Length, $"{written}");
    }

    [Fact]
    public void ReadAndWriteLog_WholeFlight_AllocatesNothing()
    {
        var file = new MemoryStream(TestData.Bytes("px4-flight.tlog"));
        var copy = new MemoryStream((int)file.Length);
        var writer = new TlogWriter(copy);
        TlogReader? log = null;

        AssertAllocatesNothing(
            () =>
            {
                while (log!.TryRead(out MavlinkFrame frame, out TlogRecord record))
                    writer.Write(record.TimeMicroseconds, frame);
            },
            () =>
            {
                file.Position = copy.Position = 0;
                log = new TlogReader(file, MavlinkDialect.All);
            });
        Assert.Equal(file.Length, copy.Length);
    }

    [Fact]
    public void SendSignVerify_ManyFrames_AllocatesNothing()
    {
        var clock = Keys.ClockAt(Keys.Noon);
        var sender = new MavlinkSender(1, 191) { Signer = new MavlinkSigner(Keys.One, 2, clock) };
        var reader = new MavlinkFrameReader(MavlinkDialect.All);
        var verifier = new MavlinkVerifier(Keys.One, clock);
        var wire = new byte[MavlinkFrame.MaxWireLength];

        AssertAllocatesNothing(() =>
        {
            // What xunit asserts, it boxes: the counters are looked at behind.
            for (int count = 0; count < 2000; count++)
            {
                ReadOnlySpan<byte> rest = wire.AsSpan(0, sender.Write(new Attitude { Yaw = count }, wire.AsSpan()));
                reader.TryRead(ref rest, out MavlinkFrame frame, out _);
                verifier.Verify(frame);
                verifier.Verify(frame);
                verifier.Verify(sender.Create(default(Heartbeat)));
            }
        });
        Assert.Equal(verifier.Counters.OldTimestamps * 2, verifier.Counters.Valid);
        Assert.InRange(verifier.Counters.Valid, 8000, long.MaxValue);
    }

    // Also where the runtime counts no bytes: what allocates brings a collection sooner or later.
    [Fact]
    public void ReadDecodeEncodeSignVerify_AMillionFrames_CollectsNothing()
    {
        var clock = Keys.ClockAt(Keys.Noon);
        var sender = new MavlinkSender(1, 191);
        var signing = new MavlinkSender(1, 191) { Signer = new MavlinkSigner(Keys.One, 2, clock) };
        var reader = new MavlinkFrameReader(MavlinkDialect.All);
        var verifier = new MavlinkVerifier(Keys.One, clock);
        var wire = new byte[MavlinkFrame.MaxWireLength];
        int collections = 0;
        for (int attempt = 0; attempt < 5; attempt++)
        {
            long read = 0;
            GC.Collect();
            collections = GC.CollectionCount(0);
            for (int count = 0; count < 1_000_000; count++)
            {
                // Every eighth is signed: that takes as long as twenty frames without.
                ReadOnlySpan<byte> rest = wire.AsSpan(0, (count % 8 == 0 ? signing : sender)
                    .Write(new Heartbeat { CustomMode = (uint)count }, wire.AsSpan()));
                if (reader.TryRead(ref rest, out MavlinkFrame frame, out _) && frame.TryDecode(out Heartbeat heartbeat)
                    && heartbeat.CustomMode == count)
                    read += count % 8 != 0 || verifier.Verify(frame).IsAccepted() ? 1 : 0;
            }

            collections = GC.CollectionCount(0) - collections;
            Assert.Equal(1_000_000, read);

            // The test runner may have caused it: once in five attempts it does not.
            if (collections == 0)
                break;
        }

        output.WriteLine($"{collections} collections");
        Assert.Equal(0, collections);
    }

    private void AssertAllocatesNothing(Action work, Action? prepare = null)
    {
        prepare?.Invoke();
        work();
        long allocated = Allocated.By(work, prepare);
        output.WriteLine(Allocated.IsSupported ? $"{allocated} bytes" : "this runtime does not count bytes per thread");
        Assert.Equal(0, allocated);
    }
}
