using System;
using System.Collections.Concurrent;
using System.Linq;
using System.Threading.Tasks;
using Rabit.Uav.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Missions;

/// <summary>
/// Pictures that cannot be used: reported in time, held for, and never taken for ground that was seen.
/// </summary>
public sealed class PictureFaultTests(ITestOutputHelper output)
{
    private static readonly TimeSpan MaxDelay = TimeSpan.FromSeconds(3);

    // Some way into the first lane.
    private static readonly TimeSpan IntoTheSearch = TimeSpan.FromSeconds(4);

    private static readonly ConcurrentDictionary<(long Seed, bool IsSmall), TimeSpan> TimesOfSearch = new();

    private static readonly (string Name, ScriptedFaultKind Kind, double Value, PictureQuality Quality)[] Kinds =
    [
        ("black", ScriptedFaultKind.PicturesBlack, 0, PictureQuality.Black),
        ("white", ScriptedFaultKind.PicturesWhite, 0, PictureQuality.White),
        ("frozen", ScriptedFaultKind.PicturesFrozen, 0, PictureQuality.Frozen),
        ("frozen, new noise", ScriptedFaultKind.PicturesFrozen, 1, PictureQuality.Frozen),
        ("defocused", ScriptedFaultKind.PicturesDefocused, 0, PictureQuality.Defocused),
        ("covered", ScriptedFaultKind.PicturesCovered, 0, PictureQuality.Covered),
        ("motion blur", ScriptedFaultKind.PicturesMotionBlurred, 0, PictureQuality.MotionBlurred),
        ("same number", ScriptedFaultKind.PictureNumbersRepeat, 0, PictureQuality.RepeatedNumber),
        ("clock 60 s late", ScriptedFaultKind.PictureTimesOff, 60, PictureQuality.NoPose),
        ("clock 60 s early", ScriptedFaultKind.PictureTimesOff, -60, PictureQuality.NoPose),
        ("no attitude", ScriptedFaultKind.AttitudeSilent, 0, PictureQuality.NoPose),
    ];

    [Theory]
    [InlineData("black")]
    [InlineData("frozen, new noise")]
    public void Pictures_Unusable_AreReportedWithinThreeSeconds(string name)
        => Assert.Null(FaultOfReport(name, seed: 5, isSmall: true));

    [Theory, Trait("Category", "Long")]
    [InlineData(true)]
    [InlineData(false)]
    public void Pictures_EachKindSixtySeeds_AreReportedWithinThreeSeconds(bool isSmall)
    {
        (string Name, long Seed)[] flights = Kinds
            .SelectMany(k => Enumerable.Range(1, isSmall ? 60 : 3).Select(seed => (k.Name, (long)seed))).ToArray();
        var faults = new string?[flights.Length];
        Parallel.For(
            0, flights.Length, new ParallelOptions { MaxDegreeOfParallelism = Environment.ProcessorCount },
            i => faults[i] = FaultOfReport(flights[i].Name, flights[i].Seed, isSmall));
        Assert.Empty(faults.OfType<string>());
    }

    [Fact]
    public void Pictures_BlackForTenSeconds_AreHeldForAndFlownAgain()
    {
        using SearchFlight flight = Fly("black", seed: 5, isSmall: true, seconds: 10);
        FlyOn(flight);
        Assert.Contains("Searching -> Holding: health: pictures: ", flight.Log, StringComparison.Ordinal);
        Assert.Contains("% black", flight.Log, StringComparison.Ordinal);
        Assert.Equal(MissionOutcome.Accomplished, flight.Mission.Result.Outcome);
        Assert.InRange(flight.Mission.Coverage, 0.98, 1);
        Assert.InRange(flight.Imaging.Pictures.Black, 10, 30);
    }

    [Theory]
    [InlineData("black")]
    [InlineData("no attitude")]
    public void Pictures_UnusableToTheEnd_ItReturnsAndClaimsNothing(string name)
    {
        using SearchFlight flight = Fly(name, seed: 5, isSmall: true, seconds: 0);
        double seen = flight.Mission.Coverage;
        FlyOn(flight);
        Assert.Equal(MissionPhase.Done, flight.Mission.Phase);
        Assert.StartsWith("health: pictures: ", flight.Mission.Aborted, StringComparison.Ordinal);
        Assert.InRange(flight.Mission.Coverage, seen, seen + 0.1);
        Assert.Equal(MissionOutcome.Failed, flight.Mission.Result.Outcome);
    }

