using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.MissionControl;

namespace Rabit.Uav.Simulation.Tests.Energy;

/// <summary>A flight of the energy trial: a search that is longer than the battery lasts, drawn by a seed.</summary>
internal sealed record EnergyCase(long Seed, SimulatedAutopilot Model)
{
    private static readonly GeodeticPosition Home = GeodeticPosition.FromDegrees(47.3971, 8.5445, 488);

    /// <summary>Of the middle of the area from home, metres.</summary>
    public double Distance { get; init; }

    /// <summary>Of the area from home.</summary>
    public Angle Direction { get; init; }

    public double SideMetres { get; init; } = 400;

    /// <summary>Speed of the search, m/s.</summary>
    public double Speed { get; init; }

    /// <summary>Mean wind at the start, m/s.</summary>
    public double Wind { get; init; }

    public Angle WindFrom { get; init; }

    /// <summary>When the wind rises by 5 m/s, by the clock of the run; null: never.</summary>
    public TimeSpan? RisesAt { get; init; }

    /// <summary>True capacity over the stated one.</summary>
    public double Capacity { get; init; } = 1;

    /// <summary>Charge at the start.</summary>
    public double Charge { get; init; } = 1;

    public bool AllowsPartial { get; init; } = true;

    public bool IsPrepared { get; init; } = true;

    public IReadOnlyList<ScriptedFault> Faults { get; init; } = [];

    /// <summary>
    /// Draws one: wind to 10 m/s at any time, in a third after a rise; to 5 km; 80 % of the capacity or more.
    /// </summary>
    public static EnergyCase Draw(long seed, SimulatedAutopilot model)
    {
        var random = new SimulationRandom(seed, "energy trial");
        bool rises = seed % 3 == 0;
        const double Rise = 5;
        return new EnergyCase(seed, model)
        {
            Distance = random.Uniform(300, 4700),
            Direction = Angle.FromRadians(random.Uniform(-Math.PI, Math.PI)),
            Speed = random.Uniform(8, 12),
            Wind = random.Uniform(0, rises ? 10 - Rise : 10),
            WindFrom = Angle.FromRadians(random.Uniform(-Math.PI, Math.PI)),
            RisesAt = rises ? TimeSpan.FromSeconds(random.Uniform(40, 200)) : null,
            Capacity = random.Uniform(0.8, 1),
            Charge = random.Uniform(0.7, 1),
        };
    }

    public SimulationOptions World() => new()
    {
        Autopilot = Model,
        Seed = Seed,
        TargetCount = 0,
        DistractorCount = 0,
        WindMetresPerSecond = Wind,
        WindFrom = WindFrom,
        BatteryRemaining = Charge,
        BatteryCapacityFraction = Capacity,
        IsPrepared = IsPrepared,
        Faults = RisesAt is { } at
            ? [new ScriptedFault { Kind = ScriptedFaultKind.WindTo, At = at, Value = Wind + 5 }, .. Faults]
            : Faults,
    };

    public MissionPlan Plan()
    {
        var frame = LocalNedFrame.IgnoringGeoid(Home);
        (double cos, double sin) = (Math.Cos(Direction.Radians), Math.Sin(Direction.Radians));
        double half = SideMetres / 2;
        var corners = new[] { (-half, -half), (half, -half), (half, half), (-half, half) };
        return new MissionPlan
        {
            Name = "energy",
            Area = corners
                .Select(c => (Along: Distance + c.Item1, Across: c.Item2))
                .Select(c => frame.ToGeodetic(
                    new NedPosition((c.Along * cos) - (c.Across * sin), (c.Along * sin) + (c.Across * cos), 0)))
                .ToImmutableArray(),
            HeightMetres = 40,
            SpeedMetresPerSecond = Speed,
            LaneSpacingMetres = 20,
            Home = new MissionHome
            {
                Latitude = Home.Latitude,
                Longitude = Home.Longitude,
                GroundAltitudeAmslMetres = Home.AltitudeAmslMetres,
            },
            AllowsPartialSearch = AllowsPartial,
        };
    }

    public override string ToString()
        => FormattableString.Invariant(
            $"seed {Seed}, {Model}: {Distance:0} m to {Direction.Degrees:0} degrees at {Speed:0.0} m/s, wind {Wind:0.0} m/s from {WindFrom.Degrees:0}, rises {RisesAt?.TotalSeconds ?? double.NaN:0} s, capacity {Capacity:0.00}, charge {Charge:0.00}");
}
