using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.Linq;
using System.Threading.Tasks;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Energy;

/// <summary>Every flight lands at home: searches that are longer than the battery lasts, drawn by seeds.</summary>
public sealed class EnergyTrialTests(ITestOutputHelper output)
{
    private const int Flights = 60;

    // The uncertainties of the model were chosen with seeds 1 to 60: these have shown nothing before.
    private const int FirstSeed = 1001;
    private const double MaxLandingDistance = 3;
    private const double MinLeft = 0.05;
    private const double MaxMeanLeft = 0.25;

    [Fact, Trait("Category", "Long")]
    public void Flights_OfSixtySeeds_LandAtHomeWithFivePercentLeft()
    {
        var clock = Stopwatch.StartNew();
        string? asked = Environment.GetEnvironmentVariable("RABIT_ENERGY_SEED");
        int first = asked is null ? FirstSeed : int.Parse(asked, CultureInfo.InvariantCulture);
        EnergyFlight[] flights = Fly(Enumerable.Range(first, Flights).Select(
            s => EnergyCase.Draw(s, s % 2 == 0 ? SimulatedAutopilot.Px4 : SimulatedAutopilot.ArduPilot)));
        foreach (EnergyFlight flight in flights)
            output.WriteLine(flight.ToString());
        double mean = EnergyTrialDocument.MeanLeft(flights);
        output.WriteLine(EnergyTrialDocument.Summary(flights, clock.Elapsed));
        Assert.All(flights, Check);
        Assert.True(mean <= MaxMeanLeft, FormattableString.Invariant($"{mean} left on the average"));
        EnergyTrialDocument.Update(flights, clock.Elapsed);
    }

    internal static void Check(EnergyFlight flight)
    {
        Assert.True(flight.LandingDistance <= MaxLandingDistance && !flight.Truth.HasCrashed, flight.ToString());
        Assert.True(flight.Truth.BatteryRemaining >= MinLeft, flight.ToString());
    }

    private static EnergyFlight[] Fly(IEnumerable<EnergyCase> cases)
    {
        var flights = new ConcurrentDictionary<long, EnergyFlight>();
        Parallel.ForEach(
            cases, new ParallelOptions { MaxDegreeOfParallelism = Environment.ProcessorCount },
            drawn => flights[drawn.Seed] = EnergyFlight.Fly(drawn));
        return flights.OrderBy(f => f.Key).Select(f => f.Value).ToArray();
    }
}