    [Theory]
    [InlineData(4, null)]
    [InlineData(12, "image processing")]
    public void ImageProcessing_BusyForSomeSeconds_IsNotASilentCamera(double seconds, string? reason)
    {
        var hang = new ScriptedFault
        {
            Kind = ScriptedFaultKind.ManagerHangs,
            Manager = "image processing",
            At = TimeOfSearch(seed: 5, isSmall: true) + IntoTheSearch,
            Duration = TimeSpan.FromSeconds(seconds),
        };
        using var flight = new SearchFlight(SearchFlight.SmallPlan(), World(seed: 5, isSmall: true, hang));
        FlyOn(flight);
        Assert.Equal(MissionPhase.Done, flight.Mission.Phase);
        if (reason is null)
            Assert.Null(flight.Mission.Aborted);
        else
            Assert.Contains(reason, flight.Mission.Aborted, StringComparison.Ordinal);
    }

    // Flies until the fault has begun.
    private static SearchFlight Fly(string name, long seed, bool isSmall, double seconds)
    {
        TimeSpan at = TimeOfSearch(seed, isSmall) + IntoTheSearch;
        (string _, ScriptedFaultKind kind, double value, PictureQuality _) = Kinds.Single(k => k.Name == name);
        var fault = new ScriptedFault { Kind = kind, At = at, Value = value, Duration = TimeSpan.FromSeconds(seconds) };
        var flight = new SearchFlight(SearchFlight.SmallPlan(), World(seed, isSmall, fault));
        flight.FlyUntil(f => f.Reactor.Now >= at, at);
        return flight;
    }

    private static void FlyOn(SearchFlight flight)
    {
        flight.FlyUntil(f => f.IsOver, TimeSpan.FromMinutes(10));
        flight.End();
    }

    // The same seed reaches the area at the same time, whatever goes wrong later.
    private static TimeSpan TimeOfSearch(long seed, bool isSmall)
        => TimesOfSearch.GetOrAdd((seed, isSmall), key => FlyToTheSearch(key.Seed, key.IsSmall));

    private static TimeSpan FlyToTheSearch(long seed, bool isSmall)
    {
        using var flight = new SearchFlight(SearchFlight.SmallPlan(), World(seed, isSmall));
        flight.FlyUntil(f => f.Mission.Phase == MissionPhase.Searching, TimeSpan.FromMinutes(3));
        TimeSpan time = flight.Reactor.Now;
        flight.End();
        return time;
    }

    private static SimulationOptions World(long seed, bool isSmall, params ScriptedFault[] faults)
    {
        SimulationOptions options = SearchFlight.SmallWorld(faults);
        options.Seed = seed;
        if (!isSmall)
            options.Camera = new SimulatedCameraOptions();
        return options;
    }

    private string? FaultOfReport(string name, long seed, bool isSmall)
    {
        using SearchFlight flight = Fly(name, seed, isSmall, seconds: 0);
        TimeSpan begin = flight.Reactor.Now;
        if ((flight.Health.Reasons & HealthReasons.PicturesUnusable) != 0)
            return $"{name}, seed {seed}: reported before";
        flight.FlyUntil(
            f => (f.Health.Reasons & HealthReasons.PicturesUnusable) != 0, begin + TimeSpan.FromSeconds(10));
        TimeSpan delay = flight.Reactor.Now - begin;
        string what = FormattableString.Invariant(
            $"{name}, seed {seed}: after {delay.TotalSeconds:0.0} s, {flight.Health.Text}");
        output.WriteLine(what);
        PictureQuality quality = Kinds.Single(k => k.Name == name).Quality;
        bool isRight = delay <= MaxDelay && flight.Imaging.UnusableCause == quality;
        flight.End();
        return isRight ? null : what;
    }
}
