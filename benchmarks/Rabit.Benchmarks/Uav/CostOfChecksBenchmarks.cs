using System;
using BenchmarkDotNet.Attributes;
using BenchmarkDotNet.Engines;
using Rabit.Benchmarks.Uav.CostOfChecks;

namespace Rabit.Benchmarks.Uav;

/// <summary>
/// What the rules of Health Monitoring, the energy model and the judging of pictures add to the processor time of a
/// simulated search: 10 % at most. They cannot be switched off, so each is done alone, with what the flight had, and
/// counted as often as in the flight. Read the table that it prints: the time beside it is that of all of this.
/// </summary>
[SimpleJob(RunStrategy.Monitoring, launchCount: 1, warmupCount: 0, iterationCount: 2)]
public class CostOfChecksBenchmarks
{
    private const double Limit = 0.10;

    private MeasuredSearch? _recorded;

    /// <summary>Compiles everything too, so that the flight that is measured does not.</summary>
    [GlobalSetup]
    public void Record() => _recorded = MeasuredSearch.Fly(isRecorded: true);

    [Benchmark]
    public double Added()
    {
        MeasuredSearch flight = MeasuredSearch.Fly(isRecorded: false);
        var parts = new CheckParts(_recorded!);
        double all = flight.Cpu.TotalMicroseconds;
        double ofWorld = flight.Camera.Cpu.TotalMicroseconds;
        Console.WriteLine(FormattableString.Invariant(
            $"// flight of {flight.Duration.TotalSeconds:0} s: {all / 1e6:0.00} s of the processor, ")
            + FormattableString.Invariant($"of which {ofWorld / 1e6:0.00} s make the pictures"));
        double added = Print("rules", flight.HealthEvaluations, parts.HealthMicroseconds(), all)
            + Print("energy", flight.EnergyUpdates, parts.EnergyMicroseconds(), all)
            + Print("pictures", flight.PicturesJudged, parts.PictureMicroseconds(), all);
        double ratio = added / (all - added);
        Console.WriteLine(FormattableString.Invariant(
            $"// added: {ratio:P2}, limit {Limit:P0}; ")
            + FormattableString.Invariant($"without making the pictures {added / (all - ofWorld - added):P2}"));
        return ratio <= Limit
            ? ratio
            : throw new InvalidOperationException($"The checks add {ratio:P1}; the limit is {Limit:P0}.");
    }

    private static double Print(string part, long count, double microseconds, double all)
    {
        if (!(count > 0 && microseconds > 0))
            throw new InvalidOperationException($"{part}: {count} times {microseconds} us: not measured.");
        Console.WriteLine(FormattableString.Invariant(
            $"// {part,-9} {count,6} x {microseconds,7:0.00} us, {count * microseconds / all:P2}"));
        return count * microseconds;
    }
}
