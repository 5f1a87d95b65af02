using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Tests.Preflight;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>Missions whose heights are above ground, over terrain that is not level.</summary>
public class TerrainMissionTests(ITestOutputHelper output)
{
    // Lanes are held to 2 m, and the heights may be as much above ground as the vehicle cannot sink.
    private const double Height = 40;
    private const double ToleranceMetres = 2;

    private static readonly Func<double, double, double> Level = (_, _) => 0;

    public static TheoryData<string> Terrains => ["hill", "slope", "valley", "waves"];

    [Theory]
    [MemberData(nameof(Terrains))]
    public void Mission_OverTerrain_KeepsTheHeightAboveGround(string name)
    {
        Func<double, double, double> ground = GroundOf(name);
        using MissionRig rig = Rig(ground, MissionRig.Mission(", \"limits\": {\"maxHeightMetres\": 90}"));
        rig.Vehicle.Targets.Add((80, -30, DefaultTargetClasses.Red));
        (double least, double most) = FlySearch(rig, ground);
        output.WriteLine($"{name}: {least:0.0} to {most:0.0} m above ground, {rig.Status.Coverage:0.000} seen");
        Assert.InRange(least, Height - ToleranceMetres, Height + (2 * ToleranceMetres));
        Assert.InRange(most, Height, 65);
        Assert.InRange(rig.Status.Coverage, 0.985, 1);
        Assert.Equal(MissionOutcome.Accomplished, rig.Status.Result.Outcome);
        Assert.DoesNotContain("no progress", rig.Story, StringComparison.Ordinal);
    }

    [Fact]
    public void Mission_WithoutTerrain_FliesIntoTheHill()
    {
        Func<double, double, double> ground = GroundOf("hill");
        using MissionRig rig = Rig(ground, MissionRig.Mission(), terrain: null);
        Assert.InRange(FlySearch(rig, ground).Least, 0, 15);
    }

    [Fact]
    public void Mission_LevelTerrain_FliesAsWithoutOne()
    {
        using MissionRig with = Rig(Level, MissionRig.Mission());
        using MissionRig without = Rig(Level, MissionRig.Mission(), terrain: null);
        Assert.Equal(MissionPhase.Done, with.RunToEnd());
        Assert.Equal(MissionPhase.Done, without.RunToEnd());

        // Transits are flown from point to point, and end as they do without.
        Assert.InRange(with.Now.TotalSeconds / without.Now.TotalSeconds, 0.98, 1.02);
        Assert.Equal(without.Status.Coverage, with.Status.Coverage, 0.01);
    }

    [Fact]
    public void Mission_GroundFallsAwayBelowTheVehicle_LimitIsAboveGround()
    {
        MissionPlan mission = MissionRig.Mission(", \"limits\": {\"maxHeightMetres\": 60}");
        using MissionRig rig = Rig(Level, mission);
        rig.RunUntil(MissionPhase.Searching);
        rig.Vehicle.Height = 61;
        rig.Run(0.5);
        Assert.Equal(MissionPhase.Searching, rig.Status.Phase);
        rig.Vehicle.CanClimb = false;
        rig.Run(2);
        Assert.Contains("m above ground, above the limit of 60.0 m", rig.Story, StringComparison.Ordinal);
    }

    [Fact]
    public void Mission_GridWithoutTheArea_IsRefusedBeforeTakeOff()
    {
        TerrainGrid small = TestTerrain.Around(MissionRig.Home, Level, halfMetres: 50);
        using var rig = new MissionRig(MissionRig.Mission(), o => o.Terrain = small);
        Assert.Equal(MissionPhase.Failed, rig.RunToEnd());
        Assert.Contains("the terrain grid does not cover", rig.Story, StringComparison.Ordinal);
        Assert.False(rig.Vehicle.IsArmed);
    }

    [Fact]
    public void Change_FasterThanTheTerrainIsFollowed_IsRefused()
    {
        using MissionRig rig = Rig(GroundOf("hill"), MissionRig.Mission());
        rig.RunUntil(MissionPhase.Searching);
        OperatorRequest[] refused =
        [
            rig.Manager.ChangeSpeed(9, "test", "late"),
            rig.Manager.ChangeParameter(MissionParameter.Speed, 9, "test", "late"),
        ];
        OperatorRequest slower = rig.Manager.ChangeSpeed(5, "test", "gusts");
        rig.Run(1);
        Assert.All(refused, r => Assert.Contains(
            "the heights over the terrain are planned for 8.0 at most", r.Answer, StringComparison.Ordinal));
        Assert.Equal(OperatorOutcome.Accepted, slower.Outcome);
    }

