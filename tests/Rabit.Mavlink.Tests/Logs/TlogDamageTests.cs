using System;
using System.Collections.Generic;
using System.Linq;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Mavlink.Tests.Logs;

/// <summary>
/// Copies of a flight with damage in many places, by fixed seeds: every record that was not touched is found.
/// </summary>
public class TlogDamageTests(ITestOutputHelper output)
{
    private const int Damages = 200;

    [Theory]
    [InlineData("ardupilot-flight", 1)]
    [InlineData("ardupilot-flight", 2)]
    [InlineData("px4-flight", 3)]
    [InlineData("px4-flight", 4)]
    public void TryRead_DamagedFlight_DeliversEveryUntouchedRecord(string name, int seed)
    {
        output.WriteLine($"seed {seed}");
        byte[] flight = TestData.Bytes(name + ".tlog");
        LogBuilder.Read(flight, out List<ReadRecord> all);
        byte[] damaged = Damaged(flight, all, new Random(seed), out HashSet<int> touched);
        TlogReader log = LogBuilder.Read(damaged, out List<ReadRecord> records);

        var found = new HashSet<string>(records.Select(record => record.ToString()), StringComparer.Ordinal);
        Assert.All(
            all.Where((_, index) => !touched.Contains(index)), record => Assert.Contains(record.ToString(), found));
        Assert.Equal(
            damaged.Length,
            log.LostBytes + records.Sum(record => 8 + record.Wire.Length) + (damaged.Length - log.Position));
        Assert.InRange(records.Count, all.Count - touched.Count, all.Count);
        output.WriteLine($"{touched.Count} touched, {log.LostBytes} bytes lost, first at {log.FirstDamageOffset}");
    }

    // Bytes changed, cut out, and garbage put in.
    private static byte[] Damaged(byte[] flight, List<ReadRecord> all, Random random, out HashSet<int> touched)
    {
        touched = [];
        var bytes = flight.ToList();
        foreach (int index in Enumerable.Range(0, Damages).Select(_ => random.Next(all.Count)).Distinct()
            .OrderByDescending(index => index).ToList())
        {
            int offset = (int)all[index].Record.Offset;
            int length = 8 + all[index].Wire.Length;
            touched.Add(index);
            switch (random.Next(3))
            {
                case 0:
                    bytes[offset + 8 + random.Next(length - 8)] ^= (byte)(1 << random.Next(8));
                    break;
                case 1:
                    bytes.RemoveRange(offset + random.Next(length), 1);
                    break;
                default:
                    var garbage = new byte[random.Next(1, 500)];
                    random.NextBytes(garbage);
                    bytes.InsertRange(offset + random.Next(length), garbage);
                    break;
            }
        }
        return bytes.ToArray();
    }
}
