using System.Diagnostics;
using Rabit.Tests.Shared;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Mavlink.Tests.Logs;

/// <summary>A log of any size takes one buffer and no more.</summary>
public class TlogSizeTests(ITestOutputHelper output)
{
    [Fact]
    public void TryRead_64Megabytes_AllocatesNothing() => ReadRepeatedFlight(64L << 20);

    [Fact]
    [Trait("Category", "Long")]
    public void TryRead_OneGigabyte_AllocatesNothing() => ReadRepeatedFlight(1L << 30);

    private void ReadRepeatedFlight(long length)
    {
        byte[] flight = TestData.Bytes("px4-flight.tlog");
        length -= length % flight.Length;
        TlogReader log = null!;
        var watch = new Stopwatch();
        void Read()
        {
            watch.Restart();
            while (log.TryRead(out _, out _))
            {
                // Only the reading counts.
            }

            watch.Stop();
        }

        void Open(long bytes) => log = new TlogReader(new OneWayStream(flight, bytes), MavlinkDialect.All);
        Open(flight.Length);
        Read();
        long recordsPerFlight = log.Records;

        long allocated = Allocated.By(Read, () => Open(length));
        output.WriteLine($"{length / 1e6:0} MB in {watch.Elapsed.TotalSeconds:0.0} s, "
            + $"{length / 1e6 / watch.Elapsed.TotalSeconds:0} MB/s");
        Assert.Equal((0L, 0L), (allocated, log.LostBytes));
        Assert.Equal(recordsPerFlight * (length / flight.Length), log.Records);
    }
}