    [Theory]
    [InlineData(OperatorCommand.SkipLane, OperatorOutcome.Accepted)]
    [InlineData(OperatorCommand.Revisit, OperatorOutcome.Refused)]
    public void Continue_LeftLow_ClimbsFirstWhateverIsCommandedThen(OperatorCommand then, OperatorOutcome expected)
    {
        Func<double, double, double> ground = (n, _) => Math.Max(0, Math.Min(30, 2 * (n - 40)));
        using MissionRig rig = Rig(ground, MissionRig.Mission());
        rig.Vehicle.Targets.Add((100, 0, DefaultTargetClasses.Red));
        rig.RunUntil(MissionPhase.InTransit);
        rig.Run(1);
        rig.Manager.Hold("test", "low");
        rig.Run(3);
        rig.Vehicle.Height = 6;
        rig.Run(1);
        rig.Manager.ContinueMission("test", "on");
        rig.Run(1);
        OperatorRequest next = then == OperatorCommand.SkipLane
            ? rig.Manager.SkipLane("test", "next")
            : rig.Manager.RevisitPlace(Corners((100, 0)).Single(), "test", "look");
        int from = rig.Vehicle.Path.Count;
        rig.Run(60);
        Assert.Equal(expected, next.Outcome);
        double least = rig.Vehicle.Path.Skip(from).Where(p => p.North > 35)
            .Min(p => p.Height - ground(p.North, p.East));
        Assert.InRange(least, Height - ToleranceMetres, 80);
    }

    // The heading of a vehicle is never still.
    [Fact]
    public void Continue_LeftLow_CommandsTheClimbOnce()
    {
        using MissionRig rig = Rig(Level, MissionRig.Mission());
        rig.RunUntil(MissionPhase.InTransit);
        rig.Manager.Hold("test", "low");
        rig.Run(3);
        rig.Vehicle.Height = 6;
        double jitter = 0;
        rig.Vehicle.More = (ref VehicleState s)
            => s.Attitude = EulerAngles.FromRadians(0, 0, jitter = 0.001 - jitter);
        rig.Run(1);
        int before = GoTos(rig);
        rig.Manager.ContinueMission("test", "on");
        rig.Run(5);
        Assert.InRange(rig.Vehicle.Height, 7, Height - 5);
        Assert.Equal(1, GoTos(rig) - before);
    }

    [Theory]
    [InlineData(15, 0.06, 43)]
    [InlineData(8, 0.10, 44)]
    [InlineData(8, 0.10, 48)]
    [InlineData(5, 0.05, 44)]
    public void Mission_OnASlope_IsRefusedOrEndsWithoutExceedingItsLimit(double speed, double slope, double limit)
    {
        MissionPlan mission = MissionRig.Mission(
            FormattableString.Invariant($", \"limits\": {{\"maxHeightMetres\": {limit}}}")).WithSpeed(speed);
        using MissionRig rig = Rig((n, _) => slope * n, mission);
        MissionPhase end = rig.RunToEnd();
        output.WriteLine(rig.Status.Text);
        Assert.DoesNotContain("above the limit", rig.Story, StringComparison.Ordinal);
        Assert.Equal(end == MissionPhase.Failed, rig.Story.Contains("over the terrain the vehicle is up to"));
    }

    [Fact]
    public void Mission_RevisitAboveTheLimit_IsRefused()
    {
        MissionPlan mission = MissionRig.Mission(
            ", \"revisit\": {\"heightMetres\": 60}, \"limits\": {\"maxHeightMetres\": 62}");
        using MissionRig rig = Rig((n, e) => n is > 90 and < 110 && Math.Abs(e) < 10 ? -12 : 0, mission);
        Assert.Equal(MissionPhase.Failed, rig.RunToEnd());
        Assert.Contains("over the terrain the vehicle is up to 72", rig.Story, StringComparison.Ordinal);
    }

    [Fact]
    public void Mission_PitThatIsAKeepOut_IsFlownAround()
    {
        string corners = string.Join(",", Corners((75, -35), (75, 35), (125, 35), (125, -35)).Select(
            p => FormattableString.Invariant($"[{p.Latitude.Degrees:R},{p.Longitude.Degrees:R}]")));
        using MissionRig rig = Rig(
            (n, e) => n is > 90 and < 110 && Math.Abs(e) < 20 ? -60 : 0,
            MissionRig.Mission($", \"keepOuts\": [[{corners}]], \"limits\": {{\"maxHeightMetres\": 90}}"));
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal(MissionOutcome.Accomplished, rig.Status.Result.Outcome);
    }

