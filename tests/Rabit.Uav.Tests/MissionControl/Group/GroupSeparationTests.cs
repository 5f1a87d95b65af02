using System;
using System.Collections.Generic;
using System.Linq;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.MissionControl.Group;

/// <summary>
/// Vehicles of a group keep 30 m apart over ground or 15 m in height, but within 15 m of one's own landing place,
/// whatever is lost and whatever happens to one of them.
/// </summary>
public sealed class GroupSeparationTests(ITestOutputHelper output)
{
    [Theory]
    [InlineData(201)]
    public void Flight_OfASeed_KeepsTheVehiclesApart(int seed)
    {
        using var flight = new SeparationFlight(seed);
        flight.Fly();
        Assert.True(flight.HasEnded, flight.Story);
        Assert.True(flight.TooNear.Count == 0, flight.TooNear.FirstOrDefault() + flight.Story);
    }

    [Theory]
    [InlineData(310)]
    [InlineData(362)]
    [InlineData(382)]
    public void Flight_OneSinksIntoTheLayerOfAnother_KeepsTheVehiclesApart(int seed)
    {
        using var flight = new SeparationFlight(seed, sinks: true);
        flight.Fly();
        Assert.True(flight.HasEnded, flight.Story);
        Assert.True(flight.TooNear.Count == 0, flight.TooNear.FirstOrDefault() + flight.Story);
    }

    // The layers are 20 m apart: 5 m are left for both errors together.
    [Fact, Trait("Category", "Long")]
    public void Flights_HeightsAreWrongByMoreThanTheLayersAllow_AreFoundTooNear()
    {
        bool isFound = false;
        for (int seed = 209; seed <= 212 && !isFound; seed++)
        {
            using var flight = new SeparationFlight(seed, heightErrorMetres: 8);
            flight.Fly();
            isFound |= flight.TooNear.Count > 0;
        }

        Assert.True(isFound);
    }

    // 20 m of height between two would become 12.5 m by their barometers; their satellite receivers show it.
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Flight_BarometersDrift_LayersStayApartByTheSatelliteReceivers(bool hasGnss)
    {
        using var flight = new SeparationFlight(506, driftMetres: 5, hasGnss: hasGnss);
        flight.Fly();
        Assert.True(flight.HasEnded, flight.Story);
        Assert.True(hasGnss == (flight.TooNear.Count == 0), flight.TooNear.FirstOrDefault() + flight.Story);
    }

    [Fact, Trait("Category", "Long")]
    public void Flights_BarometersDrift_KeepTheVehiclesApart() => Fly(501, 50, sinks: false, driftMetres: 5);

    [Fact]
    [Trait("Category", "Long")]
    public void Flights_OfTwoHundredSeeds_KeepTheVehiclesApart()
    {
        (int passes, int validated, int followed) = Fly(1, 200, sinks: false);
        Assert.True(
            validated > 200 && followed > 100 && passes > 200,
            $"{validated} validated, {followed} followed, {passes} passes");
    }

    [Fact]
    [Trait("Category", "Long")]
    public void Flights_OneSinksIntoTheLayerOfAnother_KeepTheVehiclesApart() => Fly(301, 100, sinks: true);

    // It searches all that it does not know to be seen, in its own layer, and so do the others in theirs.
    [Fact]
    [Trait("Category", "Long")]
    public void Flights_RadioOfOneFails_KeepTheVehiclesApart()
    {
        (int passes, _, _) = Fly(401, 100, sinks: false, losesRadio: true);
        Assert.True(passes > 100, $"{passes} passes");
    }

    private (int Passes, int Validated, int Followed) Fly(
        int first, int flights, bool sinks, bool losesRadio = false, double driftMetres = 0)
    {
        var faults = new List<string>();
        (double least, int passes, int validated, int followed) = (double.PositiveInfinity, 0, 0, 0);
        for (int seed = first; seed < first + flights; seed++)
        {
            using var flight = new SeparationFlight(
                seed, sinks: sinks, losesRadio: losesRadio, driftMetres: driftMetres);
            flight.Fly();
            (least, passes) = (Math.Min(least, flight.MinHeightMetres), passes + flight.Passes);
            (validated, followed) = (validated + flight.Validations, followed + flight.Followed);
            if (!flight.HasEnded)
                faults.Add($"seed {seed} has not ended");
            if (flight.TooNear.Count > 0)
                faults.Add($"seed {seed}: {flight.TooNear.Count} times, first {flight.TooNear[0]}");
        }

        output.WriteLine(FormattableString.Invariant(
            $"{flights} flights: {validated} targets validated, {followed} followed; {passes} times two were within ")
            + FormattableString.Invariant($"30 m over ground, with {least:0.0} m of height between them or more"));
        Assert.True(faults.Count == 0, string.Join(Environment.NewLine, faults));
        return (passes, validated, followed);
    }
}
