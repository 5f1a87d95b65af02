using System;
using System.IO;
using Rabit.Mavlink.Messages;
using Rabit.Tests.Shared;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Mavlink.Tests.Framing;

/// <summary>Nothing is allocated per frame, on .NET and on Mono.</summary>
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
        var wire = new byte[MavlinkFrame.MaximumWireLength];
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

    private void AssertAllocatesNothing(Action work, Action? prepare = null)
    {
        prepare?.Invoke();
        work();
        long allocated = Allocated.By(work, prepare);
        output.WriteLine(Allocated.CanTell ? $"{allocated} bytes" : "this runtime does not count bytes per thread");
        Assert.Equal(0, allocated);
    }
}