    [Fact]
    public void Change_SpacingPlannedAtALowerSpeed_IsNotFlownFaster()
    {
        using MissionRig rig = Rig(GroundOf("slope"), MissionRig.Mission());
        rig.RunUntil(MissionPhase.Searching);
        rig.Manager.ChangeSpeed(4, "test", "gusts");
        rig.Run(1);
        rig.Manager.ChangeParameter(MissionParameter.LaneSpacing, 25, "test", "closer");
        rig.Run(3);
        rig.Manager.ChangeSpeed(8, "test", "calm");
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Contains("the lane spacing stays as it is: speedMetresPerSecond is 8.0", rig.Story);
        OperatorRequest height = rig.Manager.ChangeParameter(MissionParameter.Height, 41, "test", "late");
        rig.Run(1);
        Assert.DoesNotContain("planned for", height.Answer);
    }

    [Fact]
    public void Offer_AreaWithAHillAboveTheReturn_IsRefused()
    {
        Func<double, double, double> ground = (n, e) => n > 200 ? Math.Min(60, n - 200) : 0;
        using MissionRig rig = Rig(ground, MissionRig.Mission());
        rig.RunUntil(MissionPhase.Searching);
        rig.Manager.Flight!.Energy.Parameters = PreflightCases.Parameters(
            MavAutopilot.Ardupilotmega, ("RTL_ALT_M", 40));
        OperatorRequest offer = rig.Manager.OfferArea(
            [.. Corners((160, -60), (160, 60), (280, 60), (280, -60))], [], "test", "over the hill");
        rig.Run(3);
        Assert.Contains("above home; the autopilot returns at 40.0 m, which must be 10.0 m higher", offer.Answer);
    }

    [Fact]
    public void Plan_OverAHill_TakesMoreOfTheBattery()
    {
        double level = Energy(Level);
        double waves = Energy(GroundOf("waves"));
        output.WriteLine($"{waves / level:0.0000} of the energy over level ground");
        Assert.InRange(waves / level, 1.003, 1.1);
        Assert.Equal(Energy(null), level, 1e-9);
    }

    [Fact]
    public void Options_TerrainAndFixedWing_AreRefused()
    {
        var options = new MissionControlOptions
        {
            Mission = MissionRig.Mission(),
            Terrain = TestTerrain.Around(MissionRig.Home, Level),
            FixedWing = new FixedWingOptions(),
        };
        ArgumentException e = Assert.Throws<ArgumentException>(() => new MissionControlManager(options));
        Assert.Contains("Terrain is given, which a fixed wing (FixedWing) does not follow", e.Message);
    }

    private static IEnumerable<GeodeticPosition> Corners(params (double North, double East)[] places)
        => places.Select(p => LocalNedFrame.IgnoringGeoid(MissionRig.Home).ToGeodetic(
            new NedPosition(p.North, p.East, 0)));

    private static double Energy(Func<double, double, double>? ground)
    {
        FlightPlan plan = FlightPlan.Create(
            MissionRig.Mission(), MissionRig.Home, out string fault,
            terrain: ground is null ? null : TestTerrain.Around(MissionRig.Home, ground))!;
        Assert.Empty(fault);
        return PlanEnergy.Of(
            new PowerModel(new EnergyOptions()), new SearchRoute(plan, 30), plan, MissionRig.Mission(), wind: 3,
            returnSpeed: 8, maxAirspeed: 15, returnStartSeconds: 3).Joules;
    }

    private static MissionRig Rig(
        Func<double, double, double> ground, MissionPlan mission)
        => Rig(ground, mission, TestTerrain.Around(MissionRig.Home, ground, postMetres: 5, halfMetres: 400));

    private static MissionRig Rig(Func<double, double, double> ground, MissionPlan mission, TerrainGrid? terrain)
    {
        var rig = new MissionRig(mission, o => o.Terrain = terrain);
        rig.Vehicle.Ground = ground;
        return rig;
    }

    // The heights above ground before the return, which the autopilot flies level, and after the climb.
    private static (double Least, double Most) FlySearch(MissionRig rig, Func<double, double, double> ground)
    {
        Assert.Equal(MissionPhase.Returning, rig.RunUntil(MissionPhase.Returning));
        List<double> heights = [.. rig.Vehicle.Path.Where(p => p.North > 40)
            .Select(p => p.Height - ground(p.North, p.East))];
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        return (heights.Min(), heights.Max());
    }

    private static Func<double, double, double> GroundOf(string name) => name switch
    {
        "hill" => (n, e) => 45 * Math.Exp(-(((n - 105) * (n - 105)) + (e * e)) / (2 * 70 * 70)) - Centre(45, 70),
        "slope" => (n, _) => 0.1 * n,
        "valley" => (n, _) => -0.15 * Math.Max(0, Math.Min(150, n)),
        _ => (n, e) => 6 * (Math.Sin(n / 45) + Math.Sin(e / 60)),
    };

    // Of the hill at home, so that the ground there is at 0.
    private static int GoTos(MissionRig rig) => rig.Story.Split([": go to"], StringSplitOptions.None).Length - 1;

    private static double Centre(double height, double width) => height * Math.Exp(-105.0 * 105 / (2 * width * width));
}
