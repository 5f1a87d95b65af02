using System;
using System.Collections.Generic;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Group;

/// <summary>
/// Three vehicles search 24 ha with ten targets, by pictures, in part of the time of one that revisits them itself. Its
/// output is the table of docs/managers/mission-control.md.
/// </summary>
public sealed class GroupCoverageTests(ITestOutputHelper output)
{
    // All of them see so much.
    private const double Fraction = 0.98;

    [Fact]
    [Trait("Category", "Long")]
    public void Flights_OfTwentySeeds_TakeLittleOfTheTimeOfOne()
    {
        var faults = new List<string>();
        for (int seed = 1; seed <= 20; seed++)
        {
            using var three = new CoverageFlight(3, seed);
            using var one = new CoverageFlight(1, seed);
            Assert.True(three.Fly() && one.Fly(), $"seed {seed}: {three.Timeline()}");
            double coverage = three.SecondsTo(Fraction) / one.SecondsTo(Fraction);
            double whole = three.Seconds / one.Seconds;
            output.WriteLine(FormattableString.Invariant(
                $"seed {seed}: 98 % seen after {three.SecondsTo(Fraction):0} s and {one.SecondsTo(Fraction):0} s, ")
                + FormattableString.Invariant($"{coverage:0.00}; landed after {three.Seconds:0} s and ")
                + FormattableString.Invariant($"{one.Seconds:0} s, {whole:0.00}; found {three.Found}, confirmed ")
                + FormattableString.Invariant(
                    $"{three.Confirmed}, false {three.FalseTracks}, rejected {three.Rejected}"));
            if (!(coverage <= 0.40 && whole <= 0.45)
                || (three.Found, three.Confirmed, three.FalseTracks) != (10, 10, 0)
                || three.Flight.Group.TooNear.Count > 0)
                faults.Add($"seed {seed}: {three.Timeline()}");
        }

        Assert.True(faults.Count == 0, string.Join(Environment.NewLine, faults));
    }
}
